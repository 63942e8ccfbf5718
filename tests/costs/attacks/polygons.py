# SPDX-License-Identifier: Apache-2.0
"""Polygons that are hard to cut into triangles."""
import math

from attacks.attack import attack, filled, numbers, scene


def spiral(count, chance):
    """Out along one arm, back along another."""
    half = count // 2
    outwards = [(.05 + 2 * i / half, .2 * i) for i in range(half)]
    inwards = [(radius + .02, turn) for radius, turn in reversed(outwards)]
    return [(r * math.cos(turn), r * math.sin(turn)) for r, turn in outwards + inwards]


def star(count, chance):
    return [((1 + i % 2) * math.cos(2 * math.pi * i / count), (1 + i % 2) * math.sin(2 * math.pi * i / count))
            for i in range(count)]


def crossing_star(count, chance):
    """Chords that all cross one another."""
    step = count // 2 - (count % 2 == 0)
    return [(math.cos(2 * math.pi * i * step / count), math.sin(2 * math.pi * i * step / count))
            for i in range(count)]


def comb(count, chance):
    teeth = [(4 * i / count - 2, -1.9 if i % 2 else 1.9) for i in range(count - 2)]
    return teeth + [(2, 2), (-2, 2)]


def random_path(count, chance):
    """Every edge crosses a third of all others."""
    return [(chance.uniform(-2, 2), chance.uniform(-2, 2)) for _ in range(count)]


def one_point(count, chance):
    return [(1, 1)] * count


def one_line(count, chance):
    return [(i / count, i / count) for i in range(count)]


def forth_and_back(count, chance):
    return [(i % 2, 0) for i in range(count)]


def saw(count, chance):
    """Teeth that nearly touch the base."""
    return [(i / count, 1e-6 if i % 2 else chance.random()) for i in range(count)] + [(1, 0), (0, 0)]


def bow_ties(count, chance):
    return [(4 * i / count - 2, (1, -1)[i % 4 in (1, 2)]) for i in range(count)]


def hilbert(count, chance):
    """A curve that fills the square."""
    order = int(math.log2(count)) // 2
    side = 1 << order

    def at(index):
        x = y = 0
        scale = 1
        while scale < side:
            right, up = 1 & index // 2, 1 & (index ^ index // 2)
            if up == 0:
                if right:
                    x, y = scale - 1 - x, scale - 1 - y
                x, y = y, x
            x, y, index, scale = x + scale * right, y + scale * up, index // 4, scale * 2
        return 4 * x / side - 2, 4 * y / side - 2
    return [at(i) for i in range(side * side)]


SHAPES = (spiral, star, crossing_star, comb, random_path, one_point, one_line, forth_and_back, saw, bow_ties, hilbert)


def points_of(shape, bytes_, chance):
    """A shape's corners, as many as the bytes have room for."""
    points = shape(bytes_ // 19, chance)
    return " ".join(f"{x:.5g} {y:.5g} 5" for x, y in points)


for form in SHAPES:
    attack(lambda size, chance, form=form: scene(f'Polygon "P" [{points_of(form, size, chance)}]'),
           quick=form in (star, random_path), name=f"polygon-{form.__name__.replace('_', '-')}")


def general(loops):
    counts = " ".join(str(len(loop)) for loop in loops)
    points = " ".join(f"{x:.4g} {y:.4g} 5" for loop in loops for x, y in loop)
    return scene(f'GeneralPolygon [{counts}] "P" [{points}]')


def square(x, y, half):
    return [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]


@attack(quick=True)
def holes(size, chance):
    side = int(math.sqrt(size / 70))
    inner = [square(4 * (i + .5) / side - 2, 4 * (j + .5) / side - 2, 1 / side)
             for i in range(side) for j in range(side)]
    return general([square(0, 0, 2), *inner])


@attack
def holes_that_overlap(size, chance):
    inner = [square(chance.uniform(-1, 1), chance.uniform(-1, 1), chance.random()) for _ in range(size // 75)]
    return general([square(0, 0, 2), *inner])


@attack
def holes_within_holes(size, chance):
    count = size // 85
    return general([square(0, 0, 2 - 2 * i / count) for i in range(count)])


@attack
def holes_of_two_points(size, chance):
    return general([square(0, 0, 2), *[[(0, 0), (1, 1)] for _ in range(size // 20)]])


@attack
def holes_in_a_row(size, chance):
    """All on one line: each bridge passes all holes before."""
    count = size // 80
    return general([square(0, 0, 2), *[square(4 * (i + .5) / count - 2, 0, 1 / count) for i in range(count)]])


@attack
def loops_with_wrong_counts(size, chance):
    return scene(f'GeneralPolygon [{filled(size, "99999999 ")}] "P" [0 0 0]')


@attack
def polygons_share_points(size, chance):
    """Every face a fan of the same three hundred corners."""
    corners = " ".join(str(i) for i in range(300))
    points = " ".join(f"{math.cos(i):.3g} {math.sin(i):.3g} 5" for i in range(300))
    faces = (size - len(points)) // (len(corners) + 5)
    return scene(f'PointsPolygons [{"300 " * faces}] [{(corners + " ") * faces}] "P" [{points}]')


@attack
def points_general_polygons_of_one_loop(size, chance):
    loops = size // 14
    return scene(f'PointsGeneralPolygons [{loops}] [{"3 " * loops}] [{"0 1 2 " * loops}] "P" '
                 f'[{numbers([0, 0, 5, 1, 0, 5, 0, 1, 5])}]')
