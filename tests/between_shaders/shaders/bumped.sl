/* A displacement that moves nothing far, with something to say; it asks the surface how far. */
displacement bumped(float amount = .125; string kind = "none"; color tint = color(.1, .2, .3);)
{
    float reach = 0;
    if (surface("reach", reach) != 0 && kind != "nothing at all")
        P += reach * normalize(N);
    N = calculatenormal(P);
}
