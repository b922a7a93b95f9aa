#!/usr/bin/env python3
"""Writes what each fuzzer begins with, made from the cases and by the programs built in BIN: seeds.py FOLDER BIN"""

import base64
import gzip
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

SOURCE = pathlib.Path(__file__).resolve().parents[2]

SPECS = ["auto", "auto:rtol=1e-6", "forward-euler:fraction=1,bound=lanczos", "sts:n=20,nu=1e-3", "sts:n=auto,rtol=1e-2",
         "rkc:rtol=1e-6", "rkl:step=0.1,stages=5", "rock", "trapezoidal", "cvode:rtol=1e-6,linsol=pcg", "exponential",
         "esdirk"]

PACKINGS = {
    "csv": "# length_unit = \"mm\"\nid,x,y,z,radius,material\n0,0,0,0,1,a\n1,1.9,0,0,1,b\n",
    "dump": "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 1\n0 1\n0 1\n"
            "ITEM: ATOMS id type x y z radius\n1 1 0 0 0 0.5\n2 1 0.9 0 0 0.5\n",
    "data": "LAMMPS data\n\n2 atoms\n1 atom types\n\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms # sphere\n\n"
            "1 1 1.0 2500 0 0 0\n2 1 1.0 2500 0.9 0 0\n",
    "yade": "#format x_y_z_r\n0 0 0 1\n1.9 0 0 1\n",
    "scaled": "ITEM: UNITS\nsi\nITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 3.5 1\n-0.25 3 0.5\n"
              "0 4 -0.25\nITEM: ATOMS id type xs ys zs Radius f_T[0]\n1 1 0.1 0 0 0.5 1\n2 1 0.9 0 0 0.5 nan\n",
    "hybrid": "t\n\n2 atoms\n1 atom types\n\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms\n\n"
              "1 1 1 1 1 2.0 2500\n2 1 2.9 1 1 2.0 2500 \n",
    "attrs": "#format x_y_z_r_attrs\n#a b\n0 0 0 1 5 6\n1.9 0 0 1 7 8\n",
    "flat": "2 0.5 0 0 9 9\n1 2 0 0 1 0 0 0\n2.9 2 0 0 1 0 0 1\n",
    "xyz": "2\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3:radius:R:1 pbc=\"T T F\"\nA 0 0 0 1\nB 1.9 0 0 1\n",
    "quoted": "\"radius\";\"Points:0\";\"Points:1\";\"Points:2\"\n1;0;0;0\n1;1.9;0;0\n",
    "bare": "0 0 0 1\n1.9 0 0 1\n",
    "legacy": "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1.9 0 0\nVERTICES 2 4\n1 0\n1 1\n"
              "POINT_DATA 2\nSCALARS radius float 1\nLOOKUP_TABLE default\n1 1\n",
    "vtp": "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"2\">"
           "<PointData><DataArray type=\"Float64\" Name=\"radius\" format=\"ascii\">1 1</DataArray></PointData><Points>"
           "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1.9 0 0</DataArray></Points></Piece>"
           "</PolyData></VTKFile>\n",
    "mercury": "2 0 0 0 0 1 1 1\n0 0 0 0 0 0 1 0 0 0 0 0 0 0\n1.9 0 0 0 0 0 1 0 0 0 0 0 0 0\n",
}

COMMAND_LINES = ["run case.toml --integrator rkc:rtol=1e-4 --tolerance 1e-3 --verify --out o --threads 2 --quiet",
                 "bench a.toml b.toml --repetitions 3 --no-cache --report --time-limit 5 --max-work 1e6",
                 "bench --corpus quick --work-precision", "pack --generator cylinder --count 100 --sizes uniform:0.8:1.2",
                 "stability case.toml --out o", "gate o --baseline b.json", "compare a b", "report o", "list --keys --json",
                 "info p.csv --length-unit mm --columns id,x,y,z,r", "init p.csv", "completion bash", "--help", "run --help"]

# What a rod of nodes is as a case: from it come the results that reports are made of.
ROD = """t_end = 10.0
output_times = [1.0, 10.0]
probe = 2
[network]
generator = "lattice"
size = 64
seed = 1
inlet = 1.0
[bench]
integrators = ["rkc", "exponential"]
"""

RESULTS = """{"schema": "superstep.results", "schema_version": 1, "version": "0", "machine": {}, "repetitions": 1,
 "threads": 1, "cases": [{"case": "rod", "baseline": "forward-euler", "rows": [{"case": "rod",
 "integrator": "forward-euler", "params": "", "status": "ok", "steps": 1, "rejected": 0, "rhs": 1, "jacobians": 0,
 "factorizations": 0, "solves": 0, "error_rms": 1e-3, "cpu_stepping_samples_s": [1.0], "yardstick_samples_s": [1.0]}]}]}
"""


