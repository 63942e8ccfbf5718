// SPDX-License-Identifier: Apache-2.0
surface onemirror() { Oi = 1; Ci = trace(P, reflect(I, normalize(N))); }
