/* SPDX-License-Identifier: Apache-2.0
   spotlight with a shadow map: what the map, taken from where the light stands, says is hidden
   stays dark. */
light shadowspot(float intensity = 1; /* scales the colour */
                 color lightcolor = 1;
                 point from = point "shader" (0, 0, 0);
                 point to = point "shader" (0, 0, 1);  /* where the axis points */
                 float coneangle = radians(30);        /* half of the cone */
                 float conedeltaangle = radians(5);    /* width of the soft rim inside it */
                 float beamdistribution = 2;           /* power of the cosine off the axis */
                 string shadowname = "";               /* the map; none: no shadows */
                 float samples = 16;                   /* places that are compared */
                 float blur = .01;                     /* share of the map that is averaged */
                 float bias = -1; /* nearer by more than this hides; below 0: as it suits the map */)
{
    vector axis = normalize(to - from);

    illuminate(from, axis, coneangle) {
        float cosine = normalize(L) . axis;
        float rim = smoothstep(cos(coneangle), cos(coneangle - conedeltaangle), cosine);
        Cl = intensity * lightcolor * rim * pow(cosine, beamdistribution) / (L . L);
        if (shadowname != "")
            Cl *= 1 - shadow(shadowname, Ps, "samples", samples, "blur", blur, "bias", bias);
    }
}
