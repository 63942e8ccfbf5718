/* SPDX-License-Identifier: Apache-2.0 */
/* Output parameters that are called as planes of pictures, and an array. */
surface lettered(output varying float R = 0; output float list[3] = {1, 2, 3};)
{
    R = .125;
    Oi = 1;
    Ci = .5;
}
