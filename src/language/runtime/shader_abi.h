// SPDX-License-Identifier: Apache-2.0
// How compiled shaders are called. One function a question, one argument struct a call, a call a
// batch: structure of arrays, as Embree's filter functions have it. See docs/contracts.md.
//
// The interpreter (language/ir) and compiled code at every lane width read and write exactly the
// same memory, so a batch may be prepared at one width and answered at another.
#pragma once

#include "foundation/base/planes.h"
#include "foundation/units/color_basis.h"
#include "language/runtime/image_map.h"
#include "language/runtime/services.h"

#include <cstddef>
#include <cstdint>

namespace candela {

/// Values are partitioned by dependence: Surface (neither view nor light), View (depends on from
/// where the point is seen) and Response (depends on a light sample or an answer).
enum class BindingTime : std::uint8_t { Surface, View, Response };

/// Component planes in the order of shader_inputs.def: inputPlane("P") is the first of three.
enum class ShaderInput : std::uint16_t {
#define SHADER_INPUT(name, components, time, meaning) name, name##Last_ = name + components - 1,
#include "language/runtime/shader_inputs.def"
#undef SHADER_INPUT
    Count
};

/// Of an input's plane.
constexpr BindingTime bindingTimeOf(ShaderInput plane) {
#define SHADER_INPUT(name, components, time, meaning)                                              \
    if (plane <= ShaderInput::name##Last_)                                                         \
        return BindingTime::time;
#include "language/runtime/shader_inputs.def"
#undef SHADER_INPUT
    return BindingTime::Response;
}

/// Where slot `slot` of a lane stands in a frame that has `slots` of them: blocks of laneBlock
/// lanes, so that a question walks memory in one direction and the lane width does not matter.
constexpr std::size_t frameIndex(std::int32_t lane, int slot, int slots) {
    return (std::size_t(lane / laneBlock) * std::size_t(slots) + std::size_t(slot)) * laneBlock +
           std::size_t(lane % laneBlock);
}

/// Who is told of mistakes; what shaders ask for are services (services.h).
struct ShaderCallbacks {
    void *context = nullptr;
    /// An array is indexed outside its elements there: called from any thread, as often as it
    /// happens.
    void (*indexOutside)(void *context, const char *file, std::int32_t line) = nullptr;
    /// The loop there has run for as long as it may at some points, and has been ended: called from
    /// any thread, as often as it happens.
    void (*loopEnded)(void *context, const char *file, std::int32_t line) = nullptr;
    /// Nobody answers for the service that is asked there: called from any thread, as often as it
    /// happens.
    void (*serviceAbsent)(void *context, const char *service, const char *file,
                          std::int32_t line) = nullptr;
    /// A filter is at work: called from any thread, some thousand times a second or less. False:
    /// its loops are to end. Null = true.
    bool (*goOn)(void *context) = nullptr;
};

struct ShaderArgs;

/// Who runs a filter's pixel loops (ir/filter/pixel_loops.h).
struct PixelLoopRunner {
    void *context = nullptr;
    /// Runs loop `loop` of the filter. `given`: what ir::PixelLoop::given lists, `arrays`, those of
    /// PixelLoop::arrays; `results` gets those of PixelLoop::sums.
    void (*run)(void *context, std::int32_t loop, const float *given, const float *const *arrays,
                float *results) = nullptr;
};

/// Declared here only: world/shading/volume_lights.h.
class VolumeLights;

/// No question but finite light samples: see ShaderArgs::answeredRequest.
inline constexpr std::int32_t finiteRequests = -1;

/// While a call is under way, whole blocks of laneBlock lanes belong to it: where one lane of a
/// block is active, inputs and samples of all its lanes may be read, and inactive lanes of outputs
/// and frames may be written back as they were. So all planes (rows of samples too) have memory for
/// whole blocks, and no two calls at once share a block of an output or of a frame that they write.
/// What inactive lanes hold does not matter.
///
/// A lane of `view` is a view of a point, a lane of `scatter` a response to light for a view, of
/// all other questions a point (with a view, if they need one). `view` and `scatter` look up what
/// belongs to points or views at the lanes that surfaceLane and viewLane name: the frames, inputs
/// by their BindingTime, and as points' also parameterOffset, objectIndex and variables. So those
/// tables are the ones that the earlier question was given; nothing is copied from lane to lane.
/// All else, light above all, is given lane by lane.
struct ShaderArgs {
    std::int32_t count = 0;       ///< Lanes. Those from count up to the next multiple are inactive.
    std::int32_t sampleCount = 0; ///< `shade`: light samples a point.

    /// One bit a lane, 16 lanes a word; null = all lanes active.
    const std::uint16_t *active = nullptr;
    /// inputs[ShaderInput]: plane of floats, one for each point, view or response. Planes that the
    /// question doesn't read (see ir::Function::inputsRead) may be null.
    const float *const *inputs = nullptr;

    /// Instance parameters: lane i's block starts at parameters + parameterOffset[i].
    const float *parameters = nullptr;
    const std::int32_t *parameterOffset = nullptr;
    /// Planes of parameters that primitive variables override, in ir::Function::variables order.
    const float *const *variables = nullptr;

    /// Named coordinate systems in ir::Function::spaces order: 32 floats each, currentFromSpace
    /// and then spaceFromCurrent.
    const float *const *spaces = nullptr;
    /// "object" space of lane i: 32 floats at objectMatrices + 32 * objectIndex[i].
    const float *objectMatrices = nullptr;
    const std::int32_t *objectIndex = nullptr;

    /// Values saved between questions, at frameIndex(): what belongs to points, with
    /// ir::Function::surfaceSlots, and what belongs to views of them, with viewSlots. A question
    /// whose lanes are points writes at its lanes, and a view at its own. Null where questions.def
    /// says that the question has nothing to do with it.
    float *surfaceFrame = nullptr, *viewFrame = nullptr;
    /// `scatter`: which lane of the views' batch each lane responds for. Null = the same lane.
    const std::int32_t *viewLane = nullptr;
    /// `view`, `scatter`: which lane of the points' batch each *view* looks at (so `scatter` takes
    /// the very plane that `view` took). Null = the same lane. Both planes may name lanes again and
    /// again, in any order, and leave others out.
    const std::int32_t *surfaceLane = nullptr;
    /// Output planes in ir::Function::outputs order. Lanes that don't reach an output leave it
    /// as it was.
    float *const *outputs = nullptr;

    /// Colours have as many planes as ir::Function::colors has samples ("N" below).
    /// Light samples, `sampleCount` of them, each a row of `sampleStride` lanes: L (3 planes, from
    /// P to the light, any length) and Cl (N planes; zero = no light).
    const float *const *sampleL = nullptr;
    const float *const *sampleCl = nullptr;
    std::int32_t sampleStride = 0;
    /// Which light a sample comes from, rows as above: index + 1, 0 = indirect. Null = all 0.
    const std::int32_t *sampleLight = nullptr;
    /// May light l - 1 (0 = indirect) speak to loop category k (ir::Function::categories order)?
    /// One byte at categoryAccepts[k * (lightCount + 1) + l]. Null = yes to all.
    const std::uint8_t *categoryAccepts = nullptr;
    std::int32_t lightCount = 0;

    /// `scatter`: the light request that is answered with 1 in this lane: the number of a delta
    /// request, or finiteRequests = all finite ones get the sample along Input sampleL.
    const std::int32_t *answeredRequest = nullptr;
    /// `shade`: traced answers, planes [request * N + channel]; null = all black.
    const float *const *answers = nullptr;
    /// ambient(): N planes; null = black. irradiance(): likewise, W m^-2.
    const float *const *ambient = nullptr;
    const float *const *irradiance = nullptr;

    /// Filters: the maps, in ir::Function::maps order, each with its planes.
    const ImageMap *maps = nullptr;
    /// Numbers that are the same for all lanes, by Op::Captured, and arrays, by
    /// ir::Array::captured.
    const float *captured = nullptr;
    const float *const *capturedArrays = nullptr;
    /// Pixel loops: the column of the picture that lane 0 stands at; lanes go on from there.
    std::int32_t firstColumn = 0;
    const PixelLoopRunner *pixelLoops = nullptr;

    /// Volumes: who answers gatherlight and lightsample; null = it is dark.
    VolumeLights *volumeLights = nullptr;

    const ShaderCallbacks *callbacks = nullptr;
    const ShaderServices *services = nullptr;
};

using ShaderFunction = void (*)(const ShaderArgs *);

} // namespace candela
