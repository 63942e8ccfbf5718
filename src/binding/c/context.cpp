// SPDX-License-Identifier: Apache-2.0
#include "binding/c/context.h"

#include "interface/ri/wide_integers.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace candela::c {

void Context::beginCall(const char *name) {
    if (!where_.file)
        where_.file = std::make_shared<const std::string>("call");
    call_ = name;
    ++where_.line;
}

void Context::error(const std::string &message) {
    diagnostics().error(where_, call_ + ": " + message);
}

void Context::declare(const std::string &name, const std::string &declaration) {
    if (const auto parsed = parseDeclaration(declaration))
        dictionary_.declare(name, *parsed);
    sink().declare(at(), name, declaration);
}

void Context::closeBlock() {
    if (steps_.size() > 1)
        steps_.pop_back();
}

RtPointer Context::newHandle(RtToken name) {
    handles_.push_back(name ? name : std::to_string(handles_.size() + 1));
    return reinterpret_cast<RtPointer>(handles_.size());
}

Handle Context::nameOf(RtPointer handle) const {
    const auto number = reinterpret_cast<std::uintptr_t>(handle);
    const bool known = number > 0 && number <= handles_.size();
    return {known ? handles_[number - 1] : std::to_string(number)};
}

TokenList Context::list(const VariableCounts &counts, const Parameters &given,
                        const std::string &category) {
    TokenList result;
    for (RtInt i = 0; i < given.count; ++i) {
        const std::string token = given.tokens[i] ? given.tokens[i] : "";
        const auto parsed = parseToken(token);
        std::optional<Declaration> type = parsed ? parsed->declaration : std::nullopt;
        if (parsed && !type)
            type = dictionary_.declaredByUser(parsed->name);
        if (parsed && !type)
            type = Dictionary::standard(parsed->name);
        if (parsed && !type && !category.empty())
            type = Dictionary::standard(category + ":" + parsed->name);
        if (!type || !given.values[i]) {
            error("parameter '" + token + "' " +
                  (type ? "has no values"
                        : "has not been declared (RiDeclare), and how many values "
                          "it has is not known") +
                  "; it is left out");
            continue;
        }
        const std::size_t values =
            std::size_t(std::max(0, counts.of(type->storage))) * std::size_t(type->components());
        TokenValue parameter{token, at(), {}, {}};
        if (type->type == ValueType::String) {
            const auto *strings = static_cast<const RtString *>(given.values[i]);
            for (std::size_t k = 0; k < values; ++k)
                parameter.strings.emplace_back(strings[k] ? strings[k] : "");
        } else if (type->type == ValueType::Integer) {
            const auto *integers = static_cast<const RtInt *>(given.values[i]);
            parameter.floats.assign(integers, integers + values);
            parameter.integers = wideIntegers({integers, values});
        } else {
            const auto *floats = static_cast<const RtFloat *>(given.values[i]);
            parameter.floats.assign(floats, floats + values);
        }
        result.all.push_back(std::move(parameter));
    }
    return result;
}

VariableCounts Context::meshCounts(const std::string &type, int uVertices, const std::string &uWrap,
                                   int vVertices, const std::string &vWrap) const {
    Attributes attributes;
    attributes.uBasis.step = steps_.back().u, attributes.vBasis.step = steps_.back().v;
    const PatchMeshRecord mesh{type == "bicubic", uVertices, vVertices, uWrap == "periodic",
                               vWrap == "periodic"};
    if (!defectOf(mesh, attributes).empty())
        return {0, 0, 0, 0, 0}; // It is reported where it is received.
    return countsOf(mesh, attributes, uVertices * vVertices);
}

VariableCounts Context::curveCounts(const std::string &type, int curves, const int *vertexCounts,
                                    const std::string &wrap) const {
    VariableCounts counts{curves, 0, 0, 0, 0};
    for (int i = 0; i < curves; ++i) {
        const int vertices = vertexCounts[i], step = steps_.back().v;
        const bool periodic = wrap == "periodic";
        const int segments = periodic ? vertices / step : (vertices - 4) / step + 1;
        counts.vertex += vertices;
        counts.varying += type == "linear" ? vertices : segments + (periodic ? 0 : 1);
    }
    counts.faceVarying = counts.varying, counts.faceVertex = counts.vertex;
    return counts;
}

} // namespace candela::c
