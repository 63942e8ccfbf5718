// SPDX-License-Identifier: Apache-2.0
// Wavelet radiosity: the irradiance of every side of every surface, solved once for a scene and
// asked for at any point of it (paper, section 5.3; DESIGN 6).
#pragma once

#include "light/radiosity/closure.h"
#include "light/radiosity/links.h"
#include "light/radiosity/near_light.h"
#include "light/radiosity/places.h"
#include "light/radiosity/settings.h"
#include "light/radiosity/solution_data.h"
#include "light/vertex/surface_vertices.h"

#include <functional>
#include <initializer_list>
#include <memory>

namespace candela::radiosity {

/// Immutable: asked by all threads.
class Solution {
public:
    using Progress = std::function<void(double done)>;
    Solution(const Scene &, const SolverSettings &, DiagnosticSink &, const Progress & = {});

    /// From data(), which may be of another view of the same scene. Null if they are of no such
    /// scene: it has other faces.
    static std::unique_ptr<Solution> restored(const Scene &, const SolutionData &);
    /// What its answers stand on.
    SolutionData data() const;

    /// Irradiance at points that rays have met, on the side that they came from and on the other,
    /// W m^-2; direct light is that of light sources. Null planes are not wanted.
    struct Answer {
        std::array<float *, colorSamples> direct{}, indirect{};
        std::array<float *, colorSamples> directBehind{}, indirectBehind{};
        bool isExact = true; ///< Light that varies fast is gathered point by point.
    };
    void irradiance(SurfaceVertices &, const Answer &) const;

    const Mesh &mesh() const { return mesh_; }
    const Fields &fields() const { return fields_; }
    const Links &links() const { return links_; }
    const SolverStatistics &statistics() const { return statistics_; }

private:
    Solution(const Scene &, int order);
    void solve(const SolverSettings &, DiagnosticSink &, const Progress &);
    void linkLamps(LinkSettings, double epsilon, double contrast);
    double iterate();
    /// Smooth: of links that are not rough. Clear: of those that nothing stands between.
    enum class Which { All, Smooth, Clear };
    void gather(const Links &, const std::vector<Color> &sent, Which);
    void pushAll(std::vector<Color> &) const;
    /// What the element itself has is complete.
    void pushDown(int element, std::vector<Color> &) const;
    void pullAll(std::vector<Color> &) const;
    void pullUp(int element, std::vector<Color> &) const;
    void pullSources();
    void shineThrough();
    void report(const Impossible &, const SolverSettings &, DiagnosticSink &) const;
    double evenIrradiance(const std::vector<Color> &sent) const;
    /// The sum of fields at a place of a face.
    Color at(std::int32_t face, Place, std::initializer_list<const std::vector<Color> *>) const;
    /// Points of a batch's sides, and what is answered there.
    struct Asked;
    void answer(const Asked &, const NodeWeights &, const Answer &) const;
    /// What is asked for at points: smooth light, and what is near.
    struct Answering {
        std::vector<Color> smooth;
        NearLight near;
        std::vector<float> factor; ///< By node: closure.h. Has been applied to what is smooth.
    };
    Answering answering(const Links &, const std::vector<Color> &sent, std::vector<float> factor);
    std::vector<float> factorsOf(const Links &);
    void addNear(const Asked &, const NodeWeights &, const Answering &, Color &) const;

    Mesh mesh_;
    ClusterTree tree_;
    Fields fields_;
    Links links_, lampLinks_;
    std::vector<float> factor_; ///< Of what links_ bring, by node: closure.h.
    Answering indirect_, lamps_;
    SolverStatistics statistics_;
};

} // namespace candela::radiosity
