/* SPDX-License-Identifier: Apache-2.0 */
volume fogx(float density = 0; color background = 0;)
{
    float d = 1 - exp(-density * length(I));
    Ci = mix(Ci, background, d);
    Oi = mix(Oi, color(1, 1, 1), d);
}
