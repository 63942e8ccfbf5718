// SPDX-License-Identifier: Apache-2.0
// How far two pictures are apart, and whether chance explains it: what `candela diff a b` says.
#pragma once

#include "image/picture.h"

#include <optional>
#include <string>
#include <vector>

namespace candela {

struct CompareSettings {
    float tolerance = 0;               ///< Largest absolute difference that counts as the same.
    float relativeTolerance = 0;       ///< The same, relative to the larger magnitude; or-ed.
    std::vector<std::string> channels; ///< Only these; empty = all.
};

/// What the variances say about the difference of one channel. Variances are those of the pixel
/// means, assumed independent between pixels and pictures.
struct Confidence {
    double chiSquare = 0;   ///< Sum of (a - b)^2 / (var a + var b).
    std::size_t pixels = 0; ///< Pixels in it: those with a finite, positive variance.
    double reduced = 0;     ///< chiSquare / pixels; 1 if noise alone explains the difference.
    double zOfMean = 0;     ///< Mean difference in units of its standard deviation.
    double probability = 1; ///< Of a |z| so large or larger by chance (two-sided).
};

struct ChannelComparison {
    std::string name;
    double largest = 0; ///< Largest |a - b|; infinite if only one of them is a number.
    int x = 0, y = 0;   ///< Where; absolute pixels of the frame.
    float valueA = 0, valueB = 0;
    double mean = 0;           ///< Mean of |a - b|.
    double meanDifference = 0; ///< Mean of a - b.
    double relMse = 0;         ///< Mean of (a - b)^2 / (b^2 + 0.01): b is the reference.
    /// Normalised: mean of (a - b)^2 over mean of b^2; nothing if b is black.
    std::optional<double> normalizedMse;
    /// 10 log10(peak^2 / mean square), the peak being b's largest magnitude; nothing if equal.
    std::optional<double> psnr;
    std::size_t beyond = 0; ///< Pixels beyond the tolerance.
    std::optional<Confidence> confidence;
};

struct Comparison {
    /// Why nothing could be compared (other size or window, no common channel); empty if it could.
    std::string problem;
    std::vector<ChannelComparison> channels; ///< Those in both pictures, in the order of a.
    std::vector<std::string> onlyInA, onlyInB;
    /// relMSE of the luminance, where both have R, G and B.
    std::optional<double> relMseOfLuminance;
};

/// Compares channels by their names. Infinities of one sign and NaNs equal themselves. A channel
/// X gets a confidence if both pictures have "variance.X" and X is linear radiance: "radiance.R"
/// always, "R" if neither picture's metadata tell of another exposure than 1 1, or of Quantize.
Comparison comparePictures(const Picture &a, const Picture &b, const CompareSettings & = {});

/// The exit status of `candela diff`: 0 the same within the tolerance, 1 different (also if one
/// picture has channels that the other lacks), 2 not comparable.
int exitCodeOf(const Comparison &);

/// A few lines a channel, for people.
std::string reportOf(const Comparison &);

} // namespace candela
