/* Every way to look pictures up. */
surface pictures(string map = "paint.tx", sky = "sky.env", bumps = "bumps.tx", shade = "lamp.shd";
                 float turn = 0, wide = 1;)
{
    float size[2] = {0, 0}, channels = 0, k;
    matrix toLight = 1;
    normal Nf = normalize(bump(bumps, faceforward(normalize(N), I), dPdu, dPdv, s, t));
    color paint = color texture(map) + color texture(map[1], s * 3, t * 3, "swidth", wide, "fill", .5);
    paint *= float texture(map[2], s, t, s + .1, t, s, t + .1, s + .1, t + .1, "blur", .1);
    for (k = 0; k < 2; k += 1)
        paint += color texture(map, s + k, noise(P), "sblur", .02, "filter", "gaussian", "lerp", 1);
    if (textureinfo(map, "resolution", size) == 1 && size[0] > size[1])
        paint *= .5 + Du(float texture(map, s, t));
    if (textureinfo(shade, "viewingmatrix", toLight) + textureinfo(map, "channels", channels) > 0)
        paint += .01 * mod(zcomp(transform(toLight, P)) + channels, 1);
    vector R = vtransform("world", reflect(normalize(I), Nf));
    if (turn > 0)
        R = vector rotate(point R, turn, point(0, 0, 0), point(0, 0, 1));
    color back = environment(sky, R, "blur", .1 * u) + float environment(sky, Nf, "width", 0);
    Oi = Os * (1 - .2 * float shadow(shade, P, "bias", .01, "samples", 4, "blur", .02));
    Ci = Oi * (paint * (ambient() + diffuse(Nf)) + .3 * back);
}
