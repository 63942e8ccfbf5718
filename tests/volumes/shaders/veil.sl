// SPDX-License-Identifier: Apache-2.0
volume veil(float distance = 1; color background = 0;) { Ci = mix(Ci, Oi * background, 1 - exp(-length(I) / distance)); }
