/* SPDX-License-Identifier: Apache-2.0 */
surface a(float k = 2;)
{
    float outer = 3;
    float f(float x)
    {
        extern float outer;
        extern float k;
        return x * outer * k;
    }
    void g(output float y)
    {
        y = f(2);
        outer = 5;
    }
    float z = 0;
    g(z);
    Ci = z * outer;
    Oi = Os;
}
