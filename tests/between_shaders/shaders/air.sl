/* A volume that leaves light alone, tells what there is of it, and what it hears of the surface. */
volume air(float density = .25; output varying float depth = 0; output varying float heard = 0;)
{
    depth = density * length(I);
    if (surface("reach", heard) == 0)
        heard = -1;
}
