// SPDX-License-Identifier: Apache-2.0
// Now and then very bright; 1 on average.
surface firefly(float share = .01) {
    Oi = Os;
    Ci = Os * (random() < share ? 1 / share : 0);
}
