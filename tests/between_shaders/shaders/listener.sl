/* What lights say of themselves. */
surface listener()
{
    float gain, sum = 0, keys = 0, kept = .125;
    color tint = 0, tints = 0;
    string tag = "";
    illuminance (P, N, PI) {
        if (lightsource("gain", gain) == 1)
            sum += gain;
        if (lightsource("tag", tag) == 1 && tag == "key")
            keys += 1;
        if (lightsource("tint", tint) == 1)
            tints += tint;
        if (lightsource("nosuch", kept) != 0 || lightsource("gain", tint) != 0)
            kept = 9;
    }
    if (lightsource("gain", kept) != 0)
        kept = 9;
    Oi = 1;
    Ci = color(sum, keys / 8, kept) + tints;
}
