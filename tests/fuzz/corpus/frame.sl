/* An imager: a frame around the picture, and dots. */
imager frame(color edge = .2; float wide = .1; string mode = "hard";)
{
    float off = max(abs(s - .5), abs(t - .5)) * 2;
    float covered = mode == "hard" ? step(1 - wide, off) : smoothstep(1 - wide, 1, off);
    if (mod(xcomp(P) + ycomp(P), 2) < 1)
        covered *= .5 + .1 * noise(u * 9, v * 9);
    Ci = mix(Ci + (1 - alpha) * edge, edge, covered);
    Oi = mix(Oi, color 1, covered);
    alpha = max(alpha, covered);
}
