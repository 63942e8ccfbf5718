/* SPDX-License-Identifier: Apache-2.0 */
surface a(output varying color diff = 0; output varying float dep = 0; output color spec = 0;
          varying output normal nn = 0; output varying vector vv = (0, 0, 1);
          output varying string lab = "";)
{
    diff = Cs * diffuse(N);
    dep = depth(P);
    spec = 1;
    nn = N;
    vv = I;
    Ci = diff + spec;
    Oi = Os;
}
