/* SPDX-License-Identifier: Apache-2.0 */
/* Light that arrives from elsewhere than the lamp: the new L is what surfaces see. */
light bent(float intensity = 1; point from = point "shader" (0, 0, 0); float distant = 0;
           vector along = vector "shader" (0, 0, 1))
{
    N = normalize(N);
    if (distant == 0)
        illuminate(from)
        {
            L = along;
            Cl = intensity;
        }
    else
        solar(vector "shader" (1, 0, 0), 0)
        {
            L = along;
            Cl = intensity;
        }
}
