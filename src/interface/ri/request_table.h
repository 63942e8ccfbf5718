// SPDX-License-Identifier: Apache-2.0
// What is needed to read requests.def: macros that spell its argument lists, the scopes that it
// names, and the table of names, arguments and scopes at run time.
#pragma once

#include <span>
#include <string_view>

// CANDELA_FOR_EACH(macro, (a, b), (c, d), ...) = macro(a, b) macro(c, d) ..., for up to 60 pairs.
#define CANDELA_PARENS ()
#define CANDELA_EXPAND(...) CANDELA_EXPAND3(CANDELA_EXPAND3(CANDELA_EXPAND3(__VA_ARGS__)))
#define CANDELA_EXPAND3(...) CANDELA_EXPAND2(CANDELA_EXPAND2(CANDELA_EXPAND2(__VA_ARGS__)))
#define CANDELA_EXPAND2(...) CANDELA_EXPAND1(CANDELA_EXPAND1(CANDELA_EXPAND1(__VA_ARGS__)))
#define CANDELA_EXPAND1(...) __VA_ARGS__
#define CANDELA_FOR_EACH(macro, ...)                                                               \
    __VA_OPT__(CANDELA_EXPAND(CANDELA_FOR_EACH_STEP(macro, __VA_ARGS__)))
#define CANDELA_FOR_EACH_STEP(macro, first, ...)                                                   \
    macro first __VA_OPT__(CANDELA_FOR_EACH_AGAIN CANDELA_PARENS(macro, __VA_ARGS__))
#define CANDELA_FOR_EACH_AGAIN() CANDELA_FOR_EACH_STEP

#define CANDELA_PARAMETER(type, name) , Pass<type> name
#define CANDELA_PARAMETER_TYPE(type, name) , Pass<type>
#define CANDELA_ARGUMENT(type, name) , name
#define CANDELA_ARGUMENT_NAME(type, name) #name,
/// Of a request's arguments: ", float radius, float zMin" / ", float, float" / ", radius, zMin" /
/// "radius", "zMin",
#define CANDELA_PARAMETERS(...) CANDELA_FOR_EACH(CANDELA_PARAMETER, __VA_ARGS__)
#define CANDELA_PARAMETER_TYPES(...) CANDELA_FOR_EACH(CANDELA_PARAMETER_TYPE, __VA_ARGS__)
#define CANDELA_ARGUMENTS(...) CANDELA_FOR_EACH(CANDELA_ARGUMENT, __VA_ARGS__)
#define CANDELA_ARGUMENT_NAMES(...) CANDELA_FOR_EACH(CANDELA_ARGUMENT_NAME, __VA_ARGS__)

namespace candela {

/// Where a request stands. A motion block adds its bit to that of the block around it; a request
/// is legal if all bits of its place are in its set.
namespace scope {
inline constexpr unsigned Outside = 1; ///< In no world block, no object definition.
inline constexpr unsigned InWorld = 2;
inline constexpr unsigned InObject = 4; ///< Between ObjectBegin and ObjectEnd.
inline constexpr unsigned InMotion = 8;
/// In motion blocks it is one of the samples.
inline constexpr unsigned Moves = 16;

inline constexpr unsigned Option = Outside;
inline constexpr unsigned Attribute = Outside | InWorld;
inline constexpr unsigned MovingAttribute = Attribute | InMotion | Moves;
inline constexpr unsigned ShapeAttribute = Outside | InWorld | InObject;
inline constexpr unsigned MovingShapeAttribute = ShapeAttribute | InMotion | Moves;
inline constexpr unsigned Transform = Outside | InWorld | InObject | InMotion | Moves;
inline constexpr unsigned Geometry = InWorld | InObject | InMotion | Moves;
inline constexpr unsigned Block = Outside | InWorld | InObject;
inline constexpr unsigned Everywhere = Outside | InWorld | InObject | InMotion;
} // namespace scope

enum class RequestId {
#define REQUEST(Name, ...) Name,
#define REQUEST_LATER(Name, ...) Name,
#define REQUEST_OF_BLOCKS(Name, ...) Name,
#define REQUEST_OF_STREAM(Name, ...) Name,
#include "interface/ri/requests.def"
};

struct RequestDescription {
    std::string_view name;
    unsigned legalScopes;
    std::span<const std::string_view> argumentNames;
};

/// All requests in the order of requests.def; RequestId is the index.
std::span<const RequestDescription> requestTable();
inline const RequestDescription &describe(RequestId id) { return requestTable()[int(id)]; }

} // namespace candela
