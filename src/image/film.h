// SPDX-License-Identifier: Apache-2.0
// Where samples become pixels. Sums are double, a pixel's batches are added in the order of their
// samples and pixels share nothing, so a pixel depends on its own samples and batches alone.
#pragma once

#include "image/film_splats.h"
#include "image/picture.h"
#include "image/resumable_sink.h"

#include <atomic>
#include <cstdint>
#include <memory>

namespace candela {

enum class FilmHalf { Both, Even, Odd };

/// What is known of one component in one block of samples.
struct FilmMoments {
    double count, weights, weighted, plain; ///< n, sum of w, of w v, of v.
};

/// How many samples pixels have.
struct SampleCounts {
    int least = 0, most = 0;
    double mean = 0;
};

class Film : public ResumableSink {
public:
    struct Settings {
        FrameWindow window; ///< Only its pixels are stored; samples of others are ignored.
        /// Wanted beside Ci and Oi, which are always there. "z" becomes the minimum over the
        /// samples (RI 3.2, 4.1), "id" that of sample 0, every other channel the filtered mean.
        std::vector<ChannelInfo> channels;
        bool signedWeights = false; ///< The pixel filter has negative lobes.
        bool keepHalves = false;    ///< Even and odd samples are wanted on their own, too.
        /// Even and odd samples know nothing of each other and may differ in number
        /// (light/frame/adaptive_sampling.h): a mean is that of the means of both.
        bool pairsHalves = false;
        bool splats = false; ///< Splats will come, too; else they are ignored.
        SplatUnits splatUnits{commonSplatUnit, commonSplatUnit, commonSplatUnit};
    };
    explicit Film(Settings);
    /// What a film of these settings takes.
    static double bytesNeeded(Settings);

    std::span<const ChannelInfo> channels() const override { return channels_; }
    void add(const SampleBatch &) override;
    void add(const SplatBatch &) override;
    void save(std::string &bytes) const override;
    bool restore(std::string_view &bytes) override;

    const FrameWindow &window() const { return settings_.window; }
    bool keepsHalves() const { return settings_.keepHalves; }

    /// Index in channels(), or -1.
    int channelIndex(std::string_view name) const;

    /// Component `component` of a channel over the window. Without samples a pixel is 0 (z: the
    /// largest float). Under a filter with negative lobes the mean stays exact for constants.
    /// Halves: only if kept; z, id and the light that came in splats have none.
    std::vector<float> mean(int channel, int component, FilmHalf = FilmHalf::Both) const;

    /// Variance of the pixel means of Ci, estimated as for independent samples, which is an upper
    /// estimate for stratified ones; infinite for a pixel of fewer than two samples.
    std::vector<float> varianceOfMean(int component) const;

    /// Samples whose value was NaN or infinite, counted once for each component. They count as 0.
    std::uint64_t nonFiniteSamples() const;
    /// Of the pixels of the window.
    SampleCounts sampleCounts() const;
    /// The means of all components of a channel are 0 in every pixel.
    bool isZero(int channel) const;
    /// Null unless wanted.
    const FilmSplats *splats() const { return splats_.get(); }

private:
    /// How the samples of a component become one value.
    enum class Merge { Mean, Nearest, First };
    /// A pixel's doubles: the block of all samples, that of the even ones if kept, then the sums of
    /// squares. A block is count, sum of weights, weighted sums and, if signed, plain sums.
    struct Layout {
        std::vector<int> firstComponent; ///< Of each channel in the batch's planes.
        std::vector<Merge> merge;        ///< Of each component.
        int components = 0, block = 0, squares = 0, stride = 0;
    };
    /// Samples [first, last) of a batch, all of one pixel.
    struct Run {
        const SampleBatch &batch;
        int first, last;
    };
    void addRun(double *pixel, const Run &);
    void addToBlock(double *block, const Run &, bool evenOnly);
    /// Non-finite values are left out and counted.
    double addComponent(double sum, const Run &, int component, bool evenOnly, bool weighted);
    static Merge mergeOf(const ChannelInfo &);
    static double addSingle(Merge, double value, const Run &, int component);
    FilmMoments moments(const double *pixel, int slot, FilmHalf) const;
    double shareOfHalves(const double *pixel) const;
    float meanOfMoments(const FilmMoments &) const;
    float value(const double *pixel, int slot, FilmHalf) const;
    float meanOfPixel(std::size_t pixel, int channel, int component, FilmHalf) const;

    Settings settings_;
    std::vector<ChannelInfo> channels_;
    Layout layout_;
    std::vector<double> sums_;
    std::unique_ptr<FilmSplats> splats_;
    std::atomic<std::uint64_t> nonFinite_{0};
};

} // namespace candela
