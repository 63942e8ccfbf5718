/* SPDX-License-Identifier: Apache-2.0 */
/* All that a compositor wants, as outputs. */
surface depth_passes(float Kd = .8, Ks = .2, roughness = .1;
    output varying color o_diffuse = 0; output varying color o_specular = 0;
    output varying float o_depth = 0; output varying normal o_normal = 0;
    output varying vector o_eye = 0; output varying point o_world = 0;
    output varying float o_facing = 0; varying output color o_st = 0;)
{
    normal n = normalize(N), nf = faceforward(n, I);
    vector i = normalize(I);
    o_diffuse = Kd * Cs * diffuse(nf);
    o_specular = Ks * specular(nf, -i, roughness);
    o_depth = depth(P);
    o_normal = ntransform("camera", nf);
    o_eye = vtransform("world", i);
    o_world = transform("world", P);
    o_facing = 1 - abs(n . i);
    o_st = color(s, t, 0);
    Oi = Os;
    Ci = Os * (o_diffuse + o_specular);
}
