/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    float i;
    for (i = 0; i < 3; i++)
        Ci += .1;
    for (i = 3; i > 0; --i)
        Ci += .1;
    float k = i++;
    Oi = Os;
}
