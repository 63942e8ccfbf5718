/* SPDX-License-Identifier: Apache-2.0
   Light from a point into a cone: brightest along the axis, soft at the rim, falling off with
   the square of the distance. In si units, intensity is radiant intensity on the axis, W sr^-1. */
light spotlight(
    float intensity = 1;                   /* scales the colour [0 up; on the axis, W/sr in si
                                              units] */
    color lightcolor = 1;                  /* colour of the light, channel by channel [0 up] */
    point from = point "shader" (0, 0, 0); /* where the light stands [anywhere] */
    point to = point "shader" (0, 0, 1);   /* where the axis points [anywhere but there] */
    float coneangle = radians(30);         /* half of the cone [0 to pi/2, radians] */
    float conedeltaangle = radians(5);     /* width of the soft rim inside it [0 to coneangle,
                                              radians] */
    float beamdistribution = 2;            /* power of the cosine off the axis [0 to 1000] */)
{
    vector axis = normalize(to - from);

    illuminate(from, axis, coneangle) {
        float cosine = normalize(L) . axis;
        float rim = smoothstep(cos(coneangle), cos(coneangle - conedeltaangle), cosine);
        Cl = intensity * lightcolor * rim * pow(cosine, beamdistribution) / (L . L);
    }
}
