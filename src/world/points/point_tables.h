// SPDX-License-Identifier: Apache-2.0
// What shading points are made from: shapes, where instances place them, how they look, and the
// codes that shade them.
#pragma once

#include "foundation/base/motion_steps.h"
#include "foundation/units/color.h"
#include "interface/ri/level_of_detail.h"
#include "world/camera/camera.h"
#include "world/shading/shader_library.h"
#include "world/shapes/shape.h"

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace candela {

/// What every point needs to know of the shape it lies on as it is placed and attributed there: a
/// cache line.
struct alignas(64) Appearance {
    std::int32_t parameterOffset = 0; ///< Of the surface shader's parameter block.
    std::int32_t lightSet = 0;        ///< Which lights shine on it.
    std::int32_t light = 0;           ///< The light that it is: index + 1, 0 = none.
    std::int32_t id = 0;              ///< What the channel "id" shows, from 1; + the instance's.
    float normalSign = 1;             ///< -1: the natural normal is turned round.
    float elementSign = 1;            ///< Shape::elementSign times normalSign.
    float offset = 0;                 ///< Shape::offset.
    float offsetShare = 0;            ///< Shape::offsetShare.
    std::array<float, colorSamples> Cs{};
    std::int32_t firstElement = -1; ///< Lights only: of its own in LightTable::elements.
    std::array<float, colorSamples> Os{};
    std::int32_t code = 0; ///< Index into PointTables::codes.
};

/// The rest of an appearance, which few points ask for.
struct AppearanceDetail {
    std::shared_ptr<const Attributes> attributes;
    /// For each distinct name in the code's variables: which variable of the surface it is.
    std::vector<int> overriding;
    Visibility visibility;
    Presence presence;
    /// Cs and Os at even steps over the shutter's interval; empty: as the appearance has them.
    std::vector<Color> colors, opacities;
};

/// A placed object, or what moves together in the world. Its shapes are consecutive, and so are
/// their appearances.
struct Instance {
    std::uint32_t firstShape = 0, shapes = 0;
    std::int32_t firstAppearance = 0;
    std::int32_t firstId = 0;
    float stretch = 1;                      ///< The largest factor by which it stretches lengths.
    float handedness = 1;                   ///< -1: it mirrors.
    std::uint32_t firstStep = 0, steps = 0; ///< In PointTables::steps; none where it stands still.
};

/// Inputs that evaluation may leave out.
struct WantedInputs {
    bool dPd = false, dNd = false, uv = false, footprint = false, st = false, Cs = false;
    bool Os = false, stDerivatives = false, orientation = false, E = false;
    bool dNg = false, dCs = false, dOs = false;

    /// Adds what a shader reads, as ir::Function::inputsRead has it.
    void add(const std::vector<bool> &inputsRead);
    /// Nothing but position, normals and colours: elements that are flat tell all.
    bool isPlain() const { return !(dPd || dNd || dNg || dCs || dOs || uv || footprint || st); }
};

/// A surface shader's code and what was worked out about it once.
struct SurfaceCode {
    std::shared_ptr<ShaderCode> code;
    /// Distinct names among the code's variables, and for each variable plane its name's number.
    std::vector<std::string> variableNames;
    std::vector<int> variableName, variableComponent;
    /// What each plane holds: 0 the values, 1 and 2 their derivatives by u and v.
    std::vector<int> variableSlope;
    /// What this code reads, and the shaders of area lights on its shapes.
    WantedInputs wanted;
    bool readsObjectSpace = false;
    /// It shades what it has displaced itself: ShadingPoints::unmovedTable.
    bool movesPoints = false;
    /// All points of it are told by the elements alone, without asking surfaces.
    bool fromElements = false;
};

/// The surface's points are to tell what another shader that is asked there reads, too.
void addNeeds(const ShaderCode &, SurfaceCode &);
/// `asked`: the functions that are asked read no more than this one; by default the whole text.
SurfaceCode surfaceCode(std::shared_ptr<ShaderCode>, const ir::Function *asked = nullptr);

/// Names of the surface's variables that override parameters of their name: those that are no
/// shader inputs.
std::set<std::string> overridingNames(const Surface &);

struct PointTables {
    std::vector<Shape> shapes; ///< First those of the world, then those of objects.
    std::uint32_t worldShapes = 0;
    std::vector<float> shapeMatrices; ///< Of the world's shapes: 32 floats each, see ShaderArgs.
    std::vector<Instance> instances;
    /// currentFromObject and its inverse, when the shutter opens: 32 floats each.
    std::vector<float> instanceMatrices;
    std::vector<Matrix4> steps; ///< Where moving instances are over the shutter's interval.
    Shutter shutter;
    bool shapesChange = false;           ///< While the shutter is open.
    bool colorsChange = false;           ///< So do some of AppearanceDetail::colors or opacities.
    std::vector<Appearance> appearances; ///< Those of the world's shapes first, in their order.
    std::vector<AppearanceDetail> details;
    std::vector<SurfaceCode> codes;

    /// Index of the appearance of a shape; `instance` = noHit in the world.
    std::int32_t appearanceOf(std::uint32_t instance, std::uint32_t shape) const {
        if (instance == noHit)
            return std::int32_t(shape);
        return instances[instance].firstAppearance +
               std::int32_t(shape - instances[instance].firstShape);
    }
    Matrix4 currentFromShape(std::uint32_t instance, std::uint32_t shape, float time) const;
    /// False where all stands still: times need not be looked at.
    bool anythingMoves() const { return !steps.empty() || shapesChange; }
    std::span<const Matrix4> stepsOf(std::uint32_t instance) const {
        const Instance &placed = instances[instance];
        return {steps.data() + placed.firstStep, placed.steps};
    }
    /// currentFromObject and its inverse at that time: 32 floats.
    void placeAt(std::uint32_t instance, float time, float *matrices) const;
    const float *matricesOf(std::uint32_t instance) const {
        return instanceMatrices.data() + 32 * std::size_t(instance);
    }
};

} // namespace candela
