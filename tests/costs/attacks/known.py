# SPDX-License-Identifier: Apache-2.0
"""Inputs that break a limit still, and why; costs.py --known tries them."""

READ_OFTEN = "all that is read is kept: half of the size, some thousand times"
GRID = "each blobby has a grid of its own, and a few thousand triangles"
LAYERS = "each ray meets thousands of surfaces, and the world is of nothing else"
TURNS = "each loop has turns of its own, and a turn may be dear"
PRINTED = "printf() may print what it likes"
SPARSE = "a file of a terabyte of zeros is read to its end"

KNOWN = {
    "archive-of-spheres-often": READ_OFTEN,
    "inline-archive-of-an-array": READ_OFTEN,
    "objects-large-often": LAYERS,
    "lamps-large-often": "a lamp of instances has pieces of its own in each",
    "teapots": "each is diced by itself",
    "binary-teapots": "each is diced by itself",
    "binary-worlds": "each is a picture",
    "deep-differences": "a crossing is told to each level of a solid",
    "unclosed-differences": "a crossing is told to each level of a solid",
    "solids-cut-away": LAYERS,
    "volumes": LAYERS,
    "subdivision-finest": "patches are cut to the end before their number is known",
    "blobs-in-numbers": GRID,
    "numbers-of-blobs": GRID,
    "shells-by-radiosity": LAYERS,
    "glass-shells-by-radiosity": LAYERS,
    "clear-shells-by-radiosity": LAYERS,
    "displaced-by-the-thousand": "displaced cells are counted by displacing them",
    "strange-shadow": SPARSE,
    "scene-of-zeros-from-a-device": SPARSE,
    "shaders-each-another": "a thousand shaders, some ten milliseconds each",
    "filters": "thousands of filters, each run",
    "filter-of-png-bomb": "a filter takes seven times the memory of its picture",
    "printed-by-every-point": PRINTED,
    "printed-by-arrays": PRINTED,
    "shader-long-prints": PRINTED,
    "loops-of-eight-levels": TURNS,
    "endless-one-after-the-other": TURNS,
    "endless-of-occlusions": TURNS,
    "endless-volume-of-light": TURNS,
    "shader-long-occlusions": TURNS,
    "shader-one-arguments": "arguments of a spline have no limit",
    "compile-to-asm": "all entry points of a long shader, in one go",
}
