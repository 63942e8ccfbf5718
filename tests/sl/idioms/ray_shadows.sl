/* SPDX-License-Identifier: Apache-2.0 */
/* A point light that asks for its own shadows. */
light ray_shadows(float intensity = 1; color lightcolor = 1; point from = point "shader" (0, 0, 0);
                  float samples = 1, lightsize = 0, bias = .001; uniform float raytraceshadow = 1)
{
    illuminate(from) {
        float spread = atan(lightsize / length(L));
        Cl = intensity * lightcolor / (L . L);
        if (raytraceshadow != 0)
            Cl *= transmission(Ps, from, "samples", samples, "samplecone", spread, "bias", bias);
    }
}
