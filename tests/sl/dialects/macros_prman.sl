/* SPDX-License-Identifier: Apache-2.0 */
#if defined(PRMAN) || defined(BMRT) || defined(AQSIS) || defined(DELIGHT) || defined(ENTROPY) ||   \
    defined(PIXIE) || defined(BMRTVERSION)
#endif
#ifdef PRMAN
#pragma foo
#endif
#if !defined(X) && (3 > 2)
surface a()
{
    Ci = 1;
    Oi = 1;
}
#endif
