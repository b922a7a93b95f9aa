"""The commands that are killed and made to fail, each in a folder of its own, and what may be left of them."""

import json
import os
import pathlib
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tests/parallel"))

import scenes

PRESS = (SOURCE / "tests/support/small_press.toml").read_text()


def nodes_and_edges(nodes):
    rows = [f"{k},1,0,0,{0 if k == 1 else 10 if k == nodes else ''}" for k in range(1, nodes + 1)]
    return ("id,capacity,source,initial,fixed\n" + "\n".join(rows) + "\n",
            "i,j,conductance\n" + "".join(f"{k},{k + 1},1\n" for k in range(1, nodes)))


COMMANDS = {
    "run": ["run", "rod.toml", "--out", "out", "--integrator", "rkc", "--integrator", "cvode"],
    # Of several processes nobody has the whole of these, and all write final.csv.
    "lattice": ["run", "lattice.toml", "--out", "out", "--integrator", "rkc"],
    "network": ["run", "network.toml", "--out", "out", "--integrator", "rkc"],
    "bench": ["bench", "rod.toml", "--out", "out", "--repetitions", "1"],
    "report": ["report", "measured"],
    "pack": ["pack", "--container", "box", "--width", "2", "--depth", "2", "--height", "2", "--sizes",
             "uniform:min=0.3,max=0.4", "--relative-density", "0.5", "-o", "out/packing.csv"],
    "checkpoint": ["run", "press.toml", "--checkpoint", "0.001", "--vtk", "--out", "out"],
}
# What is the same in every run of the command, byte for byte.
CONSTANT = {"packing.csv", "final.csv", "probes.csv", "history.csv", "checkpoint.bin"}


class Folder:
    """Inputs of all commands, the outputs of one, and what they are when nothing goes wrong."""

    def __init__(self, program, path, name):
        self.program, self.path, self.name = str(pathlib.Path(program).resolve()), pathlib.Path(path), name
        self.path.mkdir(parents=True)
        nodes, edges = nodes_and_edges(40)
        (self.path / "nodes.csv").write_text(nodes)
        (self.path / "edges.csv").write_text(edges)
        (self.path / "rod.toml").write_text(
            't_end = 300.0\noutput_times = [30.0, 100.0, 300.0]\nprobe = 20\n[network]\nnodes = "nodes.csv"\n'
            'edges = "edges.csv"\n[bench]\nbaseline = "forward-euler"\nintegrators = ["rkc", "cvode"]\n')
        (self.path / "network.toml").write_text(
            't_end = 300.0\noutput_times = [300.0]\nprobe = 20\n[network]\nnodes = "nodes.csv"\nedges = "edges.csv"\n'
            'order = "file"\n')
        (self.path / "press.toml").write_text(PRESS)
        (self.path / "lattice.toml").write_text(scenes.heated_lattice([4, 4, 9], t_end=2.0, early=0.5))
        if name == "report":
            self.call(["bench", "rod.toml", "--out", "measured", "--repetitions", "1"], check=True)
        self.inputs = self.files()
        self.call(COMMANDS[name], check=True)
        self.right = {file: (self.path / file).read_bytes() for file in self.files() if file not in self.inputs}

    def environment(self, **more):
        return dict(os.environ, SUPERSTEP_CACHE=str(self.path / "cache"), OPENBLAS_NUM_THREADS="1",
                    OMP_NUM_THREADS="1", **more)

    def files(self):
        return {str(file.relative_to(self.path)) for file in self.path.rglob("*")
                if file.is_file() and "cache" not in file.relative_to(self.path).parts}

    def call(self, arguments, check=False, **more):
        done = subprocess.run([self.program, *arguments], cwd=self.path, env=self.environment(**more),
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=300)
        if check and done.returncode != 0:
            raise SystemExit(f"{arguments}: {done.returncode}: {done.stderr.decode()}")
        return done

    def clear(self):
        """As before the command."""
        for file in self.files() - self.inputs:
            (self.path / file).unlink()
        shutil.rmtree(self.path / "cache", ignore_errors=True)

    def litter(self):
        return [file for file in self.files() if file.endswith(".tmp")]

    def damage(self):
        """What is wrong with the files that are there; whole ones only, and an index of what is there."""
        wrong = []
        for file in sorted(self.files() - self.inputs):
            content, path = (self.path / file).read_bytes(), pathlib.PurePath(file)
            if path.suffix == ".tmp":
                continue
            if path.name in CONSTANT and file in self.right and content != self.right[file] \
                    and self.name != "checkpoint":
                wrong.append(f"{file}: is another one")
            if not content or (path.suffix in {".csv", ".json", ".toml"} and not content.endswith(b"\n")):
                wrong.append(f"{file}: ends early")
            if path.suffix == ".json":
                try:
                    index = json.loads(content)
                except ValueError as error:
                    wrong.append(f"{file}: {error}")
                    continue
                for name in index.get("files", []) if isinstance(index, dict) else []:
                    if not (self.path / path.parent / name).exists():
                        wrong.append(f"{file}: names {name}, which is not there")
            if path.suffix in {".html", ".svg", ".vtp", ".pvd"} and not content.rstrip().endswith(b">"):
                wrong.append(f"{file}: ends early")
        return wrong

    def missing(self):
        return sorted(set(self.right) - self.files())
