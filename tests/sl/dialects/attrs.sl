/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    float x = 0;
    color c = 0;
    string n = "";
    float shr = 1;
    uniform float sides = 2;
    if (attribute("ShadingRate", shr) == 1)
        x = shr;
    attribute("user:foo", c);
    attribute("identifier:name", n);
    attribute("Sides", sides);
    attribute("Ri:Sides", sides);
    attribute("displacementbound:sphere", x);
    attribute("GeometricApproximation:motionfactor", x);
    matrix m = 1;
    attribute("transform", m);
    string me = shadername();
    string sm = shadername("surface");
    if (me == "a")
        Ci = c * x;
    Oi = Os;
    printf("%s %s", me, sm);
    float dd[2];
    attribute("Detail", dd);
    option("FrameAspectRatio", x);
    string un = "";
    option("user:foo", un);
    float fmt[3];
    option("Format", fmt);
    string rn = "";
    rendererinfo("renderer", rn);
}
