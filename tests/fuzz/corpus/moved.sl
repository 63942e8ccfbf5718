/* Moves points by noise, by a picture and by what the surface tells. */
displacement moved(float amount = .1, frequency = 4; string map = ""; color tint = color(.1, .2, .3);)
{
    float reach = 0, k, height = 0;
    point p = transform("shader", P);
    for (k = 1; k < 4; k += 1)
        height += (float noise(frequency * k * p) - .5) / k;
    if (map != "")
        height += float texture(map, s, t, "width", 2);
    if (surface("reach", reach) != 0)
        height += reach * smoothstep(0, 1, v);
    normal n = normalize(N);
    P += amount * height * vector n + vector "object" (0, 0, .01 * sin(9 * u));
    N = calculatenormal(P);
    if (comp(tint, 0) > .9)
        N = mix(N, n, filterstep(.5, u));
}
