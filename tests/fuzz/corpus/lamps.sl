/* A lamp with a slide, a shadow map, rays of its own and something to say. */
light lamps(float gain = 1; string tag = "none", map = "", slide = ""; color tint = color(1, .9, .8);
            point from = point "shader" (0, 1, -3), to = point "shader" (0, 0, 0); float angle = 1;
            output varying float unseen = 0;)
{
    vector axis = normalize(to - from);
    illuminate(from, axis, angle) {
        point place = transform("shader", Ps);
        Cl = gain * tint * pow(max(0, normalize(L) . axis), 4) / (1 + L . L);
        if (slide != "")
            Cl *= color texture(slide, .5 + xcomp(place) / 4, .5 + ycomp(place) / 4, "blur", .01);
        if (map != "")
            Cl *= 1 - float shadow(map, Ps, "blur", .02, "samples", 4);
        else
            Cl *= transmission(Ps, from, "samples", 2, "samplecone", .05);
        unseen = comp(Cl, 1);
    }
}
