/* SPDX-License-Identifier: Apache-2.0 */

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

/* A light with many controls, after Barzel, "Lighting Controls for Computer Cinematography" (1997),
   with the parameters that such lights are given in many scenes. It stands at the origin of shader
   space and looks along z. */
light uberlight(
    string lighttype = "spot";  /* what it is ["spot", "omni" or "arealight"] */
    float intensity = 1;        /* scales the colour [above 0] */
    color lightcolor = 1;       /* colour of the light, channel by channel [0 up] */
    float cuton = .01;          /* nearer than this it does not shine [0 up, length] */
    float cutoff = 1e6;         /* nor farther away than this [0 up, length] */
    float nearedge = 0;         /* width of the soft edge before cuton [0 up, length] */
    float faredge = 0;          /* width of the soft edge behind cutoff [0 up, length] */
    float falloff = 0;          /* power of the distance that divides the light; 2: as nature has
                                   it [0 to 4] */
    float falloffdist = 1;      /* where falloff leaves the light as it is [above 0, length] */
    float maxintensity = 1;     /* what it comes to at its place, if it falls off [0 up] */
    float parallelrays = 0;     /* whether rays run along the axis [0 or 1] */
    float shearx = 0;           /* how far the opening is to the right, at a distance of 1 [any,
                                   length] */
    float sheary = 0;           /* how far it is up [any, length] */
    float width = 1;            /* half of the opening's width, at a distance of 1 [above 0,
                                   length] */
    float height = 1;           /* half of its height [above 0, length] */
    float wedge = .1;           /* width of its soft rim to the sides [0 up, length] */
    float hedge = .1;           /* width of its soft rim up and down [0 up, length] */
    float roundness = 1;        /* 1: an ellipse; 0: a rectangle [0 to 1] */
    float beamdistribution = 0; /* power of the cosine off the axis [0 to 1000] */
    string slidename = "";      /* a picture to be projected [a file; "": none] */
    float noiseamp = 0;         /* depth of the pattern of noise that it wears [0 to 1] */
    float noisefreq = 4;        /* how fine that is [0 up, 1/length] */
    vector noiseoffset = 0;     /* where in the noise it stands [any, length] */
    string shadowmap = "";      /* a shadow map [a file; "": none] */
    string shadowname = "";     /* another one [a file; "": none] */
    float shadowblur = .01;     /* share of the maps that is averaged [0 to 1] */
    float shadowbias = .01;     /* nearer by more than this hides [0 up, length] */
    float shadownsamps = 16;    /* places of the maps that are compared [1 to 1024] */
    color shadowcolor = 0;      /* of the light where it is in shadow, channel by channel [0 up] */
    float raytraceshadow = 0;   /* whether rays look for what is in the way [0 or 1] */
    float __nonspecular = 0;    /* share of highlights that it does not make [0 or 1] */
    float __nondiffuse = 0;     /* share of diffuse light that it does not make [0 or 1] */)
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
