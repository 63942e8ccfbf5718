// SPDX-License-Identifier: Apache-2.0
// Pilots: samples over the frame that are thrown away, by which techniques are judged.
#pragma once

#include "light/bidir/light_vertices.h"
#include "light/bidir/light_wave.h"
#include "world/scene/emission_guide.h"

#include <array>
#include <optional>
#include <vector>

namespace candela {

/// A plan's error and cost, of one sample a pixel.
struct Trial {
    std::vector<double> variance; ///< Of the luminance, by cell of LightTally.
    std::vector<double> mean;
    double cost = 0; ///< In rays of camera paths.
};

double sumOf(const std::vector<double> &);

class Pilot {
public:
    explicit Pilot(FrameContext &);

    /// Of the frame.
    double pixels() const { return double(window_[1] - window_[0]) * (window_[3] - window_[2]); }
    Trial run(const BidirectionalPlan &);
    /// Light paths alone, one for each sample of a pixel, beside `path`.
    Trial runBesidePath();
    /// By cell, what `path` would at least make of the light that light paths have found.
    const std::vector<double> &varianceOfPath() const { return varianceOfPath_; }
    /// Vertices to connect with, a light path.
    double verticesPerPath();
    /// Where light paths begin best, from then on for all trials. After the trial of `path`.
    EmissionGuide learn(int rounds, bool besidePath = false);
    /// How vertices are merged where there are so many light paths a sample of a pixel.
    MergingPlan planMerging(double lightPaths);
    /// Light paths for each sample of a pixel that fill such rounds.
    double lightPathsOf(const MergingPlan &) const;

private:
    class NoMessages : public DiagnosticSink {
    public:
        void report(const Diagnostic &) override {}
    };

    FrameContext pilotFrame(TransportStatistics &, const PixelFilterSampler &);
    void choosePixels(int count);
    float widthOfPixels();
    void followLight(const BidirectionalPlan &, TransportStatistics &, LightVertices &, Trial &);
    void followCamera(PathWave &, Trial &);
    void setMeanOfPath(const Trial &);

    FrameContext &frame_;
    IntegratorSettings settings_;
    std::array<int, 4> window_;
    const std::vector<ChannelInfo> light_{{"Ci", colorSamples}, {"Oi", colorSamples}};
    NoMessages silence_;
    /// All samples of a pixel see one place of it: edges are noise whatever the plan.
    PixelFilterSampler middle_;
    std::vector<int> x_, y_;
    std::vector<double> varianceOfPath_, meanOfPath_;
    bool findsLight_ = false; ///< `path` does.
    std::optional<EmissionGuide> guide_;
};

} // namespace candela
