#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A ring of balls on a floor, by calls from Python: what examples/c_interface/balls.c is in C.

    balls.py              renders balls.exr, and says how bright the picture is
    balls.py balls.rib    writes the same scene as RIB
"""
import sys

import numpy

from candela import ri

BALLS = 12


def ball(number):
    """A ball of the colour that its place in the ring says."""
    color = numpy.full(3, 0.9, numpy.float32)
    color[number % 3] = 0.2
    ri.AttributeBegin()
    ri.Color(color)
    ri.Rotate(360 * number / BALLS, 0, 1, 0)
    ri.Translate(0, 0.3, 1.5)
    ri.Sphere(0.3, -0.3, 0.3, 360)
    ri.AttributeEnd()


def floor():
    corners = numpy.array([[-3, 0, -3], [-3, 0, 3], [3, 0, 3], [3, 0, -3]], numpy.float32)
    colors = [[0.5, 0.5, 0.5], [0.6, 0.6, 0.7], [0.7, 0.7, 0.8], [0.6, 0.6, 0.7]]
    ri.Surface("matte", Kd=0.8)
    ri.Polygon(P=corners, Cs=colors)


def scene(rib=None):
    ri.Begin(rib)
    ri.ArchiveRecord("comment", f"{BALLS} balls")
    ri.Display("balls.exr", "openexr", "rgba")
    if rib is None:
        ri.Display("+seen", "array", "rgb,z")
    ri.Format(160, 120, 1)
    ri.PixelSamples(4, 4)
    ri.PixelFilter("gaussian", 2, 2)
    ri.Projection("perspective", fov=40)
    ri.Translate(0, -0.3, 5)
    ri.Rotate(-25, 1, 0, 0)
    ri.WorldBegin()
    ri.LightSource("pointlight", {"from": [1.5, 3, -1.5], "intensity": 9})
    ri.LightSource("ambientlight", intensity=0.1)
    floor()
    ri.AttributeBegin()
    for number in range(BALLS):
        ball(number)
    ri.AttributeEnd()
    ri.WorldEnd()
    ri.End()


def main():
    scene(*sys.argv[1:])
    if len(sys.argv) == 1:
        picture = ri.picture("seen")
        brightest = picture.pixels[..., :3].sum(axis=2).argmax()
        row, column = divmod(int(brightest), picture.pixels.shape[1])
        print(f"brightest at column {column}, row {row}: {picture['Z'][row, column]:.2f} m away")


if __name__ == "__main__":
    main()
