/* Output parameters of every type, none of which light has a part in. */
surface ramp(output varying float weight = 0; output varying color tint = 0;
             output varying vector way = 0; output varying float pair[2] = {0, 0};)
{
    weight = u;
    tint = color(u, v, .25);
    way = vector(1, 2, 3);
    pair[0] = u;
    pair[1] = 2 * v;
    Oi = Os;
    Ci = Os * Cs;
}
