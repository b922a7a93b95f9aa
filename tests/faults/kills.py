#!/usr/bin/env python3
"""Kills commands at random moments: whatever is there is whole, and the next run succeeds and leaves no litter.

    kills.py PROGRAM [KILLS]     kills of each command, default 5
"""

import random
import subprocess
import sys
import tempfile
import time

from fault_commands import COMMANDS, Folder


def kill_once(folder, longest, seed):
    process = subprocess.Popen([folder.program, *COMMANDS[folder.name]], cwd=folder.path,
                               env=folder.environment(), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    try:
        process.wait(timeout=longest * random.Random(seed).random())
        return False
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
        return True


def main():
    program, kills = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 5
    faults, hit = [], 0
    with tempfile.TemporaryDirectory(prefix="superstep-") as place:
        for name in COMMANDS:
            folder = Folder(program, f"{place}/{name}", name)
            folder.clear()
            began = time.monotonic()
            folder.call(COMMANDS[name], check=True)
            longest = time.monotonic() - began
            for seed in range(kills):
                if seed % 2 == 0:  # over an empty folder, and over the results of an earlier run
                    folder.clear()
                hit += kill_once(folder, 1.05 * longest, f"{name} {seed}")
                faults += [f"{name}, kill {seed}: {what}" for what in folder.damage()]
                if seed % 10 != 9 and seed + 1 < kills:
                    continue
                done = folder.call(COMMANDS[name])
                if done.returncode != 0:
                    faults.append(f"{name}, after kill {seed}: {done.returncode}: {done.stderr.decode()}")
                faults += [f"{name}, after kill {seed}: {file} is left" for file in folder.litter()]
                faults += [f"{name}, after kill {seed}: {file} is missing" for file in folder.missing()]
                faults += [f"{name}, after kill {seed}: {what}" for what in folder.damage()]
    print(f"{hit} processes killed, {len(faults)} faults")
    print("\n".join(faults))
    return 1 if faults or hit == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
