/* SPDX-License-Identifier: Apache-2.0
   What a surface without a shader looks like under the classic integrator: lit from the eye, so
   that geometry can be seen before there are lights. */
surface defaultsurface(float Ka = .2; /* what stays at grazing angles [0 to 1] */
                       float Kd = .8; /* what comes with the cosine to the eye [0 to 1] */)
{
    float towardsEye = abs(normalize(N) . normalize(I));

    Oi = Os;
    Ci = Os * Cs * (Ka + Kd * towardsEye);
}
