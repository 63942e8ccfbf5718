// SPDX-License-Identifier: Apache-2.0
#include "image/kept_samples.h"

#include "foundation/base/raw_bytes.h"
#include "foundation/units/color.h"

#include <cmath>

namespace candela {

KeptSamples::KeptSamples(Film &film, int samples)
    : film_(film), samples_(film.window().columns(), film.window().rows(), samples * colorSamples) {
}

double KeptSamples::bytesNeeded(const FrameWindow &window, int samples) {
    return OwnedImage::bytesNeeded(window.columns(), window.rows(), samples * colorSamples);
}

void KeptSamples::add(const SampleBatch &batch) {
    film_.add(batch);
    const FrameWindow &w = film_.window();
    for (int i = 0; i < batch.count; ++i) {
        const int x = batch.x[i] - w.x0, y = batch.y[i] - w.y0;
        const int first = batch.sampleIndex[i] * colorSamples;
        if (x < 0 || x >= w.columns() || y < 0 || y >= w.rows() || first >= samples_.channels())
            continue;
        for (int c = 0; c < colorSamples; ++c) {
            const float value = batch.values[c][i] * batch.weight[i];
            samples_.row(first + c, y)[x] = std::isfinite(value) ? value : 0;
        }
    }
}

void KeptSamples::save(std::string &bytes) const {
    film_.save(bytes);
    for (int channel = 0; channel < samples_.channels(); ++channel)
        for (int y = 0; y < samples_.height(); ++y)
            appendRaw(bytes, std::span(samples_.row(channel, y), std::size_t(samples_.width())));
}

bool KeptSamples::restore(std::string_view &bytes) {
    bool whole = film_.restore(bytes);
    for (int channel = 0; channel < samples_.channels(); ++channel)
        for (int y = 0; y < samples_.height(); ++y)
            whole = whole && takeRaw(bytes, std::span(samples_.row(channel, y),
                                                      std::size_t(samples_.width())));
    return whole;
}

} // namespace candela
