/* SPDX-License-Identifier: Apache-2.0
   A light with many controls, after Barzel, "Lighting Controls for Computer Cinematography" (1997),
   with the parameters that such lights are given in many scenes. It stands at the origin of shader
   space and looks along z. */

/* How far (x, y) is from the inner towards the outer of two superellipses about the origin: 0 within
   the first, 1 outside of the second. */
float beyondEllipse(float x, y, a, b, A, B, roundness)
{
    float beyond;
    if (roundness < .001)
        beyond = 1 - (1 - smoothstep(a, A, x)) * (1 - smoothstep(b, B, y));
    else {
        float power = 2 / roundness;
        float inner = pow(pow(x / a, power) + pow(y / b, power), 1 / power);
        float outer = pow(pow(x / A, power) + pow(y / B, power), 1 / power);
        beyond = smoothstep(1, inner / max(outer, 1e-6), inner);
    }
    return beyond;
}

light uberlight(string lighttype = "spot";  /* "spot", "omni" or "arealight" */
                float intensity = 1;
                color lightcolor = 1;
                float cuton = .01, cutoff = 1e6; /* distances between which it shines */
                float nearedge = 0, faredge = 0; /* widths of soft edges outside of these */
                float falloff = 0, falloffdist = 1; /* power of the distance; where it counts 1 */
                float maxintensity = 1;          /* nearer than falloffdist */
                float parallelrays = 0;
                float shearx = 0, sheary = 0;
                float width = 1, height = 1;     /* halves of the opening, at a distance of 1 */
                float wedge = .1, hedge = .1;    /* widths of its soft rim */
                float roundness = 1;             /* 0: a rectangle */
                float beamdistribution = 0;      /* power of the cosine off the axis */
                string slidename = "";           /* a picture to be projected */
                float noiseamp = 0, noisefreq = 4;
                vector noiseoffset = 0;
                string shadowmap = "", shadowname = ""; /* either of them */
                float shadowblur = .01, shadowbias = .01, shadownsamps = 16;
                color shadowcolor = 0;           /* of the light where it is in shadow */
                float raytraceshadow = 0;
                float __nonspecular = 0, __nondiffuse = 0; /* 1: makes no highlights, no shades */)
{
    point here = transform("shader", Ps);
    point from = point "shader" (0, 0, 0);
    vector axis = normalize(vector "shader" (0, 0, 1));
    float angle = PI;
    if (lighttype == "spot")
        angle = atan(sqrt(2) * max(width + wedge + abs(shearx), height + hedge + abs(sheary)));
    else if (lighttype == "arealight") {
        from = P;
        axis = N;
        angle = PI / 2;
    }

    illuminate(from, axis, angle) {
        float away = length(vector here);
        float depth = away;
        if (lighttype == "spot")
            depth = zcomp(here);
        float share = smoothstep(cuton - nearedge, cuton, depth) *
                      (1 - smoothstep(cutoff, cutoff + faredge, depth));
        if (falloff != 0) {
            if (away > falloffdist)
                share *= pow(falloffdist / away, falloff);
            else
                share *= mix(maxintensity / intensity, 1, pow(away / falloffdist, falloff));
        }
        if (lighttype != "omni" && beamdistribution > 0)
            share *= pow(max(normalize(L) . axis, 0), beamdistribution);
        if (lighttype == "spot" && depth > 0) {
            float spread = depth;
            if (parallelrays != 0)
                spread = 1;
            share *= 1 - beyondEllipse(abs(xcomp(here) / spread - shearx),
                                       abs(ycomp(here) / spread - sheary), width, height,
                                       width + wedge, height + hedge, roundness);
        }
        color tint = lightcolor;
        if (slidename != "" && depth > 0)
            tint *= color texture(slidename, .5 + .5 * xcomp(here) / ((width + wedge) * depth),
                                  .5 - .5 * ycomp(here) / ((height + hedge) * depth));
        if (noiseamp > 0) {
            point q = noisefreq * (here + noiseoffset);
            share *= smoothstep(0, 1, .5 + noiseamp * (float noise(xcomp(q), ycomp(q)) - .5));
        }
        float lit = 1;
        if (shadowmap != "")
            lit *= 1 - shadow(shadowmap, Ps, "samples", shadownsamps, "blur", shadowblur, "bias",
                              shadowbias);
        if (shadowname != "")
            lit *= 1 - shadow(shadowname, Ps, "samples", shadownsamps, "blur", shadowblur, "bias",
                              shadowbias);
        color open = color(lit, lit, lit);
        if (raytraceshadow != 0)
            open *= transmission(Ps, from);
        Cl = share * intensity * mix(shadowcolor, tint, open);
        if (parallelrays != 0)
            L = axis * length(Ps - from);
    }
}
