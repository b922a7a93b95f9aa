#!/usr/bin/env python3
"""Runs small scenes by several processes: results are those of one process, bit by bit, and so are the counts.

    same_bits.py PROGRAM [all]     `all`: every number of processes with every number of threads

Skipped (77) where there is no mpirun or the program was built without MPI.
"""

import csv
import gzip
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile

from scenes import write_scenes

SKIPPED = 77
BLOCK = "64"  # rows: at seven processes each has two blocks or more

EXPLICIT = ["forward-euler", "sts:n=10,nu=1e-2", "sts:n=auto,rtol=1e-2", "rkc:rtol=1e-3", "rkc:order=1,rtol=1e-2",
            "rkl:rtol=1e-3", "rkg:rtol=1e-3", "tsrkc:rtol=1e-3", "rock:rtol=1e-4"]
EXPONENTIAL = ["exponential:basis=chebyshev,rtol=1e-9", "exponential:basis=lanczos,rtol=1e-6", "exponential:rtol=1e-5"]
ITERATIVE = ["cvode:linsol=pcg,rtol=1e-3", "trapezoidal:rtol=1e-2,solver=pcg"]
DIRECT = ["trapezoidal:rtol=1e-2,solver=klu", "cvode:linsol=klu,rtol=1e-3", "exprb:rtol=1e-3"]
KRYLOV = ["cvode:linsol=gmres,rtol=1e-3"]  # products with a Jacobian that changes need all of it
SOME = ["forward-euler", "rkc:rtol=1e-3", "rock:rtol=1e-4"]

# Methods of each scene whose results must be exact, and those that one process does for all.
METHODS = {
    "linear": (EXPLICIT + EXPONENTIAL + ITERATIVE + ["auto:rtol=1e-4"], DIRECT),
    "driven": (SOME + EXPONENTIAL + ITERATIVE + KRYLOV, DIRECT),
    "radiating": (EXPLICIT, DIRECT + KRYLOV),
    "kappa": (EXPLICIT, DIRECT),
    "two_way": (SOME, DIRECT + KRYLOV),
    "one_way": (["sts:n=10,nu=1e-2", "rkc:rtol=1e-3", "exponential:rtol=1e-4"], DIRECT),
    "electrodes": (["rkc:rtol=1e-3", "exponential:rtol=1e-4"], []),
    "steady_potential": (SOME + EXPONENTIAL, DIRECT),
    "moving_potential": ([], ["rkc:rtol=1e-3"]),
    "lattice": (EXPLICIT + EXPONENTIAL + ITERATIVE, []),
    "lattice_radiating": (EXPLICIT, []),
    "lattice_varying": (SOME, DIRECT),  # one process reads it for all
    "bed": (SOME + ["sts:n=10,nu=1e-2", "exponential:rtol=1e-5", "cvode:linsol=pcg,rtol=1e-3"], []),
    "bed_radiating": (SOME, []),
    "bed_driven": (SOME, []),
    "bed_kappa": (SOME, []),
    "web": (EXPLICIT + EXPONENTIAL + ITERATIVE + ["auto:rtol=1e-4"], []),
    "web_potential": (SOME, []),
    "web_listed": (SOME, DIRECT),
    "web_algebraic": (SOME, DIRECT),
    "hub": (EXPLICIT + EXPONENTIAL + ITERATIVE, DIRECT),
}
COUNTS = ["steps", "rejected", "rhs", "jacobians", "factorizations", "solves", "max_stages"]


