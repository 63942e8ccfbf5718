// SPDX-License-Identifier: Apache-2.0
#include "vocabulary.h"

#include "language/semantics/builtins.h"
#include "language/semantics/predefined.h"

#include <map>

namespace candela::fuzz {

namespace {

using Spellings = Vocabulary::Spellings;

std::vector<Spellings> alikeWords() {
    std::map<std::string, Spellings> functions; // By what stands around the name.
    for (const sl::Builtin &function : sl::builtins()) {
        std::string types = sl::nameOf(function.overloads.front().result);
        for (const sl::BuiltinParameter &parameter : function.overloads.front().parameters)
            types += std::string(" ") + sl::nameOf(parameter.type) + (parameter.output ? "&" : "");
        if (function.available == sl::Available::Now)
            functions[types].push_back(function.name);
    }
    std::map<sl::BaseType, Spellings> variables;
    for (const sl::PredefinedVariable &variable : sl::predefinedVariables())
        variables[variable.type.base].push_back(variable.name);
    std::vector<Spellings> lists{{"+", "-", "*", "/"},
                                 {"<", "<=", ">", ">=", "==", "!="},
                                 {"&&", "||"},
                                 {"=", "+=", "-=", "*=", "/="},
                                 {"point", "vector", "normal", "color"},
                                 {"illuminance", "illuminate", "solar"},
                                 {"break", "continue"}};
    for (const auto &[types, names] : functions)
        lists.push_back(names);
    for (const auto &[type, names] : variables)
        lists.push_back(names);
    return lists;
}

Vocabulary make() {
    Vocabulary words;
    for (int type = 0; type < sl::baseTypeCount; ++type)
        words.types.push_back(sl::nameOf(sl::BaseType(type)));
    for (int kind = 0; kind <= int(sl::ShaderKind::Filter); ++kind)
        words.kinds.push_back(sl::nameOf(sl::ShaderKind(kind)));
    words.storage = {"uniform", "varying", "output", "extern"};
    words.statements = {"if",     "else",        "while",      "for",   "break", "continue",
                        "return", "illuminance", "illuminate", "solar", "gather"};
    for (const sl::Builtin &function : sl::builtins())
        words.functions.push_back(function.name);
    for (const sl::PredefinedVariable &variable : sl::predefinedVariables())
        words.variables.push_back(variable.name);
    words.operators = {"=", "+=", "-=", "*=", "/=", "?", ":", "||", "&&", "==", "!=",
                       "<", "<=", ">",  ">=", "+",  "-", "^", "*",  "/",  ".",  "!"};
    words.brackets = {"(", ")", "[", "]", "{", "}", ",", ";"};
    // No array sizes of thousands: their cost is a budget's matter, not of this campaign.
    words.numbers = {"0",      "1",          "2",          "3",        "0.5",        ".25",
                     "-1",     "7",          "100",        "-0.0",     "1e38",       "-1e38",
                     "3.5e38", "1e39",       "1e-38",      "1e-45",    "1e400",      "nan",
                     "inf",    "1e9",        "2147483647", "16777217", "4294967296", "-2147483648",
                     "65537",  "1.5",        "0x10",       "1e",       "1e+",        "1.2.3",
                     "00012",  "3.14159265", "1e-7",       "PI"};
    words.strings = {"\"\"",
                     "\"world\"",
                     "\"shader\"",
                     "\"object\"",
                     "\"current\"",
                     "\"camera\"",
                     "\"raster\"",
                     "\"NDC\"",
                     "\"nosuch\"",
                     "\"hsv\"",
                     "\"rgb\"",
                     "\"xyz\"",
                     "\"a&-b\"",
                     "\"-key\"",
                     "\"a,,|b\"",
                     "\"%f\"",
                     "\"%s %c %p %m\"",
                     "\"%n%100d%\"",
                     "\"\\n\\t\\\\\\\"\"",
                     "\"\\377\\000\"",
                     "\"catmull-rom\"",
                     "\"periodic,clamp\"",
                     "\"width\"",
                     "\"blur\"",
                     "\"samples\"",
                     "\"coneangle\"",
                     "\"ray:direction\"",
                     "\"surface:Ci\"",
                     "\"primitive:N\"",
                     "\"resolution\"",
                     "\"user:x\"",
                     "\"[a-z\"",
                     "\"(.*)*x\"",
                     "\"" + std::string(3000, 'x') + "\"",
                     "\"open"};
    words.directives = {"#define X 1",
                        "#define X(a) ((a)+(a))",
                        "#define X X X",
                        "#define Ci Oi",
                        "#define noise(x) noise(noise(x))",
                        "#define float color",
                        "#define J(a, b) a##b",
                        "#define S(a) #a",
                        "#define E",
                        "#undef X",
                        "#if X",
                        "#if 1 / 0",
                        "#if defined(X) && (X > 0",
                        "#ifdef X",
                        "#ifndef X",
                        "#elif 1",
                        "#else",
                        "#endif",
                        "#error no",
                        "#warning yes",
                        "#pragma once",
                        "#line 7 \"y.sl\"",
                        "#",
                        "#nosuch",
                        "# 3",
                        "#include \"nosuch.h\"",
                        "#include <matte.sl>",
                        "#include \"matte.sl\"",
                        "#include \"/dev/zero\"",
                        "#include \".\"",
                        "#include",
                        "#define",
                        "#define X(",
                        "#define X(a,",
                        "#define defined 1",
                        "#if CANDELA_VERSION"};
    words.strays = {"@", "`", "$",  "\\", "'",  "\x01", "\xc3\xa9", "\xff", "%", "&",
                    "|", "~", "\"", "/*", "*/", "//",   "::",       "->",   "##"};
    words.alike = alikeWords();
    words.related = {words.types,     words.kinds,     words.storage,   words.statements,
                     words.functions, words.variables, words.operators, words.brackets};
    return words;
}

} // namespace

const Vocabulary &vocabulary() {
    static const Vocabulary words = make();
    return words;
}

} // namespace candela::fuzz
