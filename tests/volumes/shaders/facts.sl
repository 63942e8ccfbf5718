// SPDX-License-Identifier: Apache-2.0
volume facts(float which = 0;) {
    if (which == 0) Ci = color(zcomp(P) / 8);
    if (which == 1) Ci = color(zcomp(I) / 8);
    if (which == 2) Ci = color(-zcomp(N) / 8);
    if (which == 3) Ci = Cs / 8;
    if (which == 4) Ci = color(s, s, s) / 8;
    if (which == 5) Ci = Oi / 8;
    if (which == 6) Ci = color(zcomp(transform("shader", P)) / 8);
    if (which == 7) Ci = color(length(P - E) / 8);
    if (which == 8) Ci = color(zcomp(transform("object", P)) / 8);
}
