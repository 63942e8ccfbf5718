# SPDX-License-Identifier: Apache-2.0
"""Primitives of numbers that are none, or next to the ends of what floats hold."""
from attacks.attack import attack, scene

VALUES = ("nan", "inf", "-inf", "1e38", "-1e38", "1e-40", "-0", "0", "1", "1e400", "360", "-1", "1e20", "1e-20")
SHAPES = {  # Numbers stand for #.
    "quadrics": "Sphere # # # # Cone # # # Cylinder # # # # Disk # # # Torus # # # # # Paraboloid # # # # "
                "Hyperboloid # # # # # # #\n",
    "polygons": 'Polygon "P" [# # # # # # # # #]\n',
    "patches": 'Patch "bicubic" "P" [' + "# " * 48 + "]\n",
    "nurbs": 'NuPatch 4 4 [# # # # # # # #] # # 4 4 [0 0 0 0 1 1 1 1] 0 1 "P" [' + "# " * 48 + "]\n",
    "curves": 'Curves "cubic" [4] "nonperiodic" "P" [' + "# " * 12 + '] "width" [# #]\n',
    "points": 'Points "P" [# # # # # #] "width" [# #]\n',
    "subdivision": 'SubdivisionMesh "catmull-clark" [4 4] [0 1 2 3 1 4 5 2] ["crease"] [2 1] [1 2] [#] "P" ['
                   + "# " * 18 + "]\n",
    "blobs": "Blobby 2 [1001 0 1001 16 0 2 0 1] [" + "# " * 32 + '] [""]\n',
    "transformations": "AttributeBegin Translate # # # Rotate # # # # Scale # # # Skew # # # # # # # "
                       "ConcatTransform [" + "# " * 16 + "] Sphere 1 -1 1 360 AttributeEnd\n",
    "lights": 'LightSource "pointlight" 3 "from" [# # #] "intensity" [#] LightSource "spotlight" 4 "coneangle" [#]\n'
              "Sphere 1 -1 1 360\n",
    "motions": "AttributeBegin MotionBegin [# #] Translate # # # Translate # # # MotionEnd "
               "Sphere 1 -1 1 360 AttributeEnd\n",
    "solids": 'SolidBegin "difference" SolidBegin "primitive" Sphere # # # 360 SolidEnd SolidBegin "primitive" '
              "Cylinder # # # 360 SolidEnd SolidEnd\n",
    "rates": "ShadingRate # Sphere 1 -1 .9 360 Detail [# # # # # #] DetailRange # # # # Sphere 1 -1 .9 360\n",
}


def number(chance):
    """One of the table, or a good one."""
    return chance.choice(VALUES) if chance.random() < .3 else f"{chance.uniform(-1, 1):.2g}"


def of_numbers(text, size, chance):
    """A text again and again, with a number in each gap."""
    parts = []
    while size > 0:
        first, *others = text.split("#")
        parts.append(first + "".join(number(chance) + other for other in others))
        size -= len(parts[-1])
    return "".join(parts[:-1])


for shape, requests in SHAPES.items():
    attack(lambda size, chance, requests=requests: scene(
        "Translate 0 0 5\n" + of_numbers(requests, size, chance), "Shutter 0 1\n"),
           name=f"numbers-of-{shape}", quick=shape in ("quadrics", "motions"))
