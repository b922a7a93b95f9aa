"""Small scenes of every class, for runs by several processes."""

import os

HEAD = """t_end = {t_end}
output_times = {outputs}
probe = {probe}

[packing]
file = "lattice.csv"
length_unit = "mm"

[material]
density = 7800.0

[contact]
neck = "hertz"
conductance = "series"
"""

ENDS = """fixed = [ {{ where = {{ layer = {{ side = "top", thickness = 0.9 }} }}, value = {top} }},
          {{ where = {{ layer = {{ side = "bottom", thickness = 0.9 }} }}, value = {bottom} }} ]
"""

THERMAL = """
[thermal]
conductivity = {conductivity}
specific_heat = 460.0
initial = {initial}
"""

ELECTRIC = """
[electric]
mode = "{mode}"
conductivity = {conductivity}
"""

# Every process builds its own layers of these: diagonal contacts too, where spheres are large.
LATTICE = """
t_end = {t_end}
output_times = [{early}, {t_end}]
probe = ["mid-height", 17, 1]

[packing]
generator = "lattice"
cells = {cells}
spacing = 1.0
diameter = {diameter}
length_unit = "mm"

[material]
density = 7800.0

[contact]
neck = "hertz"
"""



# Every process reads its own part of the file.
BED = """
t_end = {t_end}
output_times = [1.0, {t_end}]
probe = ["mid-height", 2013, -500]

[packing]
file = "bed.csv"
order = "layers"

[material]
density = 7800.0

[contact]
neck = "hertz"
"""


# Every process reads its own parts of two files.
WEB = """t_end = 3.0
output_times = [1.0, 3.0]
probe = [-885, 2025, -900, 3100]

[network]
nodes = "web_nodes.csv"
edges = "web_edges.csv"
order = "file"
"""


def heated_lattice(cells, t_end, early):
    """Held at 400 and 300 K; nobody of several processes has all of it."""
    return (LATTICE.format(t_end=t_end, early=early, cells=cells, diameter=1.02) +
            THERMAL.format(conductivity=50.0, initial=300.0) +
            'fixed = [ { where = "top", value = 400.0 }, { where = "bottom", value = 300.0 } ]\n')


LINE = '{ law = "linear", value = 50.0, coefficient = -1e-3, reference = 300.0 }'
SIGMOID = '{ law = "sigmoid", value = 1e4, amplitude = 1.5, steepness = 0.05, reference = 380.0 }'
RAMP = "{ times = [0.0, 1.0, 1.0, 4.0], values = [300.0, 500.0, 420.0, 300.0] }"


def write_lattice(path, across=6, high=26):
    """Rows of equal spheres that overlap a little; a second piece that touches nothing."""
    with open(path, "w") as out:
        out.write("id,x,y,z,radius\n")
        number = 0
        for piece, (width, height) in enumerate([(across, high), (3, 9)]):
            for k in range(height):
                for j in range(width):
                    for i in range(width):
                        radius = 0.505 if (i + 2 * j + 3 * k) % 5 else 0.515
                        out.write(f"{number},{i + 20 * piece},{j},{k},{radius}\n")
                        number += 1


def write_bed(path, cells=(7, 40, 6)):
    """Spheres of many sizes about the places of a lattice, so that many touch and some nobody; rows and ids in disorder,
    blank lines and comments between them, the longest side along y."""
    draw = 12345
    rows = []
    for k in range(cells[0] * cells[1] * cells[2]):
        numbers = []
        for _ in range(5):
            draw = (draw * 1103515245 + 12345) % 2**31
            numbers.append(draw / 2**31)
        x, y, z = k % cells[0], k // cells[0] % cells[1], k // (cells[0] * cells[1])
        centre = [where + 0.3 * (number - 0.5) for where, number in zip((x, y, z), numbers)]
        rows.append((numbers[4], 7 * k - 500, centre, 0.35 + 0.25 * numbers[3]))
    with open(path, "w") as out:
        out.write('# a bed\n# length_unit = "mm"\nid; x; y; z; diameter; colour\n')
        for number, (draw, name, centre, radius) in enumerate(sorted(rows)):
            out.write(f"{name}; {centre[0]!r}; {centre[1]!r}; {centre[2]!r}; {2 * radius!r}; {'nan' if number % 9 else 3}\n")
            out.write("" if number % 100 else "\n# and on\n")


def write_network(folder):
    """A long chain, a hub that everything touches, and pieces that nothing connects."""
    with open(f"{folder}/nodes.csv", "w") as nodes, open(f"{folder}/edges.csv", "w") as edges:
        nodes.write("id,capacity,source,initial,fixed\n")
        edges.write("i,j,conductance\n")
        size = 900
        for k in range(size):
            source = 0.5 if k % 97 == 3 else 0
            fixed = 10 if k == 0 else ""
            nodes.write(f"{k},{1 + 0.1 * (k % 7)},{source},{k % 11},{fixed}\n")
            if k % 150 != 0:
                edges.write(f"{k - 1},{k},{1 + 0.3 * (k % 5)}\n")
            if k != 444 and k % 3 == 0 and k < 600:
                edges.write(f"{min(k, 444)},{max(k, 444)},{0.01 + 0.001 * (k % 13)}\n")


