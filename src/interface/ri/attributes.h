// SPDX-License-Identifier: Apache-2.0
// The attributes of a primitive: what the graphics state hands on with each. Records are
// immutable once emitted and shared between the primitives that have them in common.
#pragma once

#include "foundation/base/matrix4.h"
#include "foundation/units/color.h"
#include "interface/ri/motion_of_numbers.h"
#include "interface/ri/parameter_list.h"
#include "interface/ri/transform_motion.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace candela {

/// A transformation in time.
struct MotionTransform {
    Matrix4 matrix; ///< When the shutter opens.
    /// Null: it stands still. Of objects that are defined outside of worlds this alone counts, as
    /// the shutter may be set after them.
    TransformMotion::Shared motion;

    bool moving() const { return motion != nullptr; }
    const Matrix4 &atOpen() const { return matrix; }
};

/// A shader as bound in the RIB: where its "shader" space stood then, and its parameters.
struct ShaderRecord {
    std::string name;
    ParameterList parameters;
    MotionTransform currentFromShader;
    /// The parameters in time, those above the first; null: they stay the same.
    SharedInTime<ParameterList> motion;
};

enum class LightUnits { Classic, Si }; ///< DESIGN section 4.

struct LightRecord {
    int index = 0; ///< Order of declaration, from 0; names the light in Attributes::lightsOn.
    std::string handle;
    bool area = false; ///< AreaLightSource: the primitives that carry it are its geometry.
    ShaderRecord shader;
    LightUnits units = LightUnits::Classic;
    bool shadows = false; ///< Attribute "light" "string shadows" ["on"].
    /// Illuminate has turned it off somewhere: who finds it dark has meant it.
    std::shared_ptr<bool> isTurnedOff = std::make_shared<bool>(false);
};

/// RiBasis: a 4x4 matrix (rows = powers from u^3 down, as RI writes it) and its step.
struct BasisRecord {
    std::array<float, 16> matrix{-1, 3, -3, 1, 3, -6, 3, 0, -3, 3, 0, 0, 1, 0, 0, 0};
    int step = 3;
};

/// Attributes that an object may set for its own shapes.
namespace own {
inline constexpr std::uint32_t Color = 1;
inline constexpr std::uint32_t Opacity = 2;
inline constexpr std::uint32_t Surface = 4;
inline constexpr std::uint32_t Displacement = 8;
inline constexpr std::uint32_t Atmosphere = 16;
inline constexpr std::uint32_t Interior = 32;
inline constexpr std::uint32_t Exterior = 64;
inline constexpr std::uint32_t Deformation = 128;
inline constexpr std::uint32_t ShadingRate = 256;
inline constexpr std::uint32_t Interpolation = 512;
inline constexpr std::uint32_t Matte = 1024;
inline constexpr std::uint32_t Sides = 2048;
inline constexpr std::uint32_t Named = 4096; ///< Some of RiAttribute: Attributes::ownNames.
inline constexpr std::uint32_t Detail = 8192;
inline constexpr std::uint32_t DetailRange = 16384;
} // namespace own

/// RiDetail: the box whose size in the picture says what is drawn.
struct DetailRecord {
    std::array<float, 6> bound{}; ///< xMin, xMax, yMin...
    Matrix4d outerFromBound;
    bool ofObject = false; ///< Outer space is that of the object being defined, not current space.
};

struct Attributes {
    Color color{1.0f};
    Color opacity{1.0f};
    SharedInTime<Color> colorMotion, opacityMotion; ///< Null: they stay the same.
    /// s,t at (u,v) = (0,0), (1,0), (0,1), (1,1).
    std::array<float, 8> textureCoordinates{0, 0, 1, 0, 0, 1, 1, 1};
    std::shared_ptr<const ShaderRecord> surface; ///< Null = "defaultsurface".
    std::shared_ptr<const ShaderRecord> displacement, atmosphere, interior, exterior;
    std::shared_ptr<const ShaderRecord> deformation; ///< Moves points before displacement does.
    std::shared_ptr<const LightRecord> areaLight;    ///< Non-null: the primitive emits.
    std::vector<int> lightsOn;                       ///< Indices of LightRecord, ascending.
    float shadingRate = 1;
    bool smoothInterpolation = false;
    bool matte = false;
    int sides = 2;
    std::shared_ptr<const DetailRecord> detail; ///< Null: as large as can be.
    /// RiDetailRange: from the first to the last of these areas, in pixels, it is drawn; up to the
    /// second and from the third on it is dissolved.
    std::array<float, 4> detailRange{0, 0, std::numeric_limits<float>::infinity(),
                                     std::numeric_limits<float>::infinity()};
    /// True: the natural normal in object space, carried along as a covector, is turned round. So
    /// it is for inside orientation exactly: a covector keeps its side in a mirror, and the
    /// handedness of the transformation has no part in it. (dPdu x dPdv taken in current space
    /// has: a mirror turns that product.) Normals given by the user are turned like the natural
    /// one. At an instance, its flag and that of each primitive of the object combine by "either,
    /// not both".
    bool flipNormal = false;
    BasisRecord uBasis, vBasis;
    std::string name;      ///< Attribute "identifier" "name".
    NamedParameters named; ///< RiAttribute.

    /// What has been set in the object that is being defined: bits of `own`, and names of `named`.
    std::uint32_t ownSet = 0;
    std::set<std::string> ownNames;
};

/// Those of a part of an object: what the object has set itself, all else as the instance has it.
Attributes attributesOfPart(const Attributes &instance, const Attributes &part);

/// Attribute "render" "casts_shadows": what shadow rays find of a primitive. Shader: as opaque as
/// its surface shader says ("Os" and "shade"), the default.
enum class ShadowCasting : std::uint8_t { None, Opaque, Shader };
inline ShadowCasting shadowCasting(const Attributes &attributes) {
    const std::string how = attributes.named.string("render:casts_shadows", "shade");
    return how == "none"     ? ShadowCasting::None
           : how == "opaque" ? ShadowCasting::Opaque
                             : ShadowCasting::Shader;
}

/// Attribute "visibility": what kinds of rays meet a primitive. Old spellings: "trace" for diffuse
/// and specular, "indirect", "reflection", "transmission" by words.
struct Visibility {
    bool camera = true;   ///< From the eye, also straight through what is not opaque.
    bool diffuse = true;  ///< Scattered by lobes.
    bool specular = true; ///< Along one direction: mirrors, glass, trace().
    bool shadow = true;

    bool isWhole() const { return camera && diffuse && specular && shadow; }
};
Visibility visibilityOf(const Attributes &);

} // namespace candela
