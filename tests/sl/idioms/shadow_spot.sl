/* SPDX-License-Identifier: Apache-2.0 */
/* A spotlight with a shadow map, in the manner of every RIB of the nineties. */
light
shadow_spot ( float intensity = 1;
              color lightcolor = 1;
              point from = point "camera" (0,0,0);
              point to = point "camera" (0,0,1);
              float coneangle = radians(30);
              float conedeltaangle = radians(5);
              float beamdistribution = 2;
              string shadowname = "";
              float samples = 16, blur = .01, bias = .01; )
{
    color attenuation;
    float cosangle;
    uniform point A = normalize(to - from);
    uniform float cosoutside = cos(coneangle), cosinside = cos(coneangle - conedeltaangle);

    illuminate( from, A, coneangle ) {
        cosangle = (L . A) / length(L);
        attenuation = pow(cosangle, beamdistribution) / (L . L);
        attenuation *= smoothstep( cosoutside, cosinside, cosangle );
        if( shadowname != "" )
            attenuation *= 1 - shadow( shadowname, Ps, "samples", samples, "blur", blur, "bias", bias );
        Cl = attenuation * intensity * lightcolor;
    }
}
