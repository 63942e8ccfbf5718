// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/blob_field.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

FieldValue sum(FieldValue a, FieldValue b) { return {a.value + b.value, a.gradient + b.gradient}; }

FieldValue product(FieldValue a, FieldValue b) {
    return {a.value * b.value, a.gradient * b.value + b.gradient * a.value};
}

/// What is divided by nothing is nothing.
FieldValue quotient(FieldValue a, FieldValue b) {
    if (b.value == 0)
        return {};
    const float q = a.value / b.value;
    return {q, (a.gradient - b.gradient * q) * (1 / b.value)};
}

} // namespace

Blob::Place Blob::placeOf(Vec3 P) const {
    const Vec3 here = transformPoint(blobFromObject, P), way = to - from;
    const float squared = dot(way, way);
    const float along = squared > 0 ? std::clamp(dot(here - from, way) / squared, 0.0f, 1.0f) : 0;
    return {along, (here - from - way * along) * (1 / radius)};
}

FieldValue Blob::at(Vec3 P) const {
    const Vec3 out = placeOf(P).out;
    const float rest = 1 - dot(out, out);
    if (!(rest > 0))
        return {};
    // Gradients are covectors, as normals are.
    return {rest * rest * rest, transformNormal(blobFromObject, out * (-6 * rest * rest / radius))};
}

FieldValue BlobField::compute(const Instruction &of, Vec3 P,
                              std::span<const FieldValue> earlier) const {
    const auto operands = operandsOf(of);
    auto operand = [&](std::size_t i) { return earlier[operands[i]]; };
    auto pick = [&](auto isBetter) {
        FieldValue best = operand(0);
        for (std::size_t i = 1; i < operands.size(); ++i)
            if (isBetter(operand(i).value, best.value))
                best = operand(i);
        return best;
    };
    auto fold = [&](FieldValue start, auto combine) {
        for (std::size_t i = 0; i < operands.size(); ++i)
            start = combine(start, operand(i));
        return start;
    };
    switch (of.kind) {
    case Kind::Constant: return {of.value, {}};
    case Kind::BlobLeaf: return blobs_[of.blob].at(P);
    case Kind::Add: return fold({}, sum);
    case Kind::Multiply: return fold({1, {}}, product);
    case Kind::Maximum: return pick([](float a, float b) { return a > b; });
    case Kind::Minimum: return pick([](float a, float b) { return a < b; });
    case Kind::Subtract:
        return {operand(0).value - operand(1).value, operand(0).gradient - operand(1).gradient};
    case Kind::Divide: return quotient(operand(0), operand(1));
    case Kind::Negate: break;
    }
    return {-operand(0).value, -operand(0).gradient};
}

void BlobField::computeAll(Vec3 P, std::vector<FieldValue> &values) const {
    values.resize(instructions_.size());
    for (std::size_t i = 0; i < instructions_.size(); ++i)
        values[i] = compute(instructions_[i], P, values);
}

FieldValue BlobField::at(Vec3 P) const {
    thread_local std::vector<FieldValue> values;
    computeAll(P, values);
    return values.empty() ? FieldValue{} : values.back();
}

std::vector<const Blob *> BlobField::blobsOfLeaves() const {
    std::vector<const Blob *> blobs(std::size_t(leaves_), nullptr);
    for (const Instruction &of : instructions_)
        if (of.kind == Kind::BlobLeaf && of.leaf < leaves_)
            blobs[std::size_t(of.leaf)] = &blobs_[of.blob];
    return blobs;
}

