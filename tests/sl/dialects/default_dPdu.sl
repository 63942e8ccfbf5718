/* SPDX-License-Identifier: Apache-2.0 */
surface a(vector d = dPdu; varying normal n = N; float x = s; varying point pp = P;)
{
    Ci = xcomp(d) + xcomp(n) + x;
    Oi = 1;
}
