/* SPDX-License-Identifier: Apache-2.0
   A spot with a sharp rim: intensity W/sr within `angle` of straight down, nothing outside. */
light hardspot(float intensity = 1; float angle = .5; point from = point "shader" (0, 0, 2);)
{
    illuminate(from, vector "shader" (0, 0, -1), angle)
        Cl = intensity / (L . L);
}
