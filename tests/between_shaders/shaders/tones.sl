/* Not affine in the light. */
surface tones(output varying color tone = 0;)
{
    tone = step(.2, comp(diffuse(normalize(N)), 0));
    Oi = Os;
    Ci = tone;
}
