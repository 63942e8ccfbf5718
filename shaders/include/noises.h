// SPDX-License-Identifier: Apache-2.0
// Noise from -1 to 1, its sums and cells, under the names that the shaders of Advanced RenderMan
// use. What is too fine for a sample fades to its mean.
#ifndef NOISES_H
#define NOISES_H

#include "filterwidth.h"

#define snoise(p) (2 * (float noise(p)) - 1)
#define snoisexy(x, y) (2 * (float noise(x, y)) - 1)
#define vsnoise(p) (2 * (vector noise(p)) - 1)
#define filteredsnoise(p, width) (snoise(p) * (1 - smoothstep(0.2, 0.75, width)))
#define filteredvsnoise(p, width) (vsnoise(p) * (1 - smoothstep(0.2, 0.75, width)))

#define fBm_default(p) fBm(p, filterwidthp(p), 4, 2, 0.5)
#define vfBm_default(p) vfBm(p, filterwidthp(p), 4, 2, 0.5)
#define turbulence_default(p) turbulence(p, filterwidthp(p), 4, 2, 0.5)

/// A sum of noises, each lacunarity times as fine and gain times as strong as the one before.
float fBm(point p; float filtwidth; uniform float maxoctaves, lacunarity, gain) {
    float sum = 0, scale = 1, strength = 1;
    uniform float octave;
    for (octave = 0; octave < maxoctaves; octave += 1) {
        sum += strength * filteredsnoise(scale * p, scale * filtwidth);
        scale *= lacunarity;
        strength *= gain;
    }
    return sum;
}

vector vfBm(point p; float filtwidth; uniform float maxoctaves, lacunarity, gain) {
    vector sum = 0;
    float scale = 1, strength = 1;
    uniform float octave;
    for (octave = 0; octave < maxoctaves; octave += 1) {
        sum += strength * filteredvsnoise(scale * p, scale * filtwidth);
        scale *= lacunarity;
        strength *= gain;
    }
    return sum;
}

/// As fBm(), of what the noises are without their signs.
float turbulence(point p; float filtwidth; uniform float maxoctaves, lacunarity, gain) {
    float sum = 0, scale = 1, strength = 1;
    uniform float octave;
    for (octave = 0; octave < maxoctaves; octave += 1) {
        sum += strength * abs(filteredsnoise(scale * p, scale * filtwidth));
        scale *= lacunarity;
        strength *= gain;
    }
    return sum;
}

/// The two nearest of points that are strewn one to each unit cube: their places and distances.
void voronoi_f1f2_3d(point P; float jitter; output float f1; output point pos1; output float f2;
                     output point pos2) {
    point middle = point(floor(xcomp(P)) + 0.5, floor(ycomp(P)) + 0.5, floor(zcomp(P)) + 0.5);
    f1 = f2 = 1000;
    pos1 = pos2 = P;
    uniform float i, j, k;
    for (i = -1; i <= 1; i += 1)
        for (j = -1; j <= 1; j += 1)
            for (k = -1; k <= 1; k += 1) {
                point cell = middle + vector(i, j, k);
                point place = cell + jitter * (vector cellnoise(cell) - 0.5);
                float far = distance(place, P);
                if (far < f1) {
                    f2 = f1;
                    pos2 = pos1;
                    f1 = far;
                    pos1 = place;
                } else if (far < f2) {
                    f2 = far;
                    pos2 = place;
                }
            }
}

void voronoi_f1_3d(point P; float jitter; output float f1; output point pos1) {
    float f2;
    point pos2;
    voronoi_f1f2_3d(P, jitter, f1, pos1, f2, pos2);
}

/// The same of points in unit squares.
void voronoi_f1f2_2d(float ss, tt, jitter; output float f1, spos1, tpos1, f2, spos2, tpos2) {
    float smiddle = floor(ss) + 0.5, tmiddle = floor(tt) + 0.5;
    f1 = f2 = 1000;
    spos1 = spos2 = ss;
    tpos1 = tpos2 = tt;
    uniform float i, j;
    for (i = -1; i <= 1; i += 1)
        for (j = -1; j <= 1; j += 1) {
            float scell = smiddle + i, tcell = tmiddle + j;
            float splace = scell + jitter * (float cellnoise(scell, tcell) - 0.5);
            float tplace = tcell + jitter * (float cellnoise(scell + 1000, tcell) - 0.5);
            float far = sqrt((splace - ss) * (splace - ss) + (tplace - tt) * (tplace - tt));
            if (far < f1) {
                f2 = f1;
                spos2 = spos1;
                tpos2 = tpos1;
                f1 = far;
                spos1 = splace;
                tpos1 = tplace;
            } else if (far < f2) {
                f2 = far;
                spos2 = splace;
                tpos2 = tplace;
            }
        }
}

void voronoi_f1_2d(float ss, tt, jitter; output float f1, spos1, tpos1) {
    float f2, spos2, tpos2;
    voronoi_f1f2_2d(ss, tt, jitter, f1, spos1, tpos1, f2, spos2, tpos2);
}

#endif
