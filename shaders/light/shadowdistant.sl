/* SPDX-License-Identifier: Apache-2.0
   distantlight with a shadow map, which is taken by an orthographic camera that looks along the
   light. */
light shadowdistant(
    float intensity = 1;                   /* scales the colour [0 up; of irradiance, W/m^2 in si
                                              units] */
    color lightcolor = 1;                  /* colour of the light, channel by channel [0 up] */
    point from = point "shader" (0, 0, 0); /* light comes from here ... [anywhere] */
    point to = point "shader" (0, 0, 1);   /* ... and goes there; what counts is the direction
                                              [anywhere] */
    string shadowname = "";                /* the shadow map [a file; "": no shadows] */
    float samples = 16;                    /* places of the map that are compared [1 to 1024] */
    float blur = .01;                      /* share of the map that is averaged [0 to 1] */
    float bias = -1;                       /* nearer by more than this hides [0 up, length;
                                              below 0: as suits the map] */)
{
    solar(to - from, 0) {
        Cl = intensity * lightcolor;
        if (shadowname != "")
            Cl *= 1 - shadow(shadowname, Ps, "samples", samples, "blur", blur, "bias", bias);
    }
}
