/* Loops, arrays, noise, functions and light. */
float wave(float x; float count) { return sin(x * count) * 0.5 + 0.5; }
surface waves(float amount = .5; color tint = color(1, .5, .2); string space = "world";)
{
    normal Nf = faceforward(normalize(N), I);
    float weights[3] = {.5, .3, .2};
    float sum = 0;
    uniform float i;
    for (i = 0; i < 3; i += 1)
        sum += weights[i] * noise(transform("shader", P) * pow(2, i));
    while (sum > 2 && i < 40) {
        i += 1;
        sum = sum / 2;
    }
    if (mod(s * 8, 2) < 1 && t > .1)
        sum = mix(sum, wave(t, 6), amount);
    else
        sum *= cellnoise(s, t);
    Oi = Os;
    Ci = Os * tint * (ambient() + sum * diffuse(Nf));
    Ci += trace(P, reflect(normalize(I), Nf)) * amount;
    illuminance(P, Nf, PI / 2) { Ci += Cl * max(0, normalize(L) . Nf) * .1; }
}
