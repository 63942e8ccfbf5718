# SPDX-License-Identifier: Apache-2.0
"""Curved surfaces, strokes and blobs that are as dear as such few bytes can be."""
import math

from attacks.attack import attack, filled, numbers, scene

AWAY = "Translate 0 0 5\n"


def random_numbers(count, chance, low=-1, high=1):
    return " ".join(f"{chance.uniform(low, high):.3g}" for _ in range(count))


def knots(points, order, values=None):
    return " ".join(str(values[i % len(values)] if values else i) for i in range(points + order))


def patch(nu, order_u, nv, order_v, points, knots_u=None, knots_v=None):
    return (f"NuPatch {nu} {order_u} [{knots_u or knots(nu, order_u)}] {order_u - 1} {nu} "
            f"{nv} {order_v} [{knots_v or knots(nv, order_v)}] {order_v - 1} {nv} \"P\" [{points}]")


@attack
def nurbs_of_high_order(size, chance):
    count = int(math.sqrt(size / 20))
    order = min(count, 24)
    return scene(AWAY + patch(count, order, count, order, random_numbers(3 * count * count, chance)))


@attack
def nurbs_of_higher_order(size, chance):
    """An order beyond every sense."""
    order = size // 40
    return scene(AWAY + patch(order, order, 2, 2, random_numbers(6 * order, chance)))


@attack
def nurbs_of_huge_order(size, chance):
    return scene(filled(size, 'NuPatch 2 2000000000 [0 1] 0 1 2 2000000000 [0 1] 0 1 "P" [0 0 0]\n'))


@attack
def nurbs_of_equal_knots(size, chance):
    count = int(math.sqrt(size / 20))
    return scene(AWAY + patch(count, 4, count, 4, random_numbers(3 * count * count, chance),
                              knots(count, 4, [0]), knots(count, 4, [0])))


@attack
def nurbs_narrow(size, chance):
    """One row of many spans."""
    count = size // 26
    return scene(AWAY + patch(count, 4, 2, 2, random_numbers(6 * count, chance)))


@attack
def nurbs_finest(size, chance):
    count = int(math.sqrt(size / 20))
    return scene(AWAY + "ShadingRate 1e-6 " +
                 patch(count, 4, count, 4, random_numbers(3 * count * count, chance)))


def trim(curves, order, points):
    """So many trimming curves of so many points: circles, roughly."""
    count = len(points) // 2
    u, v = numbers(points[::2]), numbers(points[1::2])
    ends = numbers(list(range(count + order)))
    return (f"TrimCurve [{'1 ' * curves}] [{f'{order} ' * curves}] [{(ends + ' ') * curves}] "
            f"[{f'{order - 1} ' * curves}] [{f'{count} ' * curves}] [{f'{count} ' * curves}] "
            f"[{(u + ' ') * curves}] [{(v + ' ') * curves}] [{'1 ' * count * curves}]\n")


FLAT = 'NuPatch 2 2 [0 0 1 1] 0 1 2 2 [0 0 1 1] 0 1 "P" [-1 -1 0 1 -1 0 -1 1 0 1 1 0]\n'


