// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/base_type.h"

namespace candela::sl {

const char *nameOf(BaseType type) {
    static constexpr const char *names[] = {"void",   "float",  "color",  "point",
                                            "vector", "normal", "matrix", "string"};
    return names[int(type)];
}

const char *nameOf(Detail detail) { return detail == Detail::Uniform ? "uniform" : "varying"; }

namespace {
struct KindRow {
    char letter;
    const char *text;
    LightUse light;
    RunsFor runs;
};
constexpr KindRow kinds[] = {
#define SHADER_KIND(name, letter, text, light, runs, outputs)                                      \
    {letter, text, LightUse::light, RunsFor::runs},
#include "language/syntax/kinds.def"
#undef SHADER_KIND
};
} // namespace

const char *nameOf(ShaderKind kind) { return kinds[int(kind)].text; }

LightUse lightUseOf(ShaderKind kind) { return kinds[int(kind)].light; }

RunsFor runsFor(ShaderKind kind) { return kinds[int(kind)].runs; }

char letterOf(ShaderKind kind) { return kinds[int(kind)].letter; }

const char *nameOf(BinaryOp op) {
    static constexpr const char *names[] = {".",  "*", "/",  "^",  "+",  "-",  "<",
                                            "<=", ">", ">=", "==", "!=", "&&", "||"};
    return names[int(op)];
}

std::optional<BaseType> baseTypeNamed(std::string_view word) {
    for (int i = 0; i < baseTypeCount; ++i)
        if (word == nameOf(BaseType(i)))
            return BaseType(i);
    return std::nullopt;
}

std::optional<ShaderKind> shaderKindNamed(std::string_view word) {
    for (int i = 0; i < shaderKindCount; ++i)
        if (word == nameOf(ShaderKind(i)))
            return ShaderKind(i);
    return std::nullopt;
}

} // namespace candela::sl