class Runner:
    def __init__(self, program, folder):
        self.program, self.folder, self.faults, self.compared = program, folder, [], 0

    def call(self, processes, arguments):
        """One process is one without a launcher: nobody starts one process by mpirun to get an answer."""
        launcher = []
        if processes > 1:
            launcher = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-np", str(processes)]
        environment = dict(os.environ, OMPI_MCA_btl_base_warn_component_unused="0",
                           ASAN_OPTIONS="detect_leaks=0:" + os.environ.get("ASAN_OPTIONS", ""))
        return subprocess.run(launcher + [self.program] + arguments, cwd=self.folder, env=environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300)

    def run(self, scene, specs, processes, threads=1, block=BLOCK):
        """What came out for each SPEC: hashes of its files, its counts, and how it was done."""
        out = f"{self.folder}/out"
        shutil.rmtree(out, ignore_errors=True)
        arguments = ["run", f"{scene}.toml", "--out", out, "--threads", str(threads), "--block-rows", block]
        for spec in specs:
            arguments += ["--integrator", spec]
        done = self.call(processes, arguments)
        if done.returncode != 0:
            self.faults.append(f"{scene}, {processes} processes: exit {done.returncode}: {done.stderr.decode()[:600]}")
            return {}
        lines = [line for line in done.stdout.decode().splitlines() if line and not line.startswith(" ")]
        if len(lines) != len(specs):
            self.faults.append(f"{scene}, {processes} processes: {len(lines)} lines for {len(specs)} runs")
        found = {}
        folders = [out] if len(specs) == 1 else [f"{out}/{name}" for name in sorted(os.listdir(out))]
        for folder in folders:
            if not os.path.exists(f"{folder}/run.json"):
                continue
            with open(f"{folder}/run.json") as file:
                record = json.load(file)
            hashes = [hashlib.sha256(open(f"{folder}/{name}", "rb").read()).hexdigest()
                      for name in ("final.csv", "probes.csv")]
            counts = [record["counts"][name] for name in COUNTS] + [record[name] for name in ("nodes", "contacts")]
            found[f"{record['integrator']}:{record['params']}"] = (hashes, counts, record)
        if len(found) != len(specs):
            self.faults.append(f"{scene}, {processes} processes: {len(found)} results for {len(specs)} runs")
        return found

    def compare(self, scene, processes, threads=1, block=BLOCK):
        exact, gathered = METHODS[scene]
        if not hasattr(self, "alone"):
            self.alone = {}
        key = (scene, block)
        if key not in self.alone:
            self.alone[key] = self.run(scene, exact + gathered, 1, 1, block)
        together = self.run(scene, exact + gathered, processes, threads, block)
        for spec, (hashes, counts, record) in together.items():
            if spec not in self.alone[key]:
                continue
            self.compared += 1
            what = f"{scene}, {spec}, {processes} processes, {threads} threads, blocks of {block}"
            expected = self.alone[key][spec]
            if hashes != expected[0]:
                self.faults.append(f"{what}: another result")
            if counts != expected[1]:
                self.faults.append(f"{what}: counts {counts} instead of {expected[1]}")
            how = "gathered" if any(spec.rstrip(":") == g for g in gathered) else "exact"
            if record["distributed"] != how:
                self.faults.append(f"{what}: {record['distributed']} instead of {how}")
            if record["processes"] != (processes if how == "exact" else 1):
                self.faults.append(f"{what}: it says that {record['processes']} processes took part")


def check_errors(runner):
    """One message, one exit code, however many processes there are."""
    for arguments, code in [(["run", "missing.toml"], 3), (["run", "linear.toml", "--integrator", "rkk"], 2),
                            (["run", "linear.toml", "--threads", "0"], 2)]:
        done = runner.call(3, arguments)
        said = done.stderr.decode().count("superstep: error: ")
        if done.returncode != code or said != 1:
            runner.faults.append(f"{arguments}: exit {done.returncode}, {said} messages: {done.stderr.decode()[-500:]}")
    unstable = ["run", "linear.toml", "--integrator", "forward-euler:step=0.5", "--out", f"{runner.folder}/unstable",
                "--block-rows", BLOCK]
    alone, together = runner.call(1, unstable), runner.call(3, unstable)
    if together.returncode != 4 or alone.stdout != together.stdout:
        runner.faults.append(f"unstable: exit {together.returncode}: {together.stdout} instead of {alone.stdout}")


def check_layers(runner):
    """A lattice that processes build together: nobody has the whole of it, and what needs that says so."""
    for arguments, code, said in [
            (["--integrator", "trapezoidal:rtol=1e-2,solver=klu"], 4, "nobody has the whole"),
            (["--verify", "--integrator", "rkc:rtol=1e-2"], 0, "rms of"),
            (["--vtk", "--integrator", "rkc:rtol=1e-2"], 0, "ok")]:
        done = runner.call(3, ["run", "lattice.toml", "--out", f"{runner.folder}/layers", "--block-rows", BLOCK] + arguments)
        if done.returncode != code or said not in done.stdout.decode():
            runner.faults.append(f"lattice {arguments}: exit {done.returncode}: {done.stdout.decode()[-300:]} "
                                 f"{done.stderr.decode()[-300:]}")
    for wrong, said in [("where = \"top\"", "where = { box = { min = [0, 0, 70], max = [9, 9, 90] } }"),
                        ("where = \"top\"", "where = { ids = [1200] }"), ("where = \"top\"", "where = { ids = [1] }"),
                        ("spacing", "spacin"), ("initial = 300.0", "initial = 300.0\nradiance = 1")]:
        with open(f"{runner.folder}/lattice.toml") as file:
            text = file.read().replace(wrong, said)
        with open(f"{runner.folder}/lattice_wrong.toml", "w") as file:
            file.write(text)
        alone, together = (runner.call(processes, ["run", "lattice_wrong.toml"]) for processes in (1, 3))
        if together.returncode != 3 or alone.stderr not in together.stderr or \
                together.stderr.decode().count("superstep: error: ") != 1:
            runner.faults.append(f"lattice with {said}: exit {together.returncode}: {together.stderr.decode()[-300:]} "
                                 f"instead of {alone.stderr.decode()[-300:]}")