@attack
def trims_by_the_thousand(size, chance):
    square = [.2, .2, .8, .2, .8, .8, .2, .8, .2, .2]
    return scene(AWAY + trim(size // 90, 2, square) + FLAT)


@attack
def trim_of_many_points(size, chance):
    return scene(AWAY + trim(1, 2, [chance.random() for _ in range(size // 9)]) + FLAT)


@attack
def trim_of_high_order(size, chance):
    points = [chance.random() for _ in range(size // 9)]
    return scene(AWAY + trim(1, len(points) // 2, points) + FLAT)


@attack
def trim_for_many_patches(size, chance):
    circle = [.5 + .4 * f(2 * math.pi * i / 500) for i in range(501) for f in (math.cos, math.sin)]
    text = trim(1, 2, circle)
    return scene(AWAY + text + filled(size - len(text), FLAT))


def fan(count):
    """Faces around one vertex."""
    corners = " ".join(f"0 {1 + i} {1 + (i + 1) % count}" for i in range(count))
    points = " ".join(f"{math.cos(2 * math.pi * i / count):.3f} {math.sin(2 * math.pi * i / count):.3f} 5"
                      for i in range(count))
    return f'SubdivisionMesh "catmull-clark" [{"3 " * count}] [{corners}] ', f'"P" [0 0 4 {points}]'


@attack
def subdivision_of_a_fan(size, chance):
    mesh, points = fan(size // 35)
    return scene(mesh + '["interpolateboundary"] [0 0] [] [] ' + points)


@attack
def subdivision_of_fans(size, chance):
    """Fans just below what would be refused."""
    mesh, points = fan(300)
    text = mesh + points + "\n"
    return scene(filled(size, text))


@attack
def subdivision_of_one_face(size, chance):
    count = size // 22
    points = " ".join(f"{math.cos(2 * math.pi * i / count):.3f} {math.sin(2 * math.pi * i / count):.3f} 5"
                      for i in range(count))
    corners = " ".join(map(str, range(count)))
    return scene(f'SubdivisionMesh "catmull-clark" [{count}] [{corners}] "P" [{points}]')


@attack
def subdivision_about_one_edge(size, chance):
    """Every face holds the same edge."""
    count = size // 24
    corners = " ".join(f"0 1 {2 + i}" for i in range(count))
    points = " ".join(f"{math.cos(i):.3f} {math.sin(i):.3f} 5" for i in range(count))
    return scene(f'SubdivisionMesh "catmull-clark" [{"3 " * count}] [{corners}] "P" [0 0 4 0 0 6 {points}]')


@attack
def subdivision_of_the_same_face(size, chance):
    count = size // 10
    return scene(f'SubdivisionMesh "catmull-clark" [{"4 " * count}] [{"0 1 2 3 " * count}] '
                 '"P" [0 0 5 1 0 5 1 1 5 0 1 5]')


CUBE = '[4 4 4 4 4 4] [0 1 3 2 2 3 5 4 4 5 7 6 6 7 1 0 1 7 5 3 6 0 2 4]'
CUBE_POINTS = '"P" [-1 -1 4 1 -1 4 -1 1 4 1 1 4 -1 1 6 1 1 6 -1 -1 6 1 -1 6]'


@attack
def subdivision_tags(size, chance):
    """Thousands of creases of one cube."""
    count = size // 24
    return scene(f'SubdivisionMesh "catmull-clark" {CUBE} [{filled(9 * count, chr(34) + "crease" + chr(34) + " ")}] '
                 f'[{"2 1 " * count}] [{"0 1 " * count}] [{"9 " * count}] {CUBE_POINTS}')


@attack
def subdivision_of_creases(size, chance):
    """A loop of creases, as sharp as numbers go."""
    text = f'SubdivisionMesh "catmull-clark" {CUBE} ["crease" "corner"] [5 1 1 1] [0 1 3 2 0 4] [1e38 1e38] ' \
           f"{CUBE_POINTS}\n"
    return scene(filled(size, text))


@attack
def subdivision_finest(size, chance):
    return scene("ShadingRate 1e-9 " + filled(size, f'SubdivisionMesh "catmull-clark" {CUBE} {CUBE_POINTS}\n'))


def blobs(count, combine, chance, spread=1.0):
    """Spheres, and what combines them."""
    matrix = "{:.2g} 0 0 0 0 {:.2g} 0 0 0 0 {:.2g} 0 {:.2g} {:.2g} {:.2g} 1 "
    codes = "".join(f"1001 {16 * i} " for i in range(count))
    floats = "".join(matrix.format(*(chance.uniform(.1, 1) for _ in range(3)),
                                   *(chance.uniform(-spread, spread) for _ in range(3)))
                     for _ in range(count))
    return f"{AWAY}Blobby {count} [{codes}{combine}] [{floats}] [\"\"]\n"


@attack
def blobs_added(size, chance):
    count = size // 70
    return scene(blobs(count, f"0 {count} " + " ".join(map(str, range(count))), chance))


@attack
def blobs_apart(size, chance):
    """Small ones over a wide space."""
    count = size // 75
    return scene(blobs(count, f"0 {count} " + " ".join(map(str, range(count))), chance, 1e4))


@attack
def blobs_chained(size, chance):
    """Each code takes the last one's answer: a chain of thousands."""
    links = size // 14
    chain = "".join(f"4 {i} 0 " for i in range(1, links))
    return scene(blobs(2, "0 2 0 1 " + chain, chance))


@attack
def blobs_doubled(size, chance):
    """Each code adds the last one to itself."""
    chain = "".join(f"0 2 {i} {i} " for i in range(1, size // 16))
    return scene(blobs(1, "4 0 0 " + chain, chance))


@attack
def blobs_of_many_operands(size, chance):
    return scene(blobs(2, f"0 {size // 2} " + filled(size, "0 "), chance))


@attack
def blobs_in_numbers(size, chance):
    one = blobs(1, "0 1 0", chance)
    return scene(filled(size, one.replace(AWAY, "")))


def curves(size, chance, basis, more="", width='"constantwidth" [.01]'):
    count = size // 6 // 3
    return f'{AWAY}{more}Curves "{basis}" [{count // 3 * 3 + 1}] "nonperiodic" "P" ' \
           f"[{random_numbers(3 * (count // 3 * 3 + 1), chance)}] {width}\n"


@attack
def curves_long_and_random(size, chance):
    return scene(curves(size, chance, "cubic"))


@attack
def curves_wide(size, chance):
    """All of them everywhere: every ray meets every piece."""
    return scene(curves(size, chance, "cubic", width='"constantwidth" [9]'))


@attack
def curves_clear(size, chance):
    return scene(curves(size, chance, "cubic", "Opacity .01 .01 .01\n", '"constantwidth" [.5]'))


@attack
def curves_huge(size, chance):
    return scene(curves(size, chance, "linear", width='"constantwidth" [1e38]'))


@attack
def points_all_in_one_place(size, chance):
    return scene(f'{AWAY}Opacity .01 .01 .01 Points "P" [{filled(size, "0 0 0 ")}] "constantwidth" [1]')


@attack
def patches_steep(size, chance):
    """Bicubic patches with points far away, diced finely."""
    count = size // 12 // 3
    points = random_numbers(3 * count, chance, -1e6, 1e6)
    width = 4 + 3 * ((count // 4 - 4) // 3)
    points = " ".join(points.split()[:3 * 4 * width])
    return scene(f'{AWAY}PatchMesh "bicubic" {width} "nonperiodic" 4 "nonperiodic" "P" [{points}]')


@attack
def quadrics_of_finest_rate(size, chance):
    return scene(AWAY + "ShadingRate 1e-30\n" + filled(size, "Torus 1 .5 0 360 359 Hyperboloid 1 0 0 1 1 1 359\n"))


@attack
def tori_all_in_one_place(size, chance):
    return scene(AWAY + "Opacity .01 .01 .01\n" + filled(size, "Torus 1 .5 0 360 360\n"))
