#!/usr/bin/env python3
"""Files that several processes fill together, of scenes that nobody has as a whole: they are those of one process, they
appear whole or not at all, and whoever cannot write ends all.

    shared_files.py PROGRAM SHIM     SHIM makes calls fail (tests/faults)

Skipped (77) where there is no mpirun or the program was built without MPI.
"""

import os
import pathlib
import shutil
import stat
import subprocess
import sys
import tempfile

import scenes

SKIPPED = 77
PYTHON = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable  # the one that packages are for
SPEC = ["--integrator", "forward-euler"]


class Place:
    """Cases in a folder, and what one process makes of them."""

    def __init__(self, program, shim, folder):
        self.program, self.shim, self.folder, self.faults, self.compared = program, shim, folder, [], 0
        texts = scenes.scenes()
        # Too many lines for one process to keep them.
        texts["lattice_large"] = scenes.heated_lattice([60, 50, 150], t_end=0.02, early=0.01)
        for name in ("lattice", "lattice_radiating", "lattice_large", "bed"):
            (folder / f"{name}.toml").write_text(texts[name])
        scenes.write_bed(folder / "bed.csv")

    def call(self, processes, arguments, before="", rank=None, variables=()):
        """`before`: words of a shell for every process; `variables` of one `rank` alone."""
        program = [self.program]
        if rank is not None:
            words = " ".join(f"{name}='{value}'" for name, value in variables)
            before += f'; if [ "$OMPI_COMM_WORLD_RANK" = {rank} ]; then export {words}; fi'
        if before:
            program = ["sh", "-c", before.lstrip("; ") + '; exec "$0" "$@"', self.program]
        launcher = []
        if processes > 1:
            launcher = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-np", str(processes)]
        environment = dict(os.environ, OMPI_MCA_btl_base_warn_component_unused="0", OMP_NUM_THREADS="1",
                           ASAN_OPTIONS="detect_leaks=0:" + os.environ.get("ASAN_OPTIONS", ""))
        return subprocess.run(launcher + program + arguments, cwd=self.folder, env=environment, timeout=300,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run(self, processes, scene, out, more=(), **how):
        return self.call(processes, ["run", f"{scene}.toml", "--out", out] + SPEC + list(more), **how)

    def expect(self, right, what):
        self.compared += 1
        if not right:
            self.faults.append(what)

    def litter(self):
        return [str(file) for file in self.folder.rglob(".superstep-*.tmp")]


def right_file(place, scene, blocks):
    """final.csv of one process."""
    done = place.run(1, scene, "alone", ["--block-rows", blocks])
    if done.returncode != 0:
        raise SystemExit(f"{scene}: exit {done.returncode}: {done.stderr.decode()}")
    return (place.folder / "alone/final.csv").read_bytes()


def check_bytes(place):
    """Where rows are few, some processes have none of them."""
    for scene, blocks, numbers in [("lattice", "64", (2, 3, 4, 7)), ("lattice", "4096", (2, 3, 4, 7)),
                                   ("lattice_radiating", "64", (2, 3, 4, 7)), ("lattice_large", "8192", (7,)),
                                   ("lattice_large", "1000000", (2,))]:
        right = right_file(place, scene, blocks)
        for processes in numbers:
            what = f"{scene}, {processes} processes, blocks of {blocks}"
            done = place.run(processes, scene, "out", ["--block-rows", blocks])
            place.expect(done.returncode == 0, f"{what}: exit {done.returncode}: {done.stderr.decode()[-500:]}")
            place.expect((place.folder / "out/final.csv").read_bytes() == right, f"{what}: another file")
            shutil.rmtree(place.folder / "out", ignore_errors=True)


def check_places(place):
    """Permissions, links, and what is no file."""
    right, file = right_file(place, "lattice", "64"), place.folder / "places/final.csv"
    few = ["--block-rows", "64"]
    place.run(3, "lattice", "places", few, before="umask 027")
    place.expect(stat.S_IMODE(file.stat().st_mode) == 0o640, f"a new file has mode {file.stat().st_mode:o}")
    file.chmod(0o604)
    place.run(3, "lattice", "places", few)
    place.expect(stat.S_IMODE(file.stat().st_mode) == 0o604, f"an old file has mode {file.stat().st_mode:o} now")
    place.expect(file.read_bytes() == right, "an old file is another one")
    file.unlink()
    (place.folder / "elsewhere").mkdir()
    target = place.folder / "elsewhere/values"
    file.symlink_to(target)
    place.run(3, "lattice", "places", few)
    place.expect(file.is_symlink() and target.read_bytes() == right, "a link is followed")
    file.unlink()
    file.symlink_to("/dev/stdout")
    done = place.run(3, "lattice", "places", few + ["--quiet"])
    place.expect(done.stdout == right, f"/dev/stdout got {done.stdout[:100]}")
    file.unlink()
    file.mkdir()
    done = place.run(3, "lattice", "places", few)
    place.expect(done.returncode == 7 and done.stderr.decode().count("superstep: error: ") == 1,
                 f"a folder in its place: exit {done.returncode}: {done.stderr.decode()[-500:]}")


def check_failures(place):
    """A disk that is full for one of them; the file of the run before stays."""
    few, folder = ["--block-rows", "64"], place.folder / "full"
    place.run(3, "lattice", "full", few)
    old = (folder / "final.csv").read_bytes()
    for rank, call in [(0, "pwrite:1"), (1, "pwrite:1"), (2, "pwrite:1"), (1, "fsync:1"), (0, "fsync:1"),
                       (0, "rename:1")]:
        what = f"{call} of process {rank} fails"
        done = place.run(3, "lattice", "full", few, rank=rank,
                         variables=[("LD_PRELOAD", place.shim), ("SUPERSTEP_FAIL", call)])
        said = done.stderr.decode()
        place.expect(done.returncode == 7, f"{what}: exit {done.returncode}: {said[-500:]}")
        place.expect(said.count("superstep: error: ") == 1 and "cannot be written" in said, f"{what}: {said[-500:]}")
        if call.startswith("pwrite"):
            place.expect("No space left on device" in said, f"{what}: {said[-500:]}")
        place.expect((folder / "final.csv").read_bytes() == old, f"{what}: final.csv is another one")
        place.expect(not (folder / "run.json").exists(), f"{what}: run.json speaks for a run that did not end")
        place.expect(not place.litter(), f"{what}: left {place.litter()}")
    # One that cannot open it leaves all to the root.
    done = place.run(2, "lattice", "full", few, rank=1,
                     variables=[("LD_PRELOAD", place.shim), ("SUPERSTEP_HIDE", ".superstep-")])
    place.expect(done.returncode == 0 and (folder / "final.csv").read_bytes() == old,
                 f"out of reach: exit {done.returncode}: {done.stderr.decode()[-500:]}")


def check_pieces(place):
    """Fields to draw: one process after another number of them, so that what these left must go."""
    checker = pathlib.Path(__file__).with_name("check_pieces.py")
    for scene in ("lattice", "lattice_radiating", "bed"):
        few = ["--block-rows", "64", "--vtk"]
        alone = place.run(1, scene, "drawn_alone", few)
        place.expect(alone.returncode == 0, f"{scene}: {alone.stderr.decode()[-500:]}")
        for processes, blocks in [(7, "64"), (2, "64"), (3, "64"), (4, "4096")]:
            what = f"{scene} drawn by {processes} processes, blocks of {blocks}"
            done = place.run(processes, scene, "drawn", ["--block-rows", blocks, "--vtk"])
            place.expect(done.returncode == 0, f"{what}: exit {done.returncode}: {done.stderr.decode()[-500:]}")
            # Two kinds at three instants: a piece of each process, and what joins them; and two lists.
            files = list((place.folder / "drawn/vtk").iterdir())
            place.expect(len(files) == 6 * (processes + 1) + 2, f"{what}: {len(files)} files")
            checked = subprocess.run([PYTHON, str(checker), "drawn_alone", "drawn", str(processes)], cwd=place.folder,
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            if checked.returncode == SKIPPED:
                print(f"{what}: not read, {checked.stdout.decode().strip()}")
            else:
                place.expect(checked.returncode == 0, f"{what}: {checked.stderr.decode()[-800:]}")
        done = place.run(1, scene, "drawn", few)
        files = list((place.folder / "drawn/vtk").iterdir())
        place.expect(done.returncode == 0 and len(files) == 8, f"{scene}: one process leaves {len(files)} files")


def check_failing_pieces(place):
    for rank, call in [(1, "fsync:1"), (2, "rename:1"), (1, "rename:3"), (0, "rename:3"), (0, "fsync:1")]:
        what = f"{call} of process {rank} fails while it draws"
        done = place.run(3, "lattice", "undrawn", ["--block-rows", "64", "--vtk"], rank=rank,
                         variables=[("LD_PRELOAD", place.shim), ("SUPERSTEP_FAIL", call)])
        said = done.stderr.decode()
        place.expect(done.returncode == 7, f"{what}: exit {done.returncode}: {said[-500:]}")
        place.expect(said.count("superstep: error: ") == 1 and "cannot be written" in said, f"{what}: {said[-500:]}")
        place.expect(not list((place.folder / "undrawn/vtk").glob("*.pvd")), f"{what}: there is a list")
        place.expect(not place.litter(), f"{what}: left {place.litter()}")


def main():
    program, shim = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    if shutil.which("mpirun") is None or not os.path.exists(f"{os.path.dirname(program)}/libsuperstep_mpi.so"):
        print("skipped: there is no mpirun, or the program was built without MPI")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="superstep-") as folder:
        place = Place(program, shim, pathlib.Path(folder))
        check_bytes(place)
        check_places(place)
        check_pieces(place)
        if os.path.exists(shim):  # none beside sanitizers
            check_failures(place)
            check_failing_pieces(place)
        place.expect(not place.litter(), f"left: {place.litter()}")
    print(f"{place.compared} facts compared, {len(place.faults)} faults")
    print("\n".join(place.faults))
    return 1 if place.faults else 0


if __name__ == "__main__":
    sys.exit(main())
