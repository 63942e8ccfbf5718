/* SPDX-License-Identifier: Apache-2.0
   spotlight with a shadow map: what the map, taken from where the light stands, says is hidden
   stays dark. */
light shadowspot(
    float intensity = 1;                   /* scales the colour [0 up; on the axis, W/sr in si
                                              units] */
    color lightcolor = 1;                  /* colour of the light, channel by channel [0 up] */
    point from = point "shader" (0, 0, 0); /* where the light stands [anywhere] */
    point to = point "shader" (0, 0, 1);   /* where the axis points [anywhere but there] */
    float coneangle = radians(30);         /* half of the cone [0 to pi/2, radians] */
    float conedeltaangle = radians(5);     /* width of the soft rim inside it [0 to coneangle,
                                              radians] */
    float beamdistribution = 2;            /* power of the cosine off the axis [0 to 1000] */
    string shadowname = "";                /* the shadow map [a file; "": no shadows] */
    float samples = 16;                    /* places of the map that are compared [1 to 1024] */
    float blur = .01;                      /* share of the map that is averaged [0 to 1] */
    float bias = -1;                       /* nearer by more than this hides [0 up, length;
                                              below 0: as suits the map] */)
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
