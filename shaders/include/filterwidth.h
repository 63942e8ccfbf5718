// SPDX-License-Identifier: Apache-2.0
// How much numbers and places change from one sample to the next, under the names that the
// shaders of Advanced RenderMan use.
#ifndef FILTERWIDTH_H
#define FILTERWIDTH_H

#define MINFILTWIDTH 1.0e-6

#define filterwidth(x) max(abs(Du(x) * du) + abs(Dv(x) * dv), MINFILTWIDTH)
#define filterwidthp(p) max(sqrt(area(p)), MINFILTWIDTH)

#endif
