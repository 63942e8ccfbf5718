// SPDX-License-Identifier: Apache-2.0
// RiCurves (RI 3.2, 5.6) as surfaces.
#pragma once

#include "world/geometry/curve_section.h"
#include "world/geometry/dice_counts.h"
#include "world/geometry/surface.h"

#include <mutex>

namespace candela {

/// A query's piece is a segment, its v runs along it, u across. Shaders' v runs along the whole
/// curve. Curves with normals are ribbons across them; others are tubes, which look as wide as they
/// are from everywhere: u is once around.
class CurvesSurface final : public Surface {
public:
    /// `position` and `width` fit the layout, `variables` too.
    CurvesSurface(CurveLayout, NumericVariable position, NumericVariable width,
                  std::vector<NumericVariable> variables, std::optional<NumericVariable> normal,
                  const std::array<float, 8> &textureCoordinates);
    /// Curves that change their shape, which are these at even steps over the shutter's interval.
    /// All have one layout, and variables alike.
    explicit CurvesSurface(const std::vector<std::shared_ptr<const Surface>> &steps);

    Box3 bound() const override { return bound_; }
    SurfaceDomain domain() const override { return {layout_.segments(), false}; }
    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override;
    float area() const override;
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    bool isRound() const override { return !normal_; }
    bool isStroke() const override { return !normal_; }
    RoundElements roundElements() const override;
    void nameRound(int count, const Vec3Planes &P, const float *share, std::uint32_t *piece,
                   float *u, float *v) const override;
    int steps() const override { return 1 + (times_ - 1) * finer_; }
    std::shared_ptr<const Surface> step(int number) const override;
    bool hasOwnNormals() const override { return normal_.has_value(); }
    std::span<const VariableInfo> variables() const override { return infos_; }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    /// What these are then, and remain.
    CurvesSurface(const CurvesSurface &, Moment);

    CurveSegment segmentOf(std::uint32_t number, int time) const;
    CurveSegment segmentAt(std::uint32_t number, Moment) const;
    /// work(number, segment) for all segments at all steps.
    template <class Do> void forSegments(Do work) const {
        for (int time = 0; time < times_; ++time)
            for (std::uint32_t i = 0; i < layout_.segments(); ++i)
                work(i, segmentOf(i, time));
    }
    /// All that change with time, each with values of its own.
    std::vector<NumericVariable *> numbers();
    void shareWidth();
    const NumericVariable &width() const {
        return sharedWidth_ < 0 ? width_ : variables_[std::size_t(sharedWidth_)];
    }
    SectionPoint pointOn(const CurveSegment &, std::uint32_t number, float u, float v) const;
    Vec3 normalOn(const CurveSegment &, std::uint32_t number, float u, float v) const;
    void answerNormals(const CurveSegment &, const SurfaceQuery &, int k,
                       const SurfaceAnswer &) const;
    void chooseAxes();
    /// That angles on the tube are counted from.
    Vec3 axisOf(std::uint32_t segment) const {
        Vec3 axis;
        axis[axes_[layout_.curveOf(segment)]] = 1;
        return axis;
    }
    void measure();
    int chooseFiner() const;
    void extendLine(std::uint32_t number, int time, CurveSegment &) const;
    /// Of the segment that bends and is wide the most.
    const DerivativeBounds &steepest() const;
    DiceCounts countsAt(const DiceRate &) const;

    CurveLayout layout_;
    NumericVariable position_, width_;
    std::vector<NumericVariable> variables_;
    std::vector<VariableInfo> infos_;
    std::optional<NumericVariable> normal_;
    std::array<float, 8> textureCoordinates_;
    int defaultS_ = -1, defaultT_ = -1; ///< Places of the default s and t in infos_.
    int sharedWidth_ = -1;              ///< Which of the variables is the width; -1: width_ is.
    std::vector<std::uint8_t> axes_;    ///< By curve: the axis that it runs along least.
    int times_ = 1;                     ///< How many steps the variables have the values of.
    /// Steps of triangles a step of the values: between theirs points go straight, which those of
    /// tubes and ribbons that turn do not.
    int finer_ = 1;
    int splits_ = 1; ///< Round elements a segment.
    Box3 bound_;
    mutable std::once_flag bounded_;
    mutable DerivativeBounds steepest_;
};

} // namespace candela
