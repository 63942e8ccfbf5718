// SPDX-License-Identifier: Apache-2.0
// A wave of paths from lights. They are numbered within a frame, so that a path does not depend on
// the wave it travels in.
#pragma once

#include "light/bidir/far_media.h"
#include "light/bidir/light_vertices.h"
#include "light/bidir/pixel_choice.h"
#include "light/path/wave.h"
#include "world/scene/light_starts.h"

#include <cstdint>
#include <vector>

namespace candela {

/// Where the camera sees light vertices, and what it sees.
struct LightImage {
    explicit LightImage(int capacity);

    Camera::Sights sights;
    Planes<float> floats;
    Planes<float> response, seen; ///< The answer; what a splat is worth.
    float *pathGain;              ///< The square of what `path` finds of it over that of a splat.
    Planes<std::int32_t> integers;
    std::int32_t *answered, *lane;
    RayBatch rays;
    FarMedia media;
    Planes<float> ways;
    MutableVec3Planes towardsLens, end;
    Planes<float> transmittance;
    std::vector<float> x, y;
    std::array<std::vector<float>, colorSamples> splats;
};

/// What the stage `receive` works with.
struct LightArrival {
    explicit LightArrival(int capacity);

    Planes<float> floats;
    MutableVec3Planes place; ///< On the light.
    float *choice, *u, *v, *pdf, *scattered;
    Planes<std::int32_t> integers;
    std::int32_t *light, *source,
        *element;                ///< Of the vertices' first scattering; 0, -1, -1 of others.
    std::int32_t *withoutExtent; ///< The light, if it is no surface.
    LightSampleStorage given;
};

/// x0, x1, y0, y1 of what pilots look at: crop windows are parts of the same picture.
std::array<int, 4> wholeFrame(const Scene &);

/// What a pilot wants to know of splats, by cells of the frame.
struct LightTally {
    static constexpr int cells = 16; ///< Along each side.
    struct Cell {
        double sum = 0, squares = 0; ///< Of the splats' luminance.
        double pathSquares = 0;      ///< What `path` would make of the light that it seldom finds.
        double seldom = 0; ///< Found so seldom is what has more luminance than this in a sample.
    };
    /// What one path has brought, and how far beyond the frame, in frames.
    struct Splat {
        int slot, cell; ///< Cell -1: near the frame.
        double luminance, beyond;
    };
    LightTally(const std::array<int, 4> &frame, double samples)
        : frame(frame), samples(samples), values(cells * cells) {}
    /// Of a raster position; -1 = beyond the frame.
    int cellAt(float x, float y) const;
    /// How far beyond the frame, in frames.
    double beyondFrame(float x, float y) const;

    std::array<int, 4> frame;
    double samples; ///< Splats over this are shares of a pixel's sample.
    std::vector<Cell> values;
    bool keepsSplats = false;
    double reach = 0;          ///< How far beyond the frame splats are kept, in frames.
    std::vector<Splat> splats; ///< If they are wanted.
};

struct LightWave : PathWave {
    LightWave(FrameContext &, const TechniqueCounts &, SampleSink &);

    SampleSink &sink;
    LightStarts starts;       ///< By slot, for the first surface that the path meets.
    Planes<float> brightness; ///< Likewise: what roulette measures throughputs by.
    LightImage image;
    VertexView tilted; ///< Of the chunk's vertices, for the ratio of refraction.
    LightArrival arrival;
    PixelChoice pixels;
    std::vector<LightVertex> kept;
    bool keeps = true;           ///< Vertices are wanted.
    LightTally *tally = nullptr; ///< Of pilots.
};

/// Starts the light paths [first, first + count) of the frame.
void startLight(LightWave &, std::int64_t first, int count);
/// Finds out what they begin in, in scenes with volumes.
void enterMedia(LightWave &);
/// The stages of light paths.
std::span<const Stage> stagesOfLight(const PathWave &, const ShaderCode &);

// ---- Stages ----

/// What volumes let through of the segments to the vertices.
void crossAgainstLight(PathWave &);
/// What the first surfaces get from the lights, and how likely light samples would have found it.
void receive(PathWave &);
/// The shader as the light sees it, and what the eye would see through it.
void askAgainstLight(PathWave &);
/// Keeps vertices to be connected with.
void keep(PathWave &);
/// Connects vertices with the lens.
void showToCamera(PathWave &);
/// Paths go on along all that the surface does with light, by what the eye would see of it.
void scatterLight(PathWave &);

} // namespace candela
