// SPDX-License-Identifier: Apache-2.0
volume squared() {
    Ci = Ci * Ci * .5 + .125;
}
