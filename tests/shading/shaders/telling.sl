/* SPDX-License-Identifier: Apache-2.0
   Says what it is told of the frame's options; what there is not stays as it is. */
surface telling()
{
    float format[3] = {7, 7, 7};
    float gain = 7, nothing = 7;
    color tint = 7;
    float hasFormat = option("Format", format), hasGain = option("user:gain", gain);
    float hasTint = option("user:tint", tint), hasNothing = option("user:nothing", nothing);
    printf("%d%d%d%d %g %g %g %g %c %g\n", hasFormat, hasGain, hasTint, hasNothing, format[0],
           format[1], format[2], gain, tint, nothing);
    Oi = Os;
    Ci = gain * tint;
}