def check_wrong(runner, name, texts):
    """What one process says of files, several say: once, with the line. The last of the files is the case."""
    for file_name, text in texts.items():
        with open(f"{runner.folder}/{file_name}", "w") as file:
            file.write(text)
    alone, together = (runner.call(processes, ["run", list(texts)[-1]]) for processes in (1, 3))
    runner.compared += 1
    if (alone.returncode, together.returncode) != (3, 3) or alone.stderr not in together.stderr or \
            together.stderr.decode().count("superstep: error: ") != 1:
        runner.faults.append(f"{name}: exit {alone.returncode} and {together.returncode}: "
                             f"{together.stderr.decode()[-300:]} instead of {alone.stderr.decode()[-300:]}")


def check_parts_of_networks(runner):
    """The same of tables of nodes and of edges."""
    texts = []
    for name in ("web_nodes.csv", "web_edges.csv", "web.toml"):
        with open(f"{runner.folder}/{name}") as file:
            texts.append(file.read())
    nodes, edges, case = texts
    node, edge = nodes.rstrip().splitlines()[-1], edges.rstrip().splitlines()[-2]
    capacity, name, initial, fixed, source = node.split(";")
    i, j, conductance = edge.split(",")
    middle = edges.splitlines(keepends=True)[len(edges.splitlines()) // 2]
    for what, wrong in {
            "an id": nodes + node + "\n", "a number": nodes.replace(f";{name};{initial}", f";{name};2O"),
            "a capacity": nodes.replace(f"{capacity};{name}", f"-1;{name}"), "a row": nodes + "1;2\n",
            "a column": nodes.replace("initial", "begin"), "no rows": "".join(nodes.splitlines(keepends=True)[:2]),
            "an empty file": "",
            "far too large": nodes.replace(f"{capacity};{name}", f"1e300;{name}"), "an id that is none": nodes.replace(name, "x"),
            "a fixed value": nodes.replace(f";{fixed};{source}", f";{fixed}K;{source}")}.items():
        check_wrong(runner, f"nodes with {what}", {"wrong_nodes.csv": wrong, "wrong_edges.csv": edges, "wrong_web.toml":
                    case.replace("web_", "wrong_")})
    all_fixed = "id,capacity,source,initial,fixed\n-885,1,0,0,5\n2025,1,0,0,5\n"
    for what, ends in {"all fixed": "-885,2025", "all fixed and an unknown end": "-885,2026"}.items():
        check_wrong(runner, f"nodes {what}", {"wrong_nodes.csv": all_fixed, "wrong_edges.csv": f"i,j,conductance\n{ends},1\n",
                                              "wrong_web.toml": case.replace("web_", "wrong_")})
    for what, wrong in {
            "an unknown end": edges + "1,-885,1\n", "another one": edges.replace(middle, middle.replace(",", "1,", 1)),
            "a loop": edges + f"{i},{i},1\n", "a negative one": edges.replace(conductance, "-1"), "a word": edges + f"{i},{j},large\n",
            "no column": edges.replace("conductance", "k"), "a column more": edges.replace("conductance", "conductance,k"),
            "a small one": edges.replace(conductance, "1e-200"), "an empty file": "", "a NUL": edges + "# \0\n"}.items():
        check_wrong(runner, f"edges with {what}", {"wrong_nodes.csv": nodes, "wrong_edges.csv": wrong, "wrong_web.toml":
                    case.replace("web_", "wrong_")})
    for what, wrong in {"a word": case.replace('"file"', '"files"'), "a probe": case.replace("2025", "2026"), "a height": case.replace("2025", '"mid-height"'),
                        "a key": case + "capacity = 1\n", "a table": case + "[thermal]\n", "a file": case.replace("web_edges", "no_edges"),
                        "a field": case + 'field = "pressure"\n', "no end": case.replace("t_end", "end")}.items():
        check_wrong(runner, f"web with {what}", {"wrong_web.toml": wrong})
    with gzip.open(f"{runner.folder}/web_edges.csv.gz", "wt") as file:
        file.write(edges)
    for what, other, why in [("packed", case.replace("edges.csv", "edges.csv.gz"), "of web_edges.csv.gz, it is packed"),
                             ("of a list", case + "fixed = [ { ids = [-250], value = 1.0 } ]\n", "[network] has fixed"),
                             ("algebraic", case.replace("web_nodes", "web_algebraic_nodes"), "nodes of capacity 0")]:
        with open(f"{runner.folder}/other_web.toml", "w") as file:
            file.write(other)
        said = runner.call(3, ["run", "other_web.toml", "--out", f"{runner.folder}/said"]).stderr.decode()
        runner.compared += 1
        if said.count(f"other_web.toml: process 1 of 3 reads the scene for all: {why}") != 1:
            runner.faults.append(f"a web that is {what}: {said}")
    refused = runner.call(3, ["run", "web.toml", "--integrator", "trapezoidal:rtol=1e-2,solver=klu", "--out", f"{runner.folder}/said"])
    if refused.returncode != 4 or "nobody has the whole" not in refused.stdout.decode():
        runner.faults.append(f"web by KLU: exit {refused.returncode}: {refused.stdout.decode()}")
    drawn = [runner.call(processes, ["run", "web.toml", "--vtk", "--out", f"{runner.folder}/said"]) for processes in (1, 3)]
    if drawn[1].returncode != 3 or drawn[0].stderr not in drawn[1].stderr:
        runner.faults.append(f"web to be drawn: exit {drawn[1].returncode}: {drawn[1].stderr.decode()}")


def check_range(runner):
    """Values that no temperature can be: of a scene in parts, of which each process sees its own, and of one with a law."""
    for scene, spec in (("bed", "sts:n=10,nu=1e-3"), ("kappa", "sts:n=10,nu=1e-3")):
        alone, together = (runner.call(processes, ["run", f"{scene}.toml", "--integrator", spec, "--out", f"{runner.folder}/said"])
                           for processes in (1, 3))
        runner.compared += 1
        if (alone.returncode, together.returncode) != (4, 4) or b"leaves the range" not in alone.stdout or \
                alone.stdout not in together.stdout:
            runner.faults.append(f"{scene} out of its range: exit {alone.returncode} and {together.returncode}: "
                                 f"{together.stdout.decode()} instead of {alone.stdout.decode()}")


def check_parts_of_files(runner):
    """A table that processes read together: what is wrong is said as one process says it, with the line; what cannot be
    read in parts gives the same bits, and the reason."""
    with open(f"{runner.folder}/bed.csv") as file:
        rows = file.read()
    with open(f"{runner.folder}/bed.toml") as file:
        case = file.read()
    first, last = [line for line in rows.splitlines() if line.startswith("-")][0], rows.rstrip().splitlines()[-1]
    name, x, y, z, size, rest = last.split("; ")
    wrong_rows = {
        "a number": rows.replace(x, "1.5e"), "a size": rows.replace(f"{z}; {size}", f"{z}; -1"),
        "an id": rows + f"{first.split('; ')[0]}; 90; 90; 90; 1; 1\n", "a centre": rows + f"99999; {x}; {y}; {z}; 1; 1\n",
        "a row": rows + "1; 2; 3\n", "a large one": rows + f"99999; {x}; {y}; {z}1; 30; 1\n",
        "nobody": "".join(rows.splitlines(keepends=True)[:3]), "no number": rows.replace(x, "nan"),
        "a header": rows.replace("diameter", "size"), "half a header": rows.replace("id; x; y; z", "id; x; y"),
        "a gap": rows.replace(f"; {z}; ", "; ; "), "a far one": rows + "99999; 1e300; 0; 0; 1; 1\n"}
    wrong_cases = {
        "another id": case.replace("5807", "5808"), "another probe": case.replace("2013", "2014"),
        "nobody there": case.replace('where = "-y"', "where = { box = { min = [50, 50, 50], max = [60, 60, 60] } }"),
        "a word": case.replace('"layers"', '"layer"'), "a key": case.replace("initial", "intial"), "a table": case.replace("[contact]", "[contakt]\\n[contact]"),
        "all fixed": case.replace('where = "-y"', 'where = "all"')}
    texts = [(name, text, case) for name, text in wrong_rows.items()] + [(name, rows, text) for name, text in wrong_cases.items()]
    for name, table, text in texts:
        check_wrong(runner, f"bed with {name}", {"wrong_bed.csv": table,
                                                 "wrong_bed.toml": text.replace("bed.csv", "wrong_bed.csv")})
    with gzip.open(f"{runner.folder}/bed.csv.gz", "wt") as file:
        file.write(rows)
    with open(f"{runner.folder}/packed_bed.toml", "w") as file:
        file.write(case.replace("bed.csv", "bed.csv.gz"))
    said = runner.call(3, ["run", "packed_bed.toml", "--out", f"{runner.folder}/said"]).stderr.decode()
    if "packed_bed.toml: process 1 of 3 reads the scene for all: it is packed" not in said:
        runner.faults.append(f"a packed bed: {said}")
    (plain, packed) = (runner.run(scene, SOME, processes) for scene, processes in (("bed", 3), ("packed_bed", 3)))
    for spec in plain:
        runner.compared += 1
        if plain[spec][:2] != packed[spec][:2]:
            runner.faults.append(f"a packed bed, {spec}: another result")
    # In another order of rows the temperatures are the same ones, to what the tolerance allows of 100 K.
    with open(f"{runner.folder}/other_bed.toml", "w") as file:
        file.write(case.replace('"layers"', '"bandwidth"'))
    values = []
    for scene in ("bed", "other_bed"):
        runner.call(1, ["run", f"{scene}.toml", "--integrator", "exponential:rtol=1e-9", "--out", f"{runner.folder}/{scene}"])
        with open(f"{runner.folder}/{scene}/final.csv") as file:
            values.append({row["id"]: float(row["temperature"]) for row in csv.DictReader(file)})
    runner.compared += 1
    if values[0].keys() != values[1].keys() or any(abs(values[0][k] - values[1][k]) > 1e-6 for k in values[0]):
        runner.faults.append("the bed in two orders: two results")


def check_counters(runner):
    """What lib/parallel says that is sent and added up, step by step, on a ring: at every cut each side wants two
    values of the other for a sweep, in one message."""
    # By method: reductions a step and a sweep, and those of the beginning and the end; messages a sweep that each side
    # of a cut sends, from and to: the stages of a chain share one for each of their vectors, as many as rows allow.
    claims = {"forward-euler": (1 / 8, 0, 20, 1, 1), "sts:n=10,nu=1e-3": (1 / 8, 0, 20, 1 / 10, 1 / 5),
              "rkc:rtol=1e-4": (3, 0, 60, 0, 1), "rock:rtol=1e-5": (5, 0, 100, 1, 1),
              "exponential:basis=chebyshev,rtol=1e-9": (0, 1.25, 0, 0, 1)}
    for processes in (2, 4, 7):
        for spec, (hashes, counts, record) in runner.run("ring", list(claims), processes).items():
            what, sweeps, sent = f"ring, {spec}, {processes} processes", record["counts"]["rhs"], record["communication"]
            a_step, a_sweep, besides, least, most = claims[spec.rstrip(":")]
            each = 2 * (processes - 1) * sweeps
            if not round(least * each) <= sent["halo_messages"] <= round(most * each) or \
                    least == 1 and sent["halo_bytes"] != 16 * each:
                runner.faults.append(f"{what}: {sent} in {sweeps} sweeps")
            if sent["reductions"] > a_step * record["counts"]["steps"] + a_sweep * sweeps + besides:
                runner.faults.append(f"{what}: {sent} in {record['counts']['steps']} steps")
            runner.compared += 1


def main():
    program = os.path.abspath(sys.argv[1])
    everything = len(sys.argv) > 2 and sys.argv[2] == "all"
    module = os.path.join(os.path.dirname(program), "libsuperstep_mpi.so")
    if shutil.which("mpirun") is None or not os.path.exists(module):
        print("skipped: there is no mpirun, or the program was built without MPI")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="superstep-") as folder:
        write_scenes(folder)
        runner = Runner(program, folder)
        for k, scene in enumerate(METHODS):
            for processes in (2, 3, 4, 7):
                for threads in (1, 2) if everything else (1 + (k + processes) % 2,):
                    runner.compare(scene, processes, threads)
        # One block for all, so that all processes but one have nothing; and fewer blocks than processes.
        for block in ("4096", "512"):
            for scene in ("linear", "hub", "web"):
                runner.compare(scene, 4, 1, block)
        check_layers(runner)
        check_parts_of_files(runner)
        check_parts_of_networks(runner)
        check_range(runner)
        check_counters(runner)
        check_errors(runner)
    print(f"{runner.compared} results compared, {len(runner.faults)} faults")
    print("\n".join(runner.faults))
    return 1 if runner.faults or runner.compared == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
