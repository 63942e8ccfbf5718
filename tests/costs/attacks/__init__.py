# SPDX-License-Identifier: Apache-2.0
"""All generators of inputs, by name."""
from attacks import (archives, binary, blocks, curved, doubling, extremes, files, floods, many, names,
                     numbers, pictures, polygons, shader_loops, shader_text, verbs)
from attacks.attack import ATTACKS

__all__ = ["ATTACKS"]
