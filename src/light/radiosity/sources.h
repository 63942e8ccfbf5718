// SPDX-License-Identifier: Apache-2.0
// What elements know before light is exchanged: irradiance of light sources, and what their shaders
// make of light.
#pragma once

#include "light/radiosity/fields.h"

#include <map>
#include <mutex>
#include <string>

namespace candela::radiosity {

/// What shaders have said that no surface can do, by name, and how often.
class Impossible {
public:
    void add(const std::string &shader);
    std::map<std::string, std::size_t> all() const { return counts_; }

private:
    std::mutex mutex_;
    std::map<std::string, std::size_t> counts_;
};

struct SourceSettings {
    int samples = 16; ///< Of lights, at each node.
    std::uint32_t seed = 0;
    /// How finely direct light is told: the error of an element, times its area, in shares of the
    /// scene's direct flux.
    double epsilon = 1e-4;
    float leastArea = 0;              ///< No element is divided below it.
    std::vector<std::uint8_t> linked; ///< linkedLamps(): these are not sampled.
    /// Counts shaders that send on more than they get, or what is no number: 1 and 0 are taken.
    Impossible *impossible = nullptr;
};

/// Fills Fields::direct at nodes of elements from `first` on, and the response and what is sent
/// around them.
void askSources(const Mesh &, int first, const SourceSettings &, Fields &);

/// Divides elements where direct light and emission vary, and fills in what is known of them all.
void divideBySources(Mesh &, const SourceSettings &, Fields &);

} // namespace candela::radiosity
