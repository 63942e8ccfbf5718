/* SPDX-License-Identifier: Apache-2.0 */
filter smaller()
{
    float x, y;
    setsize("Ci", xsize / 2, ysize / 2);
    for (y = 0; y < ysize / 2; y += 1)
        for (x = 0; x < xsize / 2; x += 1)
            setimage("Ci", x, y, image("Cs", 2 * x, 2 * y));
}
