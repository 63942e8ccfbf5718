// Two cones of directions at infinity, which send the same.
light cones(float irradiance = 1;
            vector first = vector "world" (0, 0, -1), second = vector "world" (0, 0, -1);
            float angles[2] = {180, 30}, exponents[2] = {0, 0}, importances[2] = {1, 1};)
{
    solar(2, first, angles[0], exponents[0], importances[0],
          second, angles[1], exponents[1], importances[1])
        Cl = irradiance;
}
