// SPDX-License-Identifier: Apache-2.0
// Irradiance and radiance at given points: the estimator of `candela probe`.
#pragma once

#include "light/path/settings.h"
#include "light/probe/point_estimate.h"
#include "world/scene/scene.h"

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace candela {

enum class ProbeQuantity { Irradiance, Radiance };

/// A sensor that faces along `direction`, or a ray along it. World space: that behind WorldBegin.
struct ProbePoint {
    std::array<double, 3> P{};         ///< Finite.
    std::array<double, 3> direction{}; ///< Finite, of any length but 0.
    int number = 0; ///< 0 or more. Random numbers belong to it; messages name it.
};

struct ProbeSettings {
    ProbeQuantity quantity = ProbeQuantity::Irradiance;
    int samples = 256;              ///< A point, at most.
    std::optional<double> accuracy; ///< See StoppingRule; unset = all samples are taken.
    /// Kind, seed, final pass... of frames; light is scattered maxDepth times on its way at most,
    /// direct light having had none.
    IntegratorSettings integrator;
    /// How far a sensor stands off its point, metres; unset = as far as floats need to be on the
    /// right side of a surface through the point.
    std::optional<float> offset;
};

struct ProbeAnswer {
    std::array<double, colorSamples> value{}; ///< W m^-2, or W m^-2 sr^-1.
    double photometric = 0;                   ///< lx, or cd m^-2.
    double halfWidth = 0;  ///< Of the interval that holds its expectation in 95 cases of 100; lx...
    int samples = 0;       ///< 0 where a solution has told all.
    bool reached = true;   ///< The accuracy.
    bool enclosed = false; ///< Nothing comes to it from any side: it lies within something opaque.
};

/// Answers depend on scene, seed, settings and the points (which are looked at in blocks of
/// `blockSize`), not on threads. Not finite radiance counts as 0 and is reported once, as in
/// pictures.
class Prober {
public:
    /// Points of a block share waves of paths.
    static constexpr int blockSize = 32;

    /// All of them must outlive it.
    Prober(const Scene &, const ProbeSettings &, TransportStatistics &, DiagnosticSink &);
    ~Prober();

    /// Answers as many points, on all threads. Who answers one after the other gives whole blocks,
    /// but for the last.
    void answer(std::span<const ProbePoint>, std::span<ProbeAnswer>);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace candela
