/* SPDX-License-Identifier: Apache-2.0
   Texture coordinates as colours: s is red, t green. */
surface show_st() {
    Oi = Os;
    Ci = Oi * color(mod(s, 1), mod(t, 1), 0);
}
