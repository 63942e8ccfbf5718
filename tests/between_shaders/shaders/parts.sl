/* What of its light is diffuse and what is not, and all of it. */
surface parts(float roughness = .3; output varying color diffusePart = 0;
              output varying color highlight = 0; output varying color whole = 0;)
{
    normal Nf = faceforward(normalize(N), I);
    diffusePart = Cs * diffuse(Nf);
    highlight = .3 * specular(Nf, -normalize(I), roughness);
    whole = Os * (diffusePart + highlight);
    Oi = Os;
    Ci = whole;
}
