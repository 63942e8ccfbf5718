// SPDX-License-Identifier: Apache-2.0
// Declared values as they come through the RenderMan Interface: "[class] type[n] name" value...
#pragma once

#include "foundation/base/diagnostics.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace candela {

enum class StorageClass { Constant, Uniform, Varying, Vertex, FaceVarying, FaceVertex };
enum class ValueType { Float, Integer, String, Color, Point, Vector, Normal, HPoint, Matrix };

/// Floats (or strings) in one value of the type; a color has `colorSamples`.
int componentsOf(ValueType);

struct Declaration {
    StorageClass storage = StorageClass::Uniform;
    ValueType type = ValueType::Float;
    int arraySize = 1; ///< n of type[n].

    int components() const { return componentsOf(type) * arraySize; }
    friend bool operator==(const Declaration &, const Declaration &) = default;
};

/// One token with its values. Integers stand in `floats` too (exact to 2^24).
struct Parameter {
    std::string name;
    Declaration declaration;
    std::vector<float> floats;
    std::vector<std::string> strings;
};

class ParameterList {
public:
    SourceLocation where; ///< The request that carries them.
    std::vector<Parameter> all;

    /// The parameter of that name, or null.
    const Parameter *find(std::string_view name) const;
    /// First float or string of the parameter of that name, or the fallback.
    float number(std::string_view name, float fallback) const;
    std::string string(std::string_view name, std::string fallback) const;
};

/// The list with numbers of a share of the way from those of `a` to those of `b`, where these have
/// parameters alike.
ParameterList between(const ParameterList &a, const ParameterList &b, double share);

/// The values of Option or Attribute requests as "category:name", for example "render:integrator".
class NamedParameters {
public:
    /// Of that name; a new one has no values yet.
    Parameter &operator[](const std::string &qualifiedName) { return all_[qualifiedName]; }
    /// The parameter of that name, or null.
    const Parameter *find(const std::string &qualifiedName) const;
    /// Its first float or string, or the fallback.
    float number(const std::string &qualifiedName, float fallback) const;
    std::string string(const std::string &qualifiedName, std::string fallback) const;

private:
    std::map<std::string, Parameter> all_;
};

} // namespace candela
