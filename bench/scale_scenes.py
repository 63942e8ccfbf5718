# SPDX-License-Identifier: Apache-2.0
"""RIB scenes whose size is the question; deterministic, written where they are asked for."""
import math
import random

HEAD = """##RenderMan RIB-Structure 1.1
Option "radiometry" "string units" "si"
Display "{name}.exr" "openexr" "rgb"
Format {size} {size} 1
PixelFilter "box" 1 1
Projection "perspective" "fov" 40
Translate {eye}
WorldBegin
"""

LAMP = """AttributeBegin
AreaLightSource "arealight" 1 "radiance" {radiance} "onesided" 0
Surface "matte" "Ka" 0 "Kd" 0
"""


def begin(file, name, eye, size=256):
    file.write(HEAD.format(name=name, eye=eye, size=size))


def mesh(side):
    """A rumpled sheet of 2 * side * side triangles, one by one metre."""
    points = []
    for row in range(side + 1):
        for column in range(side + 1):
            x, z = column / side, row / side
            points.append(f"{x:.6g} {.05 * math.sin(40 * x) * math.cos(37 * z):.6g} {z:.6g}")
    corners = []
    for row in range(side):
        for column in range(side):
            a = row * (side + 1) + column
            b, c, d = a + 1, a + side + 1, a + side + 2
            corners.append(f"{a} {b} {c} {b} {d} {c}")
    counts = "3 " * (2 * side * side)
    return f"PointsPolygons [{counts}]\n[{' '.join(corners)}]\n\"P\" [{' '.join(points)}]\n"


def instances(path, across=1000, side=71):
    """across * across instances of one mesh of 2 * side * side triangles (10,082) under a lamp."""
    with open(path, "w", encoding="ascii") as file:
        begin(file, path.stem, f"0 -60 {across / 4:g}")
        file.write(LAMP.format(radiance=20) +
                   f"Translate 0 {across} 0\n"
                   'Polygon "P" [-50 0 -50  50 0 -50  50 0 50  -50 0 50]\n'
                   "AttributeEnd\nIlluminate 1 1\n"
                   f"ObjectBegin 1\nSurface \"matte\"\n{mesh(side)}ObjectEnd\n")
        turn = random.Random(1)
        for row in range(across):
            for column in range(across):
                file.write(f"AttributeBegin Translate {1.2 * (column - across / 2):g} "
                           f"{turn.uniform(-2, 2):.4g} {1.2 * row:g} "
                           f"Rotate {turn.uniform(0, 360):.4g} 0 1 0 ObjectInstance 1 "
                           "AttributeEnd\n")
        file.write("WorldEnd\n")


def tree(seed, side):
    """A trunk and a crown of 2 * side * side triangles, three metres high."""
    shape = random.Random(seed)
    points, corners = [], []
    for row in range(side + 1):
        for column in range(side):
            height, around = row / side, 2 * math.pi * column / side
            wide = .8 * math.sin(math.pi * height) ** .7 * shape.uniform(.75, 1.1)
            points.append(f"{wide * math.cos(around):.4g} {1 + 2 * height:.4g} "
                          f"{wide * math.sin(around):.4g}")
            if row < side:
                a, b = row * side + column, row * side + (column + 1) % side
                corners.append(f"{a} {b} {a + side} {b} {b + side} {a + side}")
    counts = "3 " * (2 * side * side)
    return ("Color .3 .2 .1\nTransformBegin Rotate -90 1 0 0 Cylinder .1 0 1.2 360 TransformEnd\n"
            f"Color .2 .4 .1\nPointsPolygons [{counts}]\n[{' '.join(corners)}]\n"
            f"\"P\" [{' '.join(points)}]\n")


def moving_trees(path, across=1000, kinds=8, side=70):
    """across * across trees of some kinds, each of which sways while the shutter is open."""
    with open(path, "w", encoding="ascii") as file:
        file.write("Shutter 0 1\n")
        begin(file, path.stem, f"0 -60 {across / 4:g}")
        file.write('LightSource "distantlight" 1 "intensity" 3 "from" [1 3 -1] "to" [0 0 0]\n'
                   'Surface "matte"\n')
        for kind in range(kinds):
            file.write(f"ObjectBegin {kind + 1}\n{tree(kind, side)}ObjectEnd\n")
        turn = random.Random(3)
        for row in range(across):
            for column in range(across):
                sway = turn.uniform(1, 4)
                file.write(f"AttributeBegin Translate {2.2 * (column - across / 2):g} 0 {2.2 * row:g} "
                           f"MotionBegin [0 1] Rotate -{sway:.3g} 0 0 1 Rotate {sway:.3g} 0 0 1 "
                           f"MotionEnd Rotate {turn.uniform(0, 360):.4g} 0 1 0 "
                           f"ObjectInstance {turn.randrange(kinds) + 1} AttributeEnd\n")
        file.write("WorldEnd\n")


