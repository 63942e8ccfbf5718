volume mist(float density = .2, steps = 6; color tint = color(.8, .9, 1); string who = "";)
{
    float far = length(I), k = 0;
    color sum = 0;
    while (k < steps) {
        point at = P - I + (k + random()) / steps * I;
        illuminance (who, at) {
            if (comp(Cl, 0) > 2) break;
            sum += Cl * (1 + noise(at * 2)) / (1 + length(L));
        }
        illuminance (at, normalize(-I), PI / 4) sum += .1 * Cl;
        k += 1;
    }
    Ci = mix(tint * sum / steps, Ci, exp(-density * far));
    Oi = 1 - (1 - Oi) * exp(-density * far);
}
volume deep(color water = color(.2, .5, .9); float waves = 1;)
{
    color kept = 1;
    float c;
    for (c = 0; c < 3; c += 1)
        setcomp(kept, c, pow(comp(water, c), length(I) * waves));
    if (depth(P) > .5 || s < t) Ci = Ci * kept + (1 - kept) * ambient();
    else Ci *= kept * (Cs + Oi) / 2;
    Ci += Oi * .1 * diffuse(N);
    printf("%f %c", length(I), Ci);
}
