// SPDX-License-Identifier: Apache-2.0
// For tests: points, each seen by several views, each asked for several responses, as both ends of
// paths ask. The batches are tied by index planes in random order; the same lanes can be had with
// all that they look at copied to them.
#pragma once

#include "language/ir/interpret/test_batch.h"
#include "language/ir/questions/questions.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace candela::ir {

class ViewedBatch {
public:
    using Lanes = std::vector<std::int32_t>;
    using Planes = std::vector<TestPlane>;
    using Run = std::function<void(const Function &, const ShaderArgs &)>;
    static constexpr int pointCount = 21, viewsOfPoint = 3, responsesOfView = 4;

    ViewedBatch(const Function &whole, unsigned seed)
        : points(whole, pointCount, seed), views(whole, pointCount * viewsOfPoint, seed + 1),
          responses(whole, pointCount * viewsOfPoint * responsesOfView, seed + 2), whole_(whole),
          bits_(seed) {
        views.answers.givesAmbient = true;
        activate(points);
        surfaceLane = shuffled(points, views);
        activate(views, surfaceLane);
        viewLane = shuffled(views, responses);
        activate(responses, viewLane);
        for (int i = 0; i < responses.padded(); ++i)
            responses.samples.light.push_back(i % 3);
        responses.samples.lightCount = 2;
        responses.samples.categoryAccepts.assign(3 * whole.categories.size(), 0);
        for (std::size_t i = 0; i < responses.samples.categoryAccepts.size(); i += 2)
            responses.samples.categoryAccepts[i] = 1;
    }

    static bool isActive(const TestBatch &batch, int lane) {
        return lane < batch.count && (batch.active[std::size_t(lane / 16)] >> (lane % 16) & 1);
    }

    /// Asks about the points; forgets all that frames have held.
    void askPoints(const Function &surface, const Run &run) {
        constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
        points.frames.clear(surface, points.padded(), nothing);
        views.frames.clear(surface, views.padded(), nothing);
        points.run(surface, [&](const Function &function, ShaderArgs args) {
            args.viewFrame = nullptr;
            const auto inputs = inputsOf(function, points);
            args.inputs = inputs.data();
            run(function, args);
        });
    }
    Planes askViews(const Function &view, const Run &run) {
        return views.run(view, [&](const Function &function, ShaderArgs args) {
            const auto inputs = inputsOf(function, views);
            args.inputs = inputs.data();
            args.surfaceLane = surfaceLane.data();
            askOfPoints(function, args, run);
        });
    }
    Planes askResponses(const Function &scatter, const Run &run) {
        return responses.run(scatter, [&](const Function &function, ShaderArgs args) {
            const auto inputs = inputsOf(function, responses);
            args.inputs = inputs.data();
            args.surfaceLane = surfaceLane.data();
            args.viewLane = viewLane.data();
            args.viewFrame = views.frames.view.data();
            askOfPoints(function, args, run);
        });
    }

    /// The views with their points' data, the responses with their views' and points' data.
    TestBatch copiedViews() { return copied(views, surfaceLane, ownLanes(views)); }
    TestBatch copiedResponses() {
        Lanes surface(viewLane.size());
        for (int i = 0; i < responses.count; ++i)
            if (isActive(responses, i))
                surface[std::size_t(i)] = surfaceLane[std::size_t(viewLane[std::size_t(i)])];
        return copied(responses, surface, viewLane);
    }

    TestBatch points, views, responses;
    Lanes surfaceLane, viewLane; ///< Of views and of responses.

private:
    /// What no lane may look at.
    static constexpr std::int32_t nowhere = 1 << 29;

    static Lanes ownLanes(const TestBatch &batch) {
        Lanes lanes;
        for (int i = 0; i < batch.padded(); ++i)
            lanes.push_back(i);
        return lanes;
    }

    /// Lanes of `batch` that look at the active ones of `at`, equally often, in any order.
    Lanes shuffled(const TestBatch &at, const TestBatch &batch) {
        Lanes lanes;
        while (int(lanes.size()) < batch.count)
            for (int i = 0; i < at.count && int(lanes.size()) < batch.count; ++i)
                if (isActive(at, i))
                    lanes.push_back(i);
        std::shuffle(lanes.begin(), lanes.end(), bits_);
        lanes.resize(std::size_t(batch.padded()), nowhere);
        return lanes;
    }

    /// Some lanes, among them a block's all.
    void activate(TestBatch &batch) {
        for (int word = 0; word < batch.padded() / laneBlock; ++word)
            batch.active.push_back(std::uint16_t(word == 1 ? 0xffff : bits_() | 1));
    }
    /// The others look nowhere.
    void activate(TestBatch &batch, Lanes &lanes) {
        activate(batch);
        for (int i = 0; i < batch.padded(); ++i)
            if (!isActive(batch, i))
                lanes[std::size_t(i)] = nowhere;
    }

    const TestBatch &batchOf(BindingTime time) const {
        return time == BindingTime::Surface ? points
               : time == BindingTime::View  ? views
                                            : responses;
    }

    /// What a question is said to read. Of views and responses a question about points has its own.
    std::vector<const float *> inputsOf(const Function &function, const TestBatch &own) const {
        std::vector<const float *> planes;
        for (std::size_t plane = 0; plane < own.inputs.size(); ++plane) {
            const BindingTime time = bindingTimeOf(ShaderInput(plane));
            const TestBatch &from = time < function.lanes ? batchOf(time) : own;
            planes.push_back(function.inputsRead[plane] ? from.inputs[plane].data() : nullptr);
        }
        return planes;
    }

    void askOfPoints(const Function &function, ShaderArgs args, const Run &run) {
        args.parameters = points.parameters.data();
        args.parameterOffset = points.parameterOffset.data();
        args.objectMatrices = points.objects.data();
        args.objectIndex = points.objectIndex.data();
        args.surfaceFrame = points.frames.surface.data();
        std::vector<const float *> variables, spaces;
        for (const TestPlane &plane : points.variables)
            variables.push_back(plane.data());
        for (const TestPlane &space : points.spaces)
            spaces.push_back(space.data());
        args.variables = variables.data();
        args.spaces = spaces.data();
        run(function, args);
    }

    TestBatch copied(const TestBatch &own, const Lanes &surface, const Lanes &view) const {
        TestBatch copy = own;
        copy.parameters = points.parameters, copy.spaces = points.spaces;
        copy.objects = points.objects;
        for (std::size_t i = 0; i < std::size_t(own.count); ++i) {
            if (!isActive(own, int(i)))
                continue;
            const auto at = std::size_t(surface[i]);
            copy.parameterOffset[i] = points.parameterOffset[at];
            copy.objectIndex[i] = points.objectIndex[at];
            for (std::size_t k = 0; k < points.variables.size(); ++k)
                copy.variables[k][i] = points.variables[k][at];
            for (std::size_t plane = 0; plane < own.inputs.size(); ++plane) {
                const BindingTime time = bindingTimeOf(ShaderInput(plane));
                if (time != BindingTime::Response)
                    copy.inputs[plane][i] =
                        batchOf(time)
                            .inputs[plane][time == BindingTime::View ? std::size_t(view[i]) : at];
            }
        }
        return copy;
    }

    const Function &whole_;
    std::mt19937 bits_;
};

} // namespace candela::ir
