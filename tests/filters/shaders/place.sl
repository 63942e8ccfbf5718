/* SPDX-License-Identifier: Apache-2.0 */
/* Where the pixel is, and what covers it. */
imager place(float scale = 1; string what = "P";)
{
    if (what == "P")
        Ci = scale * color(xcomp(P), ycomp(P), alpha);
    else if (what == "NDC") {
        point q = transform("raster", "NDC", P);
        Ci = color(xcomp(q), ycomp(q), alpha);
    } else if (what == "Oi")
        Ci = scale * Oi;
    else if (what == "time")
        Ci = scale * time;
    else
        Ci *= scale;
}
