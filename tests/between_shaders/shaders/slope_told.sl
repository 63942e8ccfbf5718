/* SPDX-License-Identifier: Apache-2.0 */
/* As slope does, but N is not set. */
surface slope_told()
{
    P += vector "camera" (0, 0, u);
    Oi = 1;
    Ci = 1;
}
