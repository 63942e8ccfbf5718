// SPDX-License-Identifier: Apache-2.0
#include "light/sampling/mis.h"

#include "foundation/base/hot.h"

#include <cmath>

namespace candela {

CANDELA_HOT void lightSampleFactors(int count, const float *__restrict lightPdf,
                                    const float *__restrict directionPdf,
                                    const float *__restrict wanted, float *__restrict factor) {
    for (int i = 0; i < count; ++i) {
        const float pl = lightPdf[i], pd = directionPdf[i];
        const float shared = misWeight(pl, pd) / (float(M_PI) * (pl > 0 ? pl : 1.0f));
        factor[i] = wanted[i] > 0 ? (pl > 0 ? shared : 1.0f) : 0.0f;
    }
}

CANDELA_HOT void emissionWeights(int count, const float *__restrict directionPdf,
                                 const float *__restrict lightPdf, float *__restrict weight) {
    for (int i = 0; i < count; ++i)
        weight[i] = directionPdf[i] > 0 ? misWeight(directionPdf[i], lightPdf[i]) : 1.0f;
}

} // namespace candela
