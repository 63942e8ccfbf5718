/* SPDX-License-Identifier: Apache-2.0 */
/* Moves its points away from the eye, as much as u says. */
surface slope()
{
    P += vector "camera" (0, 0, u);
    N = calculatenormal(P);
    Oi = 1;
    Ci = 1;
}
