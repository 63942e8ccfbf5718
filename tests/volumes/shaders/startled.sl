// SPDX-License-Identifier: Apache-2.0
volume startled() {
    color c = 0;
    illuminance (P) c += Cl;
    if (comp(c, 0) > 0) illuminance (P - I / 2) c += 2 * Cl;
    Ci += c;
}
