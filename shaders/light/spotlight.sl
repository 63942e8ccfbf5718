/* SPDX-License-Identifier: Apache-2.0
   Light from a point into a cone: brightest along the axis, soft at the rim, falling off with
   the square of the distance. In si units, intensity is radiant intensity on the axis, W sr^-1. */
light spotlight(float intensity = 1; /* scales the colour */
                color lightcolor = 1;
                point from = point "shader" (0, 0, 0);
                point to = point "shader" (0, 0, 1);  /* where the axis points */
                float coneangle = radians(30);        /* half of the cone */
                float conedeltaangle = radians(5);    /* width of the soft rim inside it */
                float beamdistribution = 2;           /* power of the cosine off the axis */)
{
    vector axis = normalize(to - from);

    illuminate(from, axis, coneangle) {
        float cosine = normalize(L) . axis;
        float rim = smoothstep(cos(coneangle), cos(coneangle - conedeltaangle), cosine);
        Cl = intensity * lightcolor * rim * pow(cosine, beamdistribution) / (L . L);
    }
}
