/* SPDX-License-Identifier: Apache-2.0 */
/* Cells about scattered points: distances to the two nearest. */
void voronoi_f1f2_3d(point Q; float jitter; output float f1; output point pos1; output float f2;)
{
    point thiscell = point (floor(xcomp(Q)) + .5, floor(ycomp(Q)) + .5, floor(zcomp(Q)) + .5);
    f1 = f2 = 1000;
    uniform float i, j, k;
    for (i = -1; i <= 1; i += 1) {
        for (j = -1; j <= 1; j += 1) {
            for (k = -1; k <= 1; k += 1) {
                point testcell = thiscell + vector(i, j, k);
                point pos = testcell + jitter * (vector cellnoise(testcell) - .5);
                vector offset = pos - Q;
                float dist = offset . offset;
                if (dist < f1) {
                    f2 = f1;
                    f1 = dist;
                    pos1 = pos;
                } else if (dist < f2) {
                    f2 = dist;
                }
            }
        }
    }
    f1 = sqrt(f1);
    f2 = sqrt(f2);
}
surface worley_stone(float Kd = .8, freq = 3, gap = .06; color joint = .15)
{
    point PP = transform("shader", P) * freq, where = 0;
    float f1, f2;
    voronoi_f1f2_3d(PP, 1, f1, where, f2);
    float crack = smoothstep(gap * .5, gap, f2 - f1);
    color stone = Cs * (.7 + .3 * color cellnoise(where));
    Oi = Os;
    Ci = Os * mix(joint, stone, crack) * Kd * diffuse(faceforward(normalize(N), I));
}
