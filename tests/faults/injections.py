#!/usr/bin/env python3
"""Lets the n-th open, write, rename, fsync or allocation of a command fail, for every n.

    injections.py PROGRAM SHIM [MOST]    at most MOST numbers of each kind of call and command, spread evenly; 0 = all

The program must not die of it: its exit code says what was wrong, what it leaves is whole, and when it says that
all went well, all is there.
"""

import pathlib
import sys
import tempfile

from fault_commands import COMMANDS, Folder

KINDS = ["open", "write", "rename", "fsync", "malloc"]
ALLOWED = {0, 1, 3, 4, 6, 7}  # a message that nobody can hear changes nothing


def numbers(count, most):
    if most == 0 or count <= most:
        return range(1, count + 1)
    return sorted({1 + round(k * (count - 1) / (most - 1)) for k in range(most)})


def counts(folder, shim):
    folder.clear()
    report = folder.path / "cache" / "counts"
    report.parent.mkdir(exist_ok=True)
    folder.call(COMMANDS[folder.name], check=True, LD_PRELOAD=shim, SUPERSTEP_COUNT=str(report))
    return {line.split()[0]: int(line.split()[1]) for line in report.read_text().splitlines()}


def faults_of(folder, shim, wish):
    folder.clear()
    done = folder.call(COMMANDS[folder.name], LD_PRELOAD=shim, SUPERSTEP_FAIL=wish)
    faults = folder.damage() + [f"{file} is left" for file in folder.litter()]
    if done.returncode not in ALLOWED:
        faults.append(f"exit code {done.returncode}: {done.stderr.decode(errors='replace')[-300:]}")
    if done.returncode == 1 and not wish.startswith("malloc"):
        faults.append(f"an internal error: {done.stderr.decode(errors='replace')[-300:]}")
    if done.returncode == 0:
        faults += [f"{file} is missing, and all went well" for file in folder.missing()]
    return [f"{folder.name}, {wish}: {fault}" for fault in faults]


def main():
    program, shim = sys.argv[1], str(pathlib.Path(sys.argv[2]).resolve())
    most = int(sys.argv[3]) if len(sys.argv) > 3 else 4
    faults, runs = [], 0
    with tempfile.TemporaryDirectory(prefix="superstep-") as place:
        for name in COMMANDS:
            folder = Folder(program, f"{place}/{name}", name)
            for kind, count in counts(folder, shim).items():
                for n in numbers(count, most):
                    for wish in [f"{kind}:{n}", f"{kind}:{n}+"] if kind != "malloc" else [f"{kind}:{n}"]:
                        faults += faults_of(folder, shim, wish)
                        runs += 1
    print(f"{runs} faults injected, {len(faults)} of them dealt with wrongly")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
