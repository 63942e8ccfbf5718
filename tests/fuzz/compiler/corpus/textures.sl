float height(string name; float ss, tt) { return float texture(name, ss, tt, "blur", .01); }
surface textured(string map = "wood.tx", sky = "sky.env"; float Km = .1, wide = 1;
                 varying point where = 0;)
{
    point PP = P + Km * normalize(N) * height(map, 4 * s, noise(P) + t);
    normal Nf = faceforward(normalize(calculatenormal(PP)), I);
    float size[2] = {0, 0};
    color paint = color texture(map[1], s * s, t, "width", wide, "fill", .5);
    if (textureinfo(map, "resolution", size) == 1 && size[0] > size[1])
        paint *= texture(map, s, t, s + .1, t, s, t + .1, s + .1, t + .1);
    vector R = reflect(normalize(I), normalize(bump(map, Nf, dPdu, dPdv, s, t)));
    Oi = Os * (1 - shadow("lamp.shd", where, "bias", .01, "samples", 4));
    Ci = Oi * (paint * diffuse(Nf) + environment(sky, vtransform("world", R), "blur", s));
}
light mapped(string map = "lamp.shd", slide = "slide.tx"; float blur = .01;)
{
    illuminate(point "shader" (0, 0, 0), vector "shader" (0, 0, 1), .5) {
        point place = transform("shader", Ps);
        Cl = color texture(slide, xcomp(place) / zcomp(place), ycomp(place) / zcomp(place));
        Cl *= 1 - float shadow(map, Ps, "blur", blur);
    }
}
