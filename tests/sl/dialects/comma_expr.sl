/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    float i, j;
    for (i = 0, j = 1; i < 3; i += 1, j *= 2)
        Ci += j;
    Oi = 1;
    i = 1, j = 2;
}
