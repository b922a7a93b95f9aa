#!/usr/bin/env python3
"""Several processes of which one dies, is told to stop, or finds no memory: the run ends with a reason and an exit code,
whatever it leaves is whole, nobody stays behind, and the next run succeeds and leaves no litter.

    killed.py PROGRAM SHIM [KILLS [COMMAND...]]   kills of each command, default 3; SHIM makes allocations fail (tests/faults)

Skipped (77) where there is no mpirun or the program was built without MPI.
"""

import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "faults"))

import fault_commands
from fault_commands import Folder

SKIPPED = 77
PROCESSES = 4
BLOCK = ["--block-rows", "8"]  # so that each process has a part of a rod of 40
COMMANDS = {name: fault_commands.COMMANDS[name] + BLOCK for name in ("run", "lattice", "network", "bench", "checkpoint")}
fault_commands.COMMANDS.update(COMMANDS)  # one process, too, cuts its sums like that
LAST_WORDS = 15  # s that a launcher takes at most once its processes are gone
PATIENCE = 100  # s; some thirty times what a run takes, a third of what its caller allows


def stat_of(pid):
    """(state, parent, start) of a process; None where there is none."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return None
    return fields[0], int(fields[1]), fields[19]


def alive(pid, start):
    """Still the same process, and not one that only waits for its parent."""
    found = stat_of(pid)
    return found is not None and found[2] == start and found[0] not in "ZX"


class Together:
    """One command started by mpirun."""

    def __init__(self, folder, arguments, rank_environment=None):
        """`rank_environment` = (rank, {variable: value}): for one of the processes only."""
        program = [folder.program]
        if rank_environment:
            rank, variables = rank_environment
            words = " ".join(f"{name}='{value}'" for name, value in variables.items())
            program = ["sh", "-c", f'if [ "$OMPI_COMM_WORLD_RANK" = {rank} ]; then export {words}; fi; exec "$0" "$@"',
                       folder.program]
        launcher = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-np", str(PROCESSES)]
        self.process = subprocess.Popen(
            launcher + program + arguments, cwd=folder.path, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, env=folder.environment(OMPI_MCA_btl_base_warn_component_unused="0"))
        self.ranks = {}

    def wait_for_ranks(self):
        """Process ids by start; the launcher is their parent."""
        end = time.monotonic() + PATIENCE
        while len(self.ranks) < PROCESSES and self.process.poll() is None and time.monotonic() < end:
            for entry in os.listdir("/proc"):
                found = stat_of(entry) if entry.isdigit() else None
                if found and found[1] == self.process.pid:
                    self.ranks[int(entry)] = found[2]
            time.sleep(0.002)
        return len(self.ranks) == PROCESSES

    def ended_by(self, moment):
        try:
            self.process.wait(timeout=moment)
            return True
        except subprocess.TimeoutExpired:
            return False

    def wait(self):
        """True where it ended within the time that it may take. A launcher that stays behind when all its processes are
        gone is ended: Open MPI 4.1.4 sometimes waits for itself then (in PMIx_server_finalize), which is no fault of ours."""
        end, alone_since = time.monotonic() + PATIENCE, None
        while time.monotonic() < end:
            try:
                self.out, said = self.process.communicate(timeout=1)
                self.said = said.decode(errors="replace")
                return True
            except subprocess.TimeoutExpired:
                alone = len(self.ranks) == PROCESSES and not any(alive(*rank) for rank in self.ranks.items())
                alone_since = (alone_since or time.monotonic()) if alone else None
            if alone_since and time.monotonic() - alone_since > LAST_WORDS:
                self.process.kill()
        return False

    def finish(self):
        """What is wrong about how it ended; `said` is what stood on its error output."""
        if not self.wait():
            self.process.kill()
            for pid, start in self.ranks.items():
                if alive(pid, start):
                    os.kill(pid, signal.SIGKILL)
            self.out, said = self.process.communicate()
            self.said = said.decode(errors="replace")
            return [f"it hangs: {self.said[-300:]}"]
        end = time.monotonic() + 5  # s; the launcher need not wait for those that it has killed
        while any(alive(*rank) for rank in self.ranks.items()) and time.monotonic() < end:
            time.sleep(0.01)
        return [f"process {pid} stays behind" for pid, start in self.ranks.items() if alive(pid, start)]

    def errors_said(self):
        return self.said.count("superstep: error: ")


def check_end(together, folder, disturbed, wordless=False):
    """Of a run that was disturbed at a moment at which it ran; `wordless` = who did it knows."""
    wrong = together.finish() + folder.damage()
    if disturbed and together.process.returncode == 0 and folder.missing():
        wrong.append(f"it says that all went well; missing: {folder.missing()}")
    if disturbed and together.process.returncode != 0 and not together.said.strip() and not wordless:
        wrong.append(f"exit {together.process.returncode} without a word")
    if together.errors_said() > 1:
        wrong.append(f"{together.errors_said()} messages: {together.said[-500:]}")
    return wrong


def kill_one(folder, longest, chance):
    """A process of the run, at a random moment of its life."""
    together = Together(folder, COMMANDS[folder.name])
    hit = together.wait_for_ranks() and not together.ended_by(longest * chance.random())
    if hit:
        pid = chance.choice(sorted(together.ranks))
        hit = alive(pid, together.ranks[pid])
        if hit:
            os.kill(pid, signal.SIGKILL)
    return hit, check_end(together, folder, hit)


def interrupt(folder, longest, chance):
    """What Ctrl-C does: the launcher is told, and passes it on."""
    together = Together(folder, COMMANDS[folder.name])
    hit = together.wait_for_ranks() and not together.ended_by(longest * chance.random())
    if hit:
        together.process.send_signal(signal.SIGINT)
    return hit, check_end(together, folder, hit, wordless=True)


def allocations(folder, shim, arguments, rank):
    """How many a process makes that is left in peace."""
    report = folder.path / "cache" / "counts"
    report.parent.mkdir(exist_ok=True)
    together = Together(folder, arguments, (rank, {"LD_PRELOAD": shim, "SUPERSTEP_COUNT": str(report)}))
    together.finish()
    counts = dict(line.split() for line in report.read_text().splitlines())
    return int(counts["malloc"])


def starve(folder, shim, rank, number):
    """One process finds no memory, once."""
    folder.clear()
    together = Together(folder, COMMANDS[folder.name],
                        (rank, {"LD_PRELOAD": shim, "SUPERSTEP_FAIL": f"malloc:{number}"}))
    together.wait_for_ranks()
    return check_end(together, folder, True)


def go_on(folder, what):
    """The next run over what is there: all is there after it, and nothing else."""
    together = Together(folder, COMMANDS[folder.name])
    wrong = together.finish()
    if together.process.returncode != 0:
        wrong.append(f"exit {together.process.returncode}: {together.said[-500:]}")
    wrong += [f"{file} is left" for file in folder.litter()]
    wrong += [f"{file} is missing" for file in folder.missing()] + folder.damage()
    return [f"{folder.name}, after {what}: {fault}" for fault in wrong]


def check_wrong_input(program, place):
    """One message and one exit code however many there are to say it."""
    folder = Folder(program, f"{place}/wrong", "run")
    (folder.path / "typo.toml").write_text((folder.path / "rod.toml").read_text().replace("t_end", "t_ent"))
    (folder.path / "cut.csv").write_text("id,capacity,source,initial,fixed\n1,1,0,0\n")
    (folder.path / "cut.toml").write_text((folder.path / "rod.toml").read_text().replace("nodes.csv", "cut.csv"))
    (folder.path / "not_toml.toml").write_text("[network\n")
    (folder.path / "closed").write_text("")
    faults = []
    for arguments, code in [(["run", "missing.toml"], 3), (["run", "typo.toml"], 3), (["run", "cut.toml"], 3),
                            (["run", "not_toml.toml"], 3), (["bench", "typo.toml"], 3), (["info", "cut.toml"], 3),
                            (["run", "rod.toml", "--integrator", "rkc:rtol=0"], 2), (["fly"], 2),
                            (["run", "rod.toml", "--out", "closed"], 7)]:
        together = Together(folder, arguments)
        wrong = together.finish()
        if together.process.returncode != code or together.errors_said() != 1:
            wrong.append(f"exit {together.process.returncode}, {together.errors_said()} messages: {together.said[-500:]}")
        faults += [f"{' '.join(arguments)}: {fault}" for fault in wrong]
    return faults


class Faults(list):
    """Said as they come: who waits for many kills sees what goes wrong."""

    def __iadd__(self, more):
        for fault in more:
            print(fault, flush=True)
        return super().__iadd__(more)


def main():
    program, shim = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    kills = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    if shutil.which("mpirun") is None or not os.path.exists(f"{os.path.dirname(program)}/libsuperstep_mpi.so"):
        print("skipped: there is no mpirun, or the program was built without MPI")
        return SKIPPED
    faults, hits = Faults(), {"killed": 0, "interrupted": 0, "starved": 0}
    with tempfile.TemporaryDirectory(prefix="superstep-") as place:
        faults += check_wrong_input(program, place)
        for name in sys.argv[4:] or COMMANDS:
            command = COMMANDS[name]
            folder = Folder(program, f"{place}/{name}", name)
            folder.clear()
            began = time.monotonic()
            faults += go_on(folder, "nothing at all")
            longest = time.monotonic() - began
            for seed in range(kills):
                chance = random.Random(f"{name} {seed}")
                for how, disturb in (("killed", kill_one), ("interrupted", interrupt)):
                    if seed % 2 == 0:  # over an empty folder, and over the results of an earlier run
                        folder.clear()
                    hit, wrong = disturb(folder, longest, chance)
                    hits[how] += hit
                    faults += [f"{name}, {how}, seed {seed}: {fault}" for fault in wrong]
                if seed % 10 == 9 or seed + 1 == kills:
                    faults += go_on(folder, f"seed {seed}")
            if os.path.exists(shim):  # none beside sanitizers
                for rank in (0, PROCESSES - 1):
                    # Of the launcher's own world. A command that ends well: after a failure the launcher may
                    # end a process before it has reported.
                    least = allocations(folder, shim, ["list"], rank)
                    most = allocations(folder, shim, command, rank)
                    for k in range(kills):
                        number = least + round((most - least) * (k + 0.5) / kills)
                        wrong = starve(folder, shim, rank, number)
                        hits["starved"] += 1
                        faults += [f"{name}, process {rank}, malloc {number}: {fault}" for fault in wrong]
                faults += go_on(folder, "starving")
    print(", ".join(f"{count} {how}" for how, count in hits.items()) + f", {len(faults)} faults")
    return 1 if faults or hits["killed"] == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
