/* What it hears of the other shaders, and what it tells displays. */
surface told(float reach = 0; color tint = .5; output varying color diffusePart = 0;
             output varying float pair[2] = {0, 0}; output varying float heard = 0;
             output varying vector way = 0; output matrix m = 1; output point where = 0;)
{
    float amount = 0, inside = 0, outside = 0, gain = 0, keys = 0, size[4] = {0, 0, 0, 0}, loud = 0;
    color hue = 0, air = 0;
    string tag = "", name = "";
    normal Nf = faceforward(normalize(N), I);
    heard = displacement("amount", amount) + displacement("tint", hue) + atmosphere("tint", air);
    heard += incident("density", outside) + opposite("density", inside) + surface("reach", loud);
    if (attribute("user:loud", loud) + attribute("user:hue", hue) + attribute("nosuch", size) > 1)
        heard += loud * comp(hue, 1);
    if (option("Format", size) == 1 && rendererinfo("renderer", name) == 1)
        heard += size[0] / 100;
    illuminance("*", P, Nf, PI / 2) {
        if (lightsource("gain", gain) == 1 && gain > 1)
            diffusePart += Cl * gain * max(0, normalize(L) . Nf) * .1;
        if (lightsource("tag", tag) == 1 && tag == "key")
            keys += 1;
    }
    pair[0] = amount + keys;
    pair[1] = inside - outside;
    way = reflect(I, Nf);
    m = matrix(1 + u);
    where = transform("object", P);
    Oi = Os;
    Ci = Oi * (tint * (diffusePart + diffuse(Nf)) + hue + .1 * air + .01 * heard);
    if (shadername() == "told" && tag != name)
        printf("%f %s %p\n", heard, tag, where);
}
