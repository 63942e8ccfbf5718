/* A volume that is lit where it likes, tells how far it saw and hears of the surface behind it. */
volume smoke(float density = .2, steps = 3, twist = 0; color tint = color(.8, .9, 1); string who = "";
             output varying float heard = 0; output varying color diffusePart = 0;)
{
    float far = length(I), k = 0, reach = 0;
    color sum = 0;
    while (k < steps) {
        point at = P - I + (k + random()) / steps * I;
        illuminance (who, at) {
            if (comp(Cl, 0) > 4) break;
            sum += Cl * (.5 + noise(at * 3)) / (1 + length(L));
        }
        k += 1;
    }
    if (surface("reach", reach) == 1)
        sum += reach * color(.1, 0, 0);
    heard = far + twist * comp(transmission(P, P - I), 0);
    float kept = exp(-density * far);
    diffusePart = kept * tint;
    Ci = mix(tint * sum / max(steps, 1), Ci, kept) + twist * (1 - Oi) * .1;
    Oi = 1 - (1 - Oi) * kept;
}
