// SPDX-License-Identifier: Apache-2.0
volume glow(float distance = 1; color light = 1;) { float t = exp(-length(I) / distance); Ci = t * Ci + (1 - t) * light; Oi = 1 - t * (1 - Oi); }
