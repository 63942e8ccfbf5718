// SPDX-License-Identifier: Apache-2.0
// The words of the Shading Language that both the grammar and the type checker speak.
#pragma once

#include <optional>
#include <string_view>

namespace candela::sl {

enum class BaseType { Void, Float, Color, Point, Vector, Normal, Matrix, String };
inline constexpr int baseTypeCount = 8;

/// uniform: one value for all points that are shaded together; varying: one each.
enum class Detail { Uniform, Varying };

/// The rows of kinds.def.
enum class ShaderKind {
#define SHADER_KIND(name, letter, text, light, runs, outputs) name,
#include "language/syntax/kinds.def"
#undef SHADER_KIND
};
inline constexpr int shaderKindCount = 0
#define SHADER_KIND(name, letter, text, light, runs, outputs) +1
#include "language/syntax/kinds.def"
#undef SHADER_KIND
    ;

/// Which light statements a kind of shader may have.
enum class LightUse {
    None,
    Receives, ///< illuminance()
    Gives     ///< illuminate(), solar()
};

/// What a kind of shader is run for.
enum class RunsFor {
    Points, ///< Each point, in batches.
    Picture ///< A whole picture at once; all values are uniform.
};

/// By precedence class in RI order; see operators.h for the table.
enum class BinaryOp {
    Dot, ///< float dot product of triples
    Multiply,
    Divide,
    Cross,
    Add,
    Subtract,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or
};

/// The word as the language spells it: "float", "color"...
const char *nameOf(BaseType);
const char *nameOf(Detail);
const char *nameOf(ShaderKind);
LightUse lightUseOf(ShaderKind);
RunsFor runsFor(ShaderKind);
/// The letter that stands for it in tables.
char letterOf(ShaderKind);
/// The operator as the language spells it: ".", "*"...
const char *nameOf(BinaryOp);

/// The type of that name; nothing if the word names no type.
std::optional<BaseType> baseTypeNamed(std::string_view);
/// The kind of shader of that name; nothing if the word names none.
std::optional<ShaderKind> shaderKindNamed(std::string_view);

/// Color, point, vector or normal.
constexpr bool isTriple(BaseType t) { return t >= BaseType::Color && t <= BaseType::Normal; }
/// Point, vector or normal, which the language lets stand for each other.
constexpr bool isGeometric(BaseType t) { return t >= BaseType::Point && t <= BaseType::Normal; }

} // namespace candela::sl