def large_mesh(path, side=2237):
    """One PointsPolygons of 2 * side * side triangles (ten million), a rumpled ground."""
    with open(path, "w", encoding="ascii") as file:
        begin(file, path.stem, "0 -1 3")
        file.write('LightSource "distantlight" 1 "intensity" 3 "from" [1 3 -1] "to" [0 0 0]\n'
                   'Surface "matte"\nPointsPolygons [')
        for _ in range(side):
            file.write("3 " * (2 * side) + "\n")
        file.write("] [")
        for row in range(side):
            a = row * (side + 1)
            b = a + side + 1
            file.write(" ".join(f"{a + k} {a + k + 1} {b + k} {a + k + 1} {b + k + 1} {b + k}"
                                for k in range(side)) + "\n")
        file.write('] "P" [')
        for row in range(side + 1):
            z = 4 * row / side - 1
            slow = math.cos(19 * z)
            file.write(" ".join(f"{4 * k / side - 2:.6g} {.05 * math.sin(80 * k / side) * slow:.6g} "
                                f"{z:.6g}" for k in range(side + 1)) + "\n")
        file.write("]\nWorldEnd\n")


def furnished_hall(path, tables=80, side=35):
    """A hall of 30 x 8 x 20 m with tables, and on each a bowl of 2 * side * side triangles (some
    200,000 in all), under eight lamps. Returns places of its floor that nothing stands on."""
    wide, deep, high = 30, 20, 8
    bowl_points, corners = [], []
    for row in range(side + 1):
        for column in range(side):
            slope, around = math.pi * (.5 + .5 * row / side), 2 * math.pi * column / side
            r = .35 * math.sin(slope) if row < side else 0
            bowl_points.append(f"{r * math.cos(around):.4g} {.9 + .35 * (1 + math.cos(slope)):.4g} "
                               f"{r * math.sin(around):.4g}")
            if row < side:
                a, b = row * side + column, row * side + (column + 1) % side
                corners.append(f"{a} {b} {a + side}" +
                               (f" {b} {b + side} {a + side}" if row + 1 < side else ""))
    bowl = (f"PointsPolygons [{'3 ' * (2 * side * side - side)}]\n[{' '.join(corners)}]\n"
            f"\"P\" [{' '.join(bowl_points)}]\n")
    across, along = 10, tables // 10
    with open(path, "w", encoding="ascii") as file:
        begin(file, path.stem, f"{-wide / 2:g} -3 -.5", 64)
        file.write(LAMP.format(radiance=20))
        for x in range(4):
            for z in range(2):
                a, b = wide * (x + .5) / 4, deep * (z + .5) / 2
                file.write(f'Polygon "P" [{a - .5:g} 7.9 {b - .5:g} {a + .5:g} 7.9 {b - .5:g} '
                           f'{a + .5:g} 7.9 {b + .5:g} {a - .5:g} 7.9 {b + .5:g}]\n')
        file.write('AttributeEnd\nIlluminate 1 1\nSurface "matte" "Ka" 0 "Kd" 1\n'
                   'Color .6 .6 .6\n' + box(0, wide, 0, high, 0, deep) +
                   "Color .4 .3 .2\nObjectBegin 1\n" + box(-.8, .8, .8, .84, -.5, .5) +
                   "".join(box(x - .04, x + .04, 0, .8, z - .04, z + .04)
                           for x in (-.7, .7) for z in (-.4, .4)) +
                   "Color .5 .6 .7\n" + bowl + "ObjectEnd\n")
        turn = random.Random(4)
        for column in range(across):
            for row in range(along):
                file.write(f"AttributeBegin Translate {wide * (column + .5) / across:g} 0 "
                           f"{deep * (row + .5) / along:g} Rotate {turn.uniform(-20, 20):.3g} 0 1 0 "
                           "ObjectInstance 1 AttributeEnd\n")
        file.write("WorldEnd\n")
    return [(wide * column / across, deep * (row + .25) / along)
            for column in range(1, across) for row in range(along)]


def emitting_spheres(path, count=100000):
    """So many glowing balls of 1 cm in a cube of 20 m over a floor."""
    with open(path, "w", encoding="ascii") as file:
        begin(file, path.stem, "0 -8 30")
        file.write(LAMP.format(radiance=30))
        place = random.Random(2)
        for _ in range(count):
            x, y, z = place.uniform(-10, 10), place.uniform(1, 20), place.uniform(-10, 10)
            file.write(f"TransformBegin Translate {x:.5g} {y:.5g} {z:.5g} "
                       "Sphere .01 -.01 .01 360 TransformEnd\n")
        file.write('AttributeEnd\nIlluminate 1 1\nSurface "matte"\n'
                   'Polygon "P" [-20 0 -20  20 0 -20  20 0 20  -20 0 20]\nWorldEnd\n')


def sky(path, round_sky):
    """Two blocks on a floor under a sky of one radiance: a sphere of 1 km, or a box as wide."""
    r = 1000
    with open(path, "w", encoding="ascii") as file:
        begin(file, path.stem, "0 -3 12")
        file.write(LAMP.format(radiance=1))
        file.write(f"Sphere {r} -{r} {r} 360\n" if round_sky else box(-r, r, -r, r, -r, r))
        file.write('AttributeEnd\nIlluminate 1 1\nSurface "matte"\n'
                   'Polygon "P" [-20 0 -20  20 0 -20  20 0 20  -20 0 20]\n' +
                   box(-2, -.5, 0, 2, -1, 1) + box(.5, 2, 0, 3, 0, 2) + "WorldEnd\n")


def box(x0, x1, y0, y1, z0, z1):
    corners = [f"{x} {y} {z} " for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    sides = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
    return "".join('Polygon "P" [' + "".join(corners[i] for i in side) + "]\n" for side in sides)
