// SPDX-License-Identifier: Apache-2.0
#include "render/shader_entry.h"

#include "language/ir/lower/defaults.h"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace candela {

std::string inOneLine(const std::string &comment) {
    std::istringstream words(comment);
    std::string line;
    for (std::string word; words >> word;)
        if (word.find("SPDX-") == word.npos && word != "Apache-2.0")
            line += (line.empty() ? "" : " ") + word;
    return line;
}

/// "0.5", "(1, 0, 0)", "\"shader\" (0, 0, 0)", "{ 1, 2 }"
static std::string defaultOf(const ir::ShaderParameter &parameter) {
    if (parameter.computed)
        return "computed where the shader starts";
    const std::size_t elements = std::size_t(parameter.arraySize);
    std::string list;
    const auto add = [&](const std::string &text) { list += (list.empty() ? "" : ", ") + text; };
    for (const std::string &text : parameter.stringDefaults)
        add('"' + text + '"');
    const std::size_t width = parameter.defaults.size() / elements;
    for (std::size_t at = 0; at < parameter.defaults.size();
         at += std::max<std::size_t>(1, width)) {
        std::string element;
        for (std::size_t c = 0; c < width; ++c)
            element += fmt::format("{}{}", c ? ", " : "", parameter.defaults[at + c]);
        add(width == 1 ? element : "(" + element + ")");
    }
    const bool isGeometric =
        parameter.type == "point" || parameter.type == "vector" || parameter.type == "normal";
    const std::string space = isGeometric ? '"' + parameter.defaultSpace + "\" " : "";
    return space + (elements > 1 ? "{ " + list + " }" : list);
}

std::string declarationOf(const ir::ShaderParameter &parameter) {
    const std::string size =
        parameter.arraySize > 1 ? fmt::format("[{}]", parameter.arraySize) : "";
    return fmt::format("{}{}{} {}{} = {}", parameter.output ? "output " : "",
                       parameter.varying ? "varying " : "", parameter.type, parameter.name, size,
                       defaultOf(parameter));
}

std::string entryOf(const sl::TypedShader &shader, DiagnosticSink &diagnostics) {
    std::string names, lines;
    const auto parameters = ir::parametersOf(shader, {}, diagnostics);
    for (std::size_t i = 0; parameters && i < parameters->size(); ++i) {
        const ir::ShaderParameter &parameter = (*parameters)[i];
        names += (i ? ", " : "") + parameter.name;
        const std::string comment = inOneLine(shader.parameters[i].doc);
        lines += "\n    " + declarationOf(parameter) + (comment.empty() ? "" : ": " + comment);
    }
    const std::string about = inOneLine(shader.doc);
    return fmt::format("{} {}({}){}{}", sl::nameOf(shader.kind), shader.name, names,
                       about.empty() ? "" : "\n    " + about, lines);
}

} // namespace candela