void BlobField::sharesAt(Vec3 P, std::span<float> shares) const {
    std::ranges::fill(shares, 0.0f);
    std::vector<FieldValue> values;
    computeAll(P, values);
    // Backwards: by how much the field changes with each value.
    std::vector<float> slope(instructions_.size(), 0.0f);
    if (!slope.empty())
        slope.back() = 1;
    float all = 0;
    for (std::size_t i = instructions_.size(); i-- > 0;) {
        const Instruction &of = instructions_[i];
        const auto operands = operandsOf(of);
        switch (of.kind) {
        case Kind::Constant: break;
        case Kind::BlobLeaf:
            if (of.leaf >= 0 && of.leaf < int(shares.size())) {
                const float share = std::fabs(slope[i] * values[i].value);
                shares[std::size_t(of.leaf)] += share, all += share;
            }
            break;
        case Kind::Add:
            for (std::uint32_t operand : operands)
                slope[operand] += slope[i];
            break;
        case Kind::Multiply:
            for (std::size_t k = 0; k < operands.size(); ++k) {
                float others = slope[i];
                for (std::size_t other = 0; other < operands.size(); ++other)
                    others *= other == k ? 1 : values[operands[other]].value;
                slope[operands[k]] += others;
            }
            break;
        case Kind::Maximum:
        case Kind::Minimum:
            for (std::uint32_t operand : operands)
                if (values[operand].value == values[i].value) {
                    slope[operand] += slope[i];
                    break;
                }
            break;
        case Kind::Subtract: slope[operands[0]] += slope[i], slope[operands[1]] -= slope[i]; break;
        case Kind::Divide:
            if (const float by = values[operands[1]].value; by != 0) {
                slope[operands[0]] += slope[i] / by;
                slope[operands[1]] -= slope[i] * values[i].value / by;
            }
            break;
        case Kind::Negate: slope[operands[0]] -= slope[i]; break;
        }
    }
    for (float &share : shares)
        share = all > 0 ? share / all : 0;
}

static bool overlap(const Box3 &a, const Box3 &b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis])
            return false;
    return true;
}

BlobField BlobField::within(const Box3 &box) const {
    BlobField result;
    result.leaves_ = leaves_;
    // Where each instruction's value is now; constants are made as they are wanted.
    std::vector<std::uint32_t> place(instructions_.size());
    std::vector<bool> isZero(instructions_.size());
    auto emit = [&](Instruction instruction, std::vector<std::uint32_t> operands) {
        instruction.first = std::uint32_t(result.operands_.size());
        instruction.operands = std::uint32_t(operands.size());
        result.operands_.insert(result.operands_.end(), operands.begin(), operands.end());
        result.instructions_.push_back(instruction);
        return std::uint32_t(result.instructions_.size() - 1);
    };
    std::optional<std::uint32_t> zero;
    auto placeOf = [&](std::uint32_t number) {
        if (!isZero[number])
            return place[number];
        if (!zero)
            zero = emit({}, {});
        return *zero;
    };
    for (std::size_t i = 0; i < instructions_.size(); ++i) {
        Instruction of = instructions_[i];
        const auto operands = operandsOf(of);
        const auto zeroes = std::size_t(
            std::ranges::count_if(operands, [&](std::uint32_t k) { return isZero[k]; }));
        const bool all = zeroes == operands.size();
        switch (of.kind) {
        case Kind::Constant: isZero[i] = of.value == 0; break;
        case Kind::BlobLeaf: isZero[i] = !overlap(blobs_[of.blob].bound, box); break;
        case Kind::Multiply: isZero[i] = zeroes > 0; break;
        case Kind::Divide: isZero[i] = isZero[operands[0]] || isZero[operands[1]]; break;
        default: isZero[i] = all;
        }
        if (isZero[i])
            continue;
        std::vector<std::uint32_t> kept;
        for (std::uint32_t operand : operands)
            if (of.kind != Kind::Add || !isZero[operand])
                kept.push_back(placeOf(operand));
        const bool isPassedOn = of.kind == Kind::Add || of.kind == Kind::Maximum ||
                                of.kind == Kind::Minimum; // Where it is alone.
        if (isPassedOn && kept.size() == 1) {
            place[i] = kept[0];
            continue;
        }
        if (of.kind == Kind::BlobLeaf) {
            result.blobs_.push_back(blobs_[of.blob]);
            of.blob = std::uint32_t(result.blobs_.size() - 1);
        }
        place[i] = emit(of, std::move(kept));
    }
    // The last one's is the field's.
    if (!instructions_.empty()) {
        const std::uint32_t last = placeOf(std::uint32_t(instructions_.size() - 1));
        if (last + 1 != result.instructions_.size())
            emit({Kind::Add, 0, 0, -1, 0, 0}, {last});
    }
    return result;
}

} // namespace candela
