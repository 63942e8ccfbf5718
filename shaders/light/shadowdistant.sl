/* SPDX-License-Identifier: Apache-2.0
   distantlight with a shadow map, which is taken by an orthographic camera that looks along the
   light. */
light shadowdistant(float intensity = 1; /* scales the colour */
                    color lightcolor = 1;
                    point from = point "shader" (0, 0, 0);
                    point to = point "shader" (0, 0, 1); /* the light runs from one to the other */
                    string shadowname = "";              /* the map; none: no shadows */
                    float samples = 16;                  /* places that are compared */
                    float blur = .01;                    /* share of the map that is averaged */
                    float bias = -1; /* nearer by more than this hides; below 0: as suits the map */)
{
    solar(to - from, 0) {
        Cl = intensity * lightcolor;
        if (shadowname != "")
            Cl *= 1 - shadow(shadowname, Ps, "samples", samples, "blur", blur, "bias", bias);
    }
}
