filter ward94(float L_dmax = 100)
{
    float x, y, scale, L_wa;
    float sum_luminance;
    color rad;

    /* Compute the average luminance */
    for(x = 0; x < xsize; x += 1)
        for(y = 0; y < ysize; y += 1) {
            rad = image("Cs", x, y);
            sum_luminance += totalluminance(rad);
        }
    L_wa = sum_luminance / (xsize * ysize);

    /* Calculate the scaling factor*/
    scale = 1.219 + pow(L_dmax/2, 0.4);
    scale /= 1.219 + pow(L_wa, 0.4);
    scale = 1/L_dmax * pow(scale, 2.5);

    /* scale the pixel values */
    for(x = 0; x < xsize; x += 1)
        for(y = 0; y < ysize; y += 1) {
            rad = image("Cs", x, y);
            setimage("Ci", x, y, rad*scale);
        }
}
