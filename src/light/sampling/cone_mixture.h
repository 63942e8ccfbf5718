// SPDX-License-Identifier: Apache-2.0
// The density from which the next direction of a path is drawn: all finite cones that a shader
// states (paper equation 5), with a defensive share so that a wrong importance costs noise and
// never light (ALGORITHMS 1: 90 % cones, 5 % uniform, 5 % cosine lobe). A single lobe that is known
// to be exact needs none.
#pragma once

#include "foundation/base/planes.h"

#include <array>
#include <vector>

namespace candela {

using ConstVec3Planes = std::array<const float *, 3>;
using MutableVec3Planes = std::array<float *, 3>;

/// What a shader states of one cone for a batch: planes as Prepare writes them.
struct ConePlanes {
    ConstVec3Planes axis{};       ///< Any length.
    const float *angle = nullptr; ///< Full opening angle, degrees.
    const float *exponent = nullptr;
    const float *importance = nullptr; ///< 0 where the cone is absent.
    /// Angle of the first cone of the same request: <= 0 makes the whole request a delta one.
    const float *kindAngle = nullptr;
    int request = 0;
    bool first = true;  ///< The first cone of its request.
    bool exact = false; ///< The answer to light is this lobe, up to a factor.
};

class ConeMixture {
public:
    explicit ConeMixture(int capacity);

    /// Takes the cones of `count` points with unit normals that face the viewer. Where
    /// `transmits` is non-zero, light from behind matters too (null = nowhere). `facing` is kept
    /// by pointer until the next call.
    void state(int count, const std::vector<ConePlanes> &cones, const ConstVec3Planes &facing,
               const float *transmits);
    /// Becomes the mixtures of points lane[0..count) of another one, which may come again and
    /// again.
    void take(const ConeMixture &, int count, const int *lane);
    /// Sum of the finite importances of each point; where it is 0, sample() must not be used.
    const float *total() const { return total_[0]; }
    /// Non-zero where directions below the facing hemisphere matter too.
    const float *fullSphere() const { return fullSphere_[0]; }

    /// Unit directions for uniform samples (u,v); keeps their stratification.
    void sample(const float *u, const float *v, const MutableVec3Planes &direction);
    /// The density per steradian of unit directions.
    void pdf(const ConstVec3Planes &direction, float *pdf);

private:
    /// Hemispheres are lobes of 180 degrees, simple ones have exponent 0 or 1 besides.
    enum class LobeShape { Simple, Hemisphere, Any };
    struct Cone {
        explicit Cone(int capacity) : planes(6, capacity) {}
        float *axis(int c) const { return planes[c]; }
        float *share() const { return planes[3]; } ///< Of all of the mixture.
        float *angle() const { return planes[4]; }
        float *exponent() const { return planes[5]; }
        Planes<float> planes;
        LobeShape shape = LobeShape::Simple; ///< Of every lane.
    };
    /// The lobe that a sample falls into, and where in it.
    struct ChosenLobe {
        explicit ChosenLobe(int capacity) : axis(3, capacity), planes(6, capacity) {
            xi = planes[0], angle = planes[1], exponent = planes[2];
            tau = planes[3], low = planes[4], turn = planes[5];
        }
        Planes<float> axis, planes;
        float *xi; ///< Uniform again, for the height.
        float *angle, *exponent;
        float *tau;  ///< 1 - mu
        float *low;  ///< End of the shares so far.
        float *turn; ///< Azimuth, in turns.
    };
    void stateCone(int index, const ConePlanes &);
    void markLeavingCones(int index);
    void chooseLobe(const float *u);
    void lobeHeights();
    void lobesPdf(const ConstVec3Planes &direction, float *pdf);

    /// Of the mixture: what cones have together, and the two defensive lobes.
    struct Shares {
        float cones, uniform, cosine;
    };

    int count_ = 0, coneCount_ = 0;
    Shares shares_{};
    std::vector<Cone> cones_;
    ConstVec3Planes facing_{};
    Planes<float> total_, fullSphere_;
    /// Share of the cosine lobes where all lobes are simple and lie about the facing normal, so
    /// that they can be sampled as one; -1 elsewhere.
    Planes<float> cosineLobes_;
    Planes<float> takenFacing_;
    bool allRadial_ = false;
    ChosenLobe chosen_;
};

} // namespace candela
