/* Not affine in the light. */
surface tones(output varying color tone = 0;)
{
    tone = step(.2, diffuse(normalize(N)));
    Oi = Os;
    Ci = tone;
}
