/* SPDX-License-Identifier: Apache-2.0
   Sends some points nowhere. */
displacement astray(float how = 0;)
{
    float far = how == 0 ? 1e38 * 1e38 : how == 1 ? log(0 - 1) : 1e30;
    if (mod(10 * u, 1) < .5)
        P += far * normalize(N);
}
