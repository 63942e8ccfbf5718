/* SPDX-License-Identifier: Apache-2.0 */
float f(float x)
{
    if (x > .5)
        return 1;
    return 0;
}
float g(float x)
{
    float i;
    for (i = 0; i < 3; i += 1) {
        if (i == x)
            return i;
    }
    return 5;
}
surface a()
{
    Ci = f(s) + g(2);
    Oi = 1;
}