def write(folder, name, content):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


def bundle(folder, first):
    """The files of a folder in one input, as input_folder.hpp takes them apart."""
    files = [path for path in sorted(folder.iterdir()) if path.is_file() and path.name != first]
    content = (folder / first).read_bytes() if (folder / first).exists() else b""
    for path in files:
        content += b"\n=== " + path.name.encode() + b"\n" + path.read_bytes()[:4000]
    return content


def write_reports(out, program):
    """What the program itself leaves in a folder of results."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "rod.toml").write_text(ROD)
        (folder / "press.toml").write_bytes((out / "case/list").read_bytes())
        for kind, line in {"bench": "bench rod.toml --repetitions 1", "run": "run rod.toml", "press": "run press.toml",
                           "study": "bench rod.toml --work-precision --repetitions 1", "lab": "stability rod.toml"}.items():
            subprocess.run([program, *line.split(), "--quiet", "--out", kind], cwd=folder, check=True,
                           stdout=subprocess.DEVNULL, env={**os.environ, "SUPERSTEP_CACHE": name + "/cache"})
            write(out / "report", kind, bundle(folder / kind, "results.json"))
        for path in (folder / "cache").rglob("*.reference"):
            write(out / "cache", path.name, path.read_bytes()[40:])  # behind its magic and its checksum
        for path in (folder / "press").glob("*.bin"):
            write(out / "checkpoint", path.name, path.read_bytes().split(b"\n", 1)[1][32:])


def vtk_in_bytes():
    """Points and radii in base64, packed by zlib and not."""
    points, radii = struct.pack("<6f", 0, 0, 0, 1.9, 0, 0), struct.pack("<2d", 1, 1)

    def packed(data):
        block = zlib.compress(data)
        head = struct.pack("<IIII", 1, len(data), 0, len(block))
        return (base64.b64encode(head) + base64.b64encode(block)).decode()

    def plain(data):
        return base64.b64encode(struct.pack("<I", len(data)) + data).decode()

    for name, head, encoded in (("vtp_zlib", ' compressor="vtkZLibDataCompressor"', packed), ("vtp_base64", "", plain)):
        yield name, (f'<?xml version="1.0"?>\n<VTKFile type="PolyData" byte_order="LittleEndian"{head}><PolyData>'
                     '<Piece NumberOfPoints="2"><PointData><DataArray type="Float64" Name="radius" format="binary">'
                     f'{encoded(radii)}</DataArray></PointData><Points><DataArray type="Float32" NumberOfComponents="3" '
                     f'format="binary">{encoded(points)}</DataArray></Points></Piece></PolyData></VTKFile>\n')


def main():
    out, binaries = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    if (binaries / "write_cases").exists():  # run.sh builds what it needs
        subprocess.run([binaries / "write_cases", out / "case"], check=True)
        if (binaries / "superstep").exists():
            write_reports(out, binaries / "superstep")
    for k, line in enumerate(COMMAND_LINES):
        write(out / "program", str(k), line.replace(" ", "\n"))
    for name, text in vtk_in_bytes():
        write(out / "packing", name, text)
    write(out / "packing", "gzip", gzip.compress(PACKINGS["dump"].encode(), mtime=0))
    write(out / "packing", "utf16", PACKINGS["csv"].encode("utf-16"))
    for case in SOURCE.glob("cases/*.toml"):
        write(out / "case", case.name, case.read_bytes())
    nodes, edges = (SOURCE / f"cases/networks/chain_{what}.csv" for what in ("nodes", "edges"))
    head = lambda path: b"".join(path.read_bytes().splitlines(keepends=True)[:8])
    write(out / "network", "chain", head(nodes) + b"---\n" + head(edges))
    write(out / "network", "small", "id,capacity,source,initial,fixed\n0,1,0,0,\n1,1,0,0,5\n---\ni,j,conductance\n0,1,2\n")
    for name, text in PACKINGS.items():
        write(out / "packing", name, text)
    write(out / "network", "matrix", "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2\n2 1 -2\n2 2 3\n---\n1\n2\n")
    for k, spec in enumerate(SPECS):
        write(out / "spec", str(k), spec)
    write(out / "results", "small", RESULTS)
    write(out / "checkpoint", "numbers", struct.pack("<QQdQ", 1, 0, 0.5, 2))
    write(out / "checkpoint", "empty", bytes(200))


if __name__ == "__main__":
    main()
