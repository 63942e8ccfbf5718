/* SPDX-License-Identifier: Apache-2.0 */
/* How often the ray has been reflected. */
surface deep()
{
    Oi = 1;
    Ci = 1 + raydepth();
}
