// SPDX-License-Identifier: Apache-2.0
// Motion blocks (RI 3.2, section 6): what their requests say is put to use at the end.
#include "interface/ri/state_handlers.h"

#include <algorithm>

namespace candela {

void StateHandlers::beginMotion(const std::vector<double> &times) {
    motion_ = OpenMotion{};
    motion_->times = times;
}

/// As many values as there are times.
template <class Value>
static SharedInTime<Value> inTime(const std::vector<double> &times,
                                  const std::vector<Value> &values) {
    InTime<Value> result{times, values};
    const std::size_t known = std::min(times.size(), values.size());
    result.times.resize(known), result.values.resize(known);
    return known > 1 ? std::make_shared<const InTime<Value>>(std::move(result)) : nullptr;
}

void StateHandlers::endMotion(const SourceLocation &where) {
    if (!motion_)
        return;
    const OpenMotion motion = std::move(*motion_);
    motion_.reset();
    if (!motion.samples.empty())
        endTransformation(where, motion);
    if (!motion.shaders.empty()) {
        ShaderRecord record = motion.shaders.front();
        std::vector<ParameterList> lists;
        for (const ShaderRecord &sample : motion.shaders)
            lists.push_back(sample.parameters);
        record.motion = inTime(motion.times, lists);
        motion.useShader(std::move(record));
    }
    if (!motion.primitives.empty()) {
        PrimitiveRecord record = *motion.primitives.front();
        record.motion = inTime(motion.times, motion.primitives);
        const auto isLike = [&](const auto &other) { return canBecome(record, *other); };
        if (record.motion && !std::ranges::all_of(motion.primitives, isLike)) {
            diagnostics_.error(where, "MotionEnd",
                               "the primitives of a motion block must have the same counts and "
                               "variables; it is drawn as it is at the first time");
            record.motion = nullptr;
        }
        tellPrimitive(std::make_shared<const PrimitiveRecord>(std::move(record)));
    }
}

void StateHandlers::endTransformation(const SourceLocation &where, const OpenMotion &motion) {
    CurrentTransform around = motion.fromBase ? state_.transform.base : state_.transform.current;
    MotionBlock block{motion.times, motion.samples};
    const std::size_t samples = std::min(block.times.size(), block.samples.size());
    block.times.resize(samples), block.samples.resize(samples);
    const TransformDefect defect =
        samples == 1 ? candela::concatenate(around, block.samples.front().factor())
                     : candela::concatenate(around, std::make_shared<const MotionBlock>(block),
                                            state_.options.camera.shutterOpen);
    report(where, "MotionEnd", defect);
    if (defect == TransformDefect::None)
        state_.transform.current = around;
}

bool StateHandlers::addToMotion(const Color &value, Color &first, SharedInTime<Color> &all) {
    if (!motion_)
        return false;
    motion_->colors.push_back(value);
    first = motion_->colors.front();
    all = inTime(motion_->times, motion_->colors);
    return true;
}

void StateHandlers::withMotion(ShaderRecord record, std::function<void(ShaderRecord)> use) {
    if (!motion_)
        return use(std::move(record));
    motion_->shaders.push_back(std::move(record));
    motion_->useShader = std::move(use);
}

void StateHandlers::tellPrimitive(std::shared_ptr<const PrimitiveRecord> primitive) {
    object_.tell(
        PlacedPart{std::move(primitive), -1, state_.attributes, state_.currentFromObject()});
}

} // namespace candela
