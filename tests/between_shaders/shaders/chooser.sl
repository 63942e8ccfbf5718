/* Hears the lights whose tags it is told to. */
surface chooser(string wanted = "nobody"; string others[2] = {"", ""}; string picture = "";)
{
    float heard = 0, other = 0;
    string tag = "";
    illuminance (P, N, PI) {
        if (lightsource("tag", tag) == 1) {
            if (tag == wanted)
                heard += 1;
            if (tag == others[0] || tag == others[1])
                other += 1;
        }
    }
    if (picture != "")
        heard += 8 * float texture(picture);
    Oi = 1;
    Ci = color(heard / 4, other / 4, 0);
}
