/* SPDX-License-Identifier: Apache-2.0
   glow, with its reflected light asked for as irradiance. */
surface glowbyirradiance(float Kd = .5; float emission = 1;)
{
    Oi = Os;
    Ci = Os * (emission + Kd / PI * irradiance(P, -I));
}
