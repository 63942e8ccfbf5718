/* SPDX-License-Identifier: Apache-2.0 */
light a(float intensity = 1; color lightcolor = 1; point from = point "shader"(0, 0, 0);
        point to = point "shader"(0, 0, 1); float coneangle = radians(30);
        float conedeltaangle = radians(5); float beamdistribution = 2; string shadowname = "";
        float samples = 16; output float __nonspecular = 0;
        output uniform string __category = "foo,bar";)
{
    float atten, cosangle;
    uniform point A = (to - from) / length(to - from);
    uniform float cosoutside = cos(coneangle), cosinside = cos(coneangle - conedeltaangle);
    illuminate(from, A, coneangle)
    {
        cosangle = (L.A) / length(L);
        atten = pow(cosangle, beamdistribution) / (L.L);
        atten *= smoothstep(cosoutside, cosinside, cosangle);
        Cl = atten * intensity * lightcolor;
    }
}
