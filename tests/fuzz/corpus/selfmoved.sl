/* A surface that moves itself, by steps, and shades what has become of it. */
surface selfmoved(float height = .1; varying float bumps = 0;)
{
    P += height * (cellnoise(4 * s, 4 * t) + bumps) * normalize(N) + .01 * dPdu * sin(8 * v);
    N = calculatenormal(P);
    normal Nf = faceforward(normalize(N), I);
    Oi = Os * (1 - .5 * step(.8, u));
    Ci = Oi * Cs * (ambient() + diffuse(Nf)) + .1 * depth(P) * area(P) + .01 * length(dPdu ^ dPdv);
}
