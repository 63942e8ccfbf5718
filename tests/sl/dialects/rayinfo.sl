/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    uniform float depth = 0;
    string type = "";
    rayinfo("depth", depth);
    rayinfo("type", type);
    float s0 = 0;
    rayinfo("shutter", s0);
    if (type == "camera")
        Ci = 1;
    if (raylevel() > 1)
        Ci = 0;
    if (isshadowray() == 1)
        Oi = 1;
    if (isindirectray() > 0)
        Ci = .5;
    if (raydepth() == 0)
        Ci = 1;
    string l = raylabel();
    if (raylabel() == "foo")
        Ci = 0;
    float fl = 0;
    rayinfo("label", l);
    Oi = Os + fl;
}
