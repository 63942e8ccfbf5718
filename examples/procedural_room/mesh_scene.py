#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A picture of a solution's elements, as RIB for candela itself: what `--solution-mesh` has written,
each element in its own radiance with its borders drawn.

    candela room.rib --integrator radiosity --solution-mesh room.ply
    mesh_scene.py room.rib room.ply > room_mesh.rib
    candela room_mesh.rib

The camera is that of the RIB; elements are seen on the side that they are of."""
import re
import struct
import sys

WIDTH = .004       # Of borders, and how far they stand off, in the world's units.
VERTEX = struct.Struct("<9f")


def read_ply(path):
    """Vertices (position, normal, radiance) and faces."""
    with open(path, "rb") as file:
        data = file.read()
    begin = data.index(b"end_header\n") + len(b"end_header\n")
    count = {name: int(re.search(rb"element %s (\d+)" % name, data)[1])
             for name in (b"vertex", b"face")}
    vertices = [VERTEX.unpack_from(data, begin + k * VERTEX.size) for k in range(count[b"vertex"])]
    at, faces = begin + len(vertices) * VERTEX.size, []
    for _ in range(count[b"face"]):
        corners = data[at]
        faces.append(struct.unpack_from(f"<{corners}i", data, at + 1))
        at += 1 + 4 * corners
    return vertices, faces


def numbers(values):
    return " ".join(f"{value:.6g}" for value in values)


def write_scene(rib, vertices, faces):
    head = open(rib, encoding="utf-8").read().split("WorldBegin")[0]
    print(re.sub(r'(Display "\+?)\w+', r"\1elements", head) +
          'Option "render" "string integrator" "classic"\nWorldBegin\nSides 1\nReverseOrientation\n'
          'Surface "constant"')
    shown = [k for face in faces for k in face]
    print(f"PointsPolygons [{numbers(len(face) for face in faces)}] [{numbers(range(len(shown)))}]\n"
          f'"P" [{numbers(x for k in shown for x in vertices[k][:3])}]\n'
          f'"varying color Cs" [{numbers(c for k in shown for c in vertices[k][6:])}]')
    ends = []
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            for k in (a, b):
                position, normal = vertices[k][:3], vertices[k][3:6]
                ends += [p + WIDTH * n for p, n in zip(position, normal)]
    print(f'Sides 2\nSurface "constant"\nColor 0 0 0\nOpacity .6 .6 .6\n'
          f'Curves "linear" [{"2 " * (len(ends) // 6)}] "nonperiodic" "P" [{numbers(ends)}] '
          f'"constantwidth" [{WIDTH}]\nWorldEnd')


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    write_scene(sys.argv[1], *read_ply(sys.argv[2]))