def write_web(folder, size=1000):
    """Ids in disorder, edges across all cuts, some of them several times over, pieces without a fixed node, nodes that
    nothing touches, fixed ones at both ends and in between, and a hub; blank lines and comments between the rows."""
    draw = 2024

    def random():
        nonlocal draw
        draw = (draw * 1103515245 + 12345) % 2**31
        return draw / 2**31

    names = [(7 * k + 3) % 1009 * 5 - 900 for k in range(size)]  # all different
    fixed = {0: 10.5, 1: 10.5, 313: 0.0, size - 1: -4.0}
    with open(f"{folder}/web_nodes.csv", "w") as nodes:
        nodes.write("# a web\ncapacity;id;initial;fixed;source\n")
        for k, name in enumerate(names):
            capacity = 0 if k == 313 else 1 + 0.1 * (k % 7)
            nodes.write(f"{capacity};{name};{20 + 0.7 * (k % 11)};{fixed.get(k, '')};{0.5 if k % 97 == 3 else 0}\n")
            nodes.write("" if k % 90 else "\n# and on\n")
    with open(f"{folder}/web_nodes.csv") as nodes, open(f"{folder}/web_algebraic_nodes.csv", "w") as out:
        out.write(nodes.read().replace("1.3;-535;", "0;-535;"))
    edges = [(k, k + 1) for k in range(size - 1) if k % 140 != 7]  # pieces
    edges += [(k, 500) for k in range(300, 700, 3) if abs(k - 500) > 1]  # a hub
    edges += [(int(random() * 400), int(random() * 400)) for _ in range(300)]  # of two pieces and more
    edges += [(k, k - 1) for k in range(2, 100, 9)] * 2  # run parallel
    lone = set(range(800, 820)) | {3}  # of which one has a source
    edges = sorted((random(), i, j) for i, j in edges if i != j and not {i, j} & lone)
    with open(f"{folder}/web_edges.csv", "w") as out:
        out.write("i,j,conductance\n")
        for number, (value, i, j) in enumerate(edges):
            out.write(f"{names[i]},{names[j]},{0 if number % 50 == 7 else 0.01 + 3 * random()!r}\n")
            out.write("" if number % 77 else "# and on\n")


def write_ring(folder, size=896):
    """Every row has its two neighbours two rows away: a cut of the order parts two and two of them."""
    with open(f"{folder}/ring_nodes.csv", "w") as nodes, open(f"{folder}/ring_edges.csv", "w") as edges:
        nodes.write("id,capacity,source,initial,fixed\n")
        edges.write("i,j,conductance\n")
        for k in range(size):
            nodes.write(f"{k},1,0,{(k * k) % 17},\n")
            edges.write(f"{k},{(k + 1) % size},1\n")


def case(t_end, body, outputs=None, probe='["mid-height", 7]'):
    return HEAD.format(t_end=t_end, outputs=outputs or [t_end / 4, t_end], probe=probe) + body


