// SPDX-License-Identifier: Apache-2.0
// The field of a RiBlobby (RI 3.2, 5.6): blobs that fade out, and how they are combined. Its
// surface is where the field is the threshold, inside it is more.
#pragma once

#include "foundation/base/box3.h"
#include "foundation/base/diagnostics.h"
#include "foundation/base/matrix4.h"
#include "interface/ri/primitive_record.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// What one blob is on its surface, half of the way to where it ends: (1 - (1/2)^2)^3.
inline constexpr float blobThreshold = 0.421875f;

/// A value of the field and its gradient.
struct FieldValue {
    float value = 0;
    Vec3 gradient;
};

/// All values of a field somewhere, and perhaps more.
struct FieldBounds {
    float low = 0, high = 0;
};

/// (1 - r^2)^3 about a segment, whose ends may coincide; r = 1 at `radius` from it.
struct Blob {
    Vec3 from, to;
    float radius = 1;
    Matrix4 blobFromObject;
    Box3 bound; ///< In object space; it is 0 outside.

    /// Where P is beside it: how far along the segment, and how many radii away from it.
    struct Place {
        float along;
        Vec3 out;
    };
    Place placeOf(Vec3 P) const;
    FieldValue at(Vec3 P) const;
    FieldBounds over(const Box3 &) const;
};

/// A program: each instruction makes a value of those before it; the last is the field's.
class BlobField {
public:
    /// Nothing, with a report, if the program is wrong.
    static std::optional<BlobField> make(const BlobbyRecord &, const SourceLocation &,
                                         DiagnosticSink &);

    std::span<const Blob> blobs() const { return blobs_; }
    /// The field where blobs that do not reach into the box are left out: there it is the same, to
    /// the last bit.
    BlobField within(const Box3 &) const;

    FieldValue at(Vec3 P) const;
    /// What a value of it costs: its instructions and all that they combine.
    double cost() const { return double(instructions_.size() + operands_.size()); }
    /// Of the box.
    FieldBounds over(const Box3 &) const;
    /// How much of the field is each blob's at P: shares that add up to 1, or are all 0. By leaf.
    void sharesAt(Vec3 P, std::span<float> shares) const;
    int leaves() const { return leaves_; }
    /// By leaf; null: the leaf is none.
    std::vector<const Blob *> blobsOfLeaves() const;

private:
    enum class Kind : std::uint8_t {
        Constant,
        BlobLeaf,
        Add,
        Multiply,
        Maximum,
        Minimum,
        Subtract,
        Divide,
        Negate,
    };
    struct Instruction {
        Kind kind = Kind::Constant;
        float value = 0;        ///< Of a constant.
        std::uint32_t blob = 0; ///< Of a leaf, which is number `leaf`.
        int leaf = -1;
        std::uint32_t first = 0, operands = 0; ///< In operands_.
    };
    class Parser;

    std::span<const std::uint32_t> operandsOf(const Instruction &of) const {
        return {operands_.data() + of.first, of.operands};
    }
    FieldBounds bound(const Instruction &, const Box3 &,
                      std::span<const FieldBounds> earlier) const;
    FieldValue compute(const Instruction &, Vec3 P, std::span<const FieldValue> earlier) const;
    /// One an instruction.
    void computeAll(Vec3 P, std::vector<FieldValue> &values) const;

    std::vector<Blob> blobs_;
    std::vector<Instruction> instructions_;
    std::vector<std::uint32_t> operands_;
    int leaves_ = 0;
};

} // namespace candela