def scenes():
    """Texts of cases by name."""
    cold = THERMAL.format(conductivity=50.0, initial=300.0)
    found = {
        "linear": case(4.0, cold + ENDS.format(top=400.0, bottom=300.0)),
        "driven": case(4.0, cold + ENDS.format(top=RAMP, bottom=300.0) +
                       'source = [ { where = { layer = { side = "+x", thickness = 0.9 } }, '
                       'value = { times = [0.0, 1.5, 3.0], values = [0.0, 0.02, 0.01] } } ]\n'),
        "radiating": case(8.0, THERMAL.format(conductivity=50.0, initial=1200.0) +
                          'convection = [ { where = "all", coefficient = 200.0, ambient = 300.0 } ]\n'
                          'radiation = [ { where = { layer = { side = "top", thickness = 3.0 } }, emissivity = 0.8, '
                          'ambient = { times = [0.0, 20.0], values = [300.0, 500.0] } } ]\n'),
        "kappa": case(4.0, THERMAL.format(conductivity=LINE, initial=300.0) + ENDS.format(top=400.0, bottom=300.0)),
        "two_way": case(0.5, ELECTRIC.format(mode="transient", conductivity=SIGMOID) + "specific_capacity = 2e4\n" +
                        ENDS.format(top=4.0, bottom=0.0) + THERMAL.format(conductivity=LINE, initial=300.0) +
                        'fixed = [ { where = { layer = { side = "bottom", thickness = 0.9 } }, value = 300.0 } ]\n'),
        "one_way": case(0.5, ELECTRIC.format(mode="transient", conductivity=1e4) + "specific_capacity = 2e4\n" +
                        ENDS.format(top=4.0, bottom=0.0) + cold +
                        'fixed = [ { where = { layer = { side = "bottom", thickness = 0.9 } }, value = 300.0 } ]\n'),
        # Layers 10 to 12 are electrodes, so that nothing but the heat of their contacts feels the pulse of layer 11.
        "electrodes": case(0.5, ELECTRIC.format(mode="transient", conductivity=1e4) + "specific_capacity = 2e4\n" +
                           f"fixed = [ {{ where = {{ ids = {list(range(360, 396)) + list(range(432, 468))} }}, value = 0.0 }},\n"
                           f"          {{ where = {{ ids = {list(range(396, 432))} }}, value = {{ times = [0.0, 0.2, 0.2, 0.3], "
                           "values = [0.0, 0.0, 4.0, 0.0] } } ]\n" + cold),
        "steady_potential": case(4.0, ELECTRIC.format(mode="steady", conductivity=1e4) +
                                 ENDS.format(top=4.0, bottom=0.0) + cold +
                                 'fixed = [ { where = { layer = { side = "bottom", thickness = 0.9 } }, value = 300.0 } ]\n'),
        "moving_potential": case(4.0, ELECTRIC.format(mode="steady", conductivity=SIGMOID) +
                                 ENDS.format(top=4.0, bottom=0.0) + cold +
                                 'fixed = [ { where = { layer = { side = "bottom", thickness = 0.9 } }, value = 300.0 } ]\n'),
        "lattice": LATTICE.format(t_end=4.0, early=1.0, cells=[6, 5, 40], diameter=1.02) +
                   THERMAL.format(conductivity=50.0, initial=300.0) +
                   f'fixed = [ {{ where = "top", value = 400.0 }}, {{ where = "bottom", value = 300.0 }},\n'
                   f'          {{ where = {{ ids = {list(range(500, 566))} }}, value = 350.0 }} ]\n'
                   'source = [ { where = { layer = { side = "+x", thickness = 0.9 } }, value = 0.02 } ]\n',
        "lattice_radiating": LATTICE.format(t_end=8.0, early=2.0, cells=[9, 7, 11], diameter=1.5) +
                             THERMAL.format(conductivity=50.0, initial=1200.0) +
                             'convection = [ { where = "all", coefficient = 200.0, ambient = 300.0 } ]\n'
                             'radiation = [ { where = "top", emissivity = 0.8, ambient = 500.0 } ]\n',
        "lattice_varying": LATTICE.format(t_end=4.0, early=1.0, cells=[6, 5, 40], diameter=1.02) +
                           THERMAL.format(conductivity=LINE, initial=300.0) +
                           'fixed = [ { where = "top", value = 400.0 }, { where = "bottom", value = 300.0 } ]\n',
        "bed": BED.format(t_end=4.0) + cold +
               'fixed = [ { where = "-y", value = 400.0 },\n'
               f'          {{ where = {{ ids = {[7 * k - 500 for k in range(900, 960)]} }}, value = 350.0 }} ]\n'
               'source = [ { where = { layer = { side = "+x", thickness = 0.9 } }, value = 0.02 } ]\n',
        "bed_radiating": BED.format(t_end=8.0) + THERMAL.format(conductivity=50.0, initial=1200.0) +
                         'convection = [ { where = "top", coefficient = 200.0, ambient = 300.0 } ]\n'
                         'radiation = [ { where = "+y", emissivity = 0.8, ambient = 500.0 } ]\n',
        # Its tables of time and its law are read by the root for all.
        "bed_driven": BED.format(t_end=4.0) + cold + f'fixed = [ {{ where = "-y", value = {RAMP} }} ]\n',
        "bed_kappa": BED.format(t_end=4.0) + THERMAL.format(conductivity=LINE, initial=300.0) +
                     'fixed = [ { where = "-y", value = 400.0 } ]\n',
        "hub": 't_end = 3.0\noutput_times = [1.0, 3.0]\nprobe = [444, 899]\n'
               '[network]\nnodes = "nodes.csv"\nedges = "edges.csv"\n',
        "web": WEB,
        "web_potential": WEB + 'field = "potential"\n',
        # Its list of nodes is read by the root for all, and so are its nodes of capacity 0.
        "web_listed": WEB + 'source = [ { ids = [-250], value = 0.25 } ]\n',
        "web_algebraic": WEB.replace("web_nodes", "web_algebraic_nodes"),
        "ring": 't_end = 100.0\nprobe = [5]\n[network]\nnodes = "ring_nodes.csv"\nedges = "ring_edges.csv"\n',
    }
    return found


def write_scenes(folder):
    """Writes all cases and what they name; returns their names."""
    os.makedirs(folder, exist_ok=True)
    write_lattice(f"{folder}/lattice.csv")
    write_bed(f"{folder}/bed.csv")
    write_network(folder)
    write_web(folder)
    write_ring(folder)
    for name, text in scenes().items():
        with open(f"{folder}/{name}.toml", "w") as out:
            out.write(text)
    return list(scenes())
