// SPDX-License-Identifier: Apache-2.0
#include "large_shaders.h"

#include <functional>

namespace candela::budgets {

namespace {

/// The texts that `make` gives for 0 to count - 1, in a row.
std::string each(int count, const std::function<std::string(std::string number)> &make) {
    std::string text;
    for (int n = 0; n < count; ++n)
        text += make(std::to_string(n)) + "\n";
    return text;
}

std::string repeat(int count, const std::string &text) {
    return each(count, [&](const std::string &) { return text; });
}

std::string surface(const std::string &body, const std::string &before = "",
                    const std::string &parameters = "") {
    return before + "surface s(" + parameters + ") {\n" + body + "Oi = Os;\n}\n";
}

/// f0 to f(depth - 1), each of which calls the next in its loop's condition.
std::string conditionsThatCall(int depth) {
    std::string text = "float f" + std::to_string(depth) + "(float x;) { return x * 0.5; }\n";
    for (int n = depth; n-- > 0;)
        text += "float f" + std::to_string(n) + "(float x;) { float i = 0; while (f" +
                std::to_string(n + 1) + "(x + i) < 4) i += 1; return i; }\n";
    return text;
}

/// Functions of ten lines; each calls the next as often as `calls` says.
std::string tenLinesEach(int functions, int calls) {
    std::string text;
    for (int n = functions; n-- > 0;) {
        const std::string own = std::to_string(n), next = std::to_string(n + 1);
        text += "float g" + own + "(float x;) {\nfloat a = x;\n";
        text += each(9 - calls, [&](const std::string &k) {
            return "a = a * 1.1 + sin(a + " + own + "." + k + ");";
        });
        text += each(calls, [&](const std::string &k) {
            return n + 1 == functions ? "a = a + cos(a * " + k + ".5);"
                                      : "a = a + g" + next + "(a + " + k + ".25);";
        });
        text += "return a;\n}\n";
    }
    return text;
}

std::string chain(int links) {
    return surface("float x = s * 1000;\nif (x < 0) Ci = 1;\n" +
                   each(links, [](const std::string &n) {
                       return "else if (x < " + n + ".5) Ci = Cs * 0." + n + ";";
                   }));
}

std::string lobes(int terms) {
    return surface("normal n = normalize(N); vector w = -normalize(I); Ci = 0;\n" +
                   each(terms, [](const std::string &n) {
                       return "Ci += Cs * 0." + n + " * diffuse(n) + specular(n, w, 0.0" + n +
                              "1);";
                   }));
}

std::string nestedLoops(int depth, int turns, const std::string &inner) {
    std::string text = "color c = 0; float x = 0;\n";
    for (int n = 0; n < depth; ++n) {
        const std::string i = "i" + std::to_string(n);
        text += "float " + i + "; for (" + i + " = 0; " + i + " < " + std::to_string(turns) + "; " +
                i + " += 1) {\n";
    }
    return surface(text + inner + std::string(size_t(depth), '}') + "\nCi = c + x;\n");
}

std::string printOf(int numbers) {
    std::string pattern, values;
    for (int n = 0; n < numbers; ++n)
        pattern += "%f", values += ", s";
    return "printf(\"" + pattern + "\"" + values + ");\n";
}

} // namespace

std::vector<LargeShader> largeShaders() {
    using enum Outcome;
    const auto calls = [](const std::string &function) {
        return surface("Ci = " + function + "(u);\n");
    };
    return {
        {"a string doubled 40 times", Refused,
         surface("string t = \"ab\";\n" + repeat(40, "t = concat(t, t);") +
                 "if (t == \"x\") Ci = 1;\n"),
         "characters"},
        {"a string of a million characters by format()", Refused,
         surface("string t = \"ab\";\n" + repeat(20, "t = format(\"%s%s\", t, t);") +
                 "if (t == \"x\") Ci = 1;\n"),
         "characters"},
        {"derivatives of derivatives, 16 deep", Compiles,
         surface("float x = u;\n" + repeat(16, "x = sin(x) + Du(x);") + "Ci = x;\n")},
        {"derivatives of derivatives, 17 deep", Refused,
         surface("float x = u;\n" + repeat(17, "x = sin(x) + Du(x);") + "Ci = x;\n"),
         "derivatives"},
        {"an array of 4,096 numbers", Compiles,
         surface("float a[4096]; a[u * 9] = u; Ci = a[v * 9];\n")},
        {"an array of 4,096 numbers in a function that is called 15 times", Compiles,
         surface("Ci = 0;\n" +
                     each(15, [](const std::string &n) { return "Ci += f(u + " + n + ");"; }),
                 "float f(float x;) { float a[4096]; a[x * 9] = u; return a[v * 9]; }\n")},
        {"derivatives of an array of 60,000 numbers", Refused,
         surface("float a[60000]; a[u * 9] = u; Ci = a[v * 9] + Du(a[v * 9]) + Dv(a[v * 9]);\n"),
         "two more for each"},
        {"an array of a million numbers", Refused,
         surface("float a[1000000]; a[u * 9] = u; Ci = a[v * 9];\n"), "from 1 to 65536"},
        {"60 arrays of 60,000 numbers", Refused,
         surface("Ci = 0;\n" + each(60,
                                    [](const std::string &n) {
                                        return "float a" + n + "[60000]; a" + n +
                                               "[u * 9] = u; Ci += a" + n + "[v * 9];";
                                    })),
         "numbers"},
        {"12 functions with loop conditions that call the next", Compiles,
         conditionsThatCall(12) + calls("f0")},
        {"40 functions with loop conditions that call the next", Compiles,
         conditionsThatCall(40) + calls("f0")},
        {"three functions of ten lines that call each other 5 times", Compiles,
         tenLinesEach(3, 5) + calls("g0")},
        {"five functions of ten lines that call each other 5 times", Compiles,
         tenLinesEach(5, 5) + calls("g0")},
        {"five functions of ten lines that call each other 6 times", Refused,
         tenLinesEach(5, 6) + calls("g0"), "g0"},
        {"20 functions that call the next twice", Refused, tenLinesEach(20, 2) + calls("g0"), "g0"},
        {"40 functions that call the next twice with the same argument", Refused,
         "float g0(float x;) { return x; }\n" +
             each(40,
                  [](const std::string &n) {
                      const std::string next = std::to_string(std::stoi(n) + 1);
                      return "float g" + next + "(float x;) { return g" + n + "(x) + g" + n +
                             "(x); }";
                  }) +
             calls("g40"),
         "g40"},
        {"96 diffuse and specular terms", Compiles, lobes(96)},
        {"a cosine squared 40 times in a light loop", Compiles,
         surface("color c = 0;\nilluminance(P, N, PI / 2) {\nfloat x = normalize(L) . N;\n" +
                 repeat(40, "x = x * x;") + "c += Cl * x;\n}\nCi = c;\n")},
        {"a light's fall-off squared 40 times", Compiles,
         "light s() {\nilluminate(P) {\nfloat x = 1 / (L . L);\n" + repeat(40, "x = x * x;") +
             "Cl = x;\n}\n}\n"},
        {"8,000 statements", Compiles,
         surface("float x = u;\n" +
                 each(8000, [](const std::string &n) { return "x = x * v + 0." + n + ";"; }) +
                 "Ci = x;\n")},
        {"3,200 ifs", Compiles,
         surface("float x = u;\n" +
                 each(3200,
                      [](const std::string &n) {
                          return "if (x > 0." + n + ") x = x * v + sin(x); else x += 1;";
                      }) +
                 "Ci = x;\n")},
        {"2,000 selects", Compiles,
         surface("float x = u;\n" +
                 each(2000,
                      [](const std::string &n) { return "x = x > 0." + n + " ? x * v : x + 1;"; }) +
                 "Ci = x;\n")},
        {"a spline of 5,000 knots", Compiles,
         surface("Ci = spline(u" + each(5000, [](const std::string &n) { return ", 0." + n; }) +
                 ");\n")},
        {"2,000 calls of noise", Compiles,
         surface("float x = 0;\n" +
                 each(2000, [](const std::string &n) { return "x += noise(P * " + n + ");"; }) +
                 "Ci = x;\n")},
        {"10 loops of known count, nested", Compiles, nestedLoops(10, 2, "x += sin(x + u);\n")},
        {"10 loops around a light loop, nested", Compiles,
         nestedLoops(10, 2, "illuminance(P, N, PI / 2) { c += Cl; }\n")},
        {"4,000 parameters", Compiles,
         surface("Ci = 0;\n" + each(4000, [](const std::string &n) { return "Ci += p" + n + ";"; }),
                 "", each(4000, [](const std::string &n) { return "float p" + n + " = 1;"; }))},
        {"3,000 sums", Compiles,
         surface("Ci = 0;\n" +
                 each(3000, [](const std::string &n) { return "Ci += Cs * 0." + n + ";"; }))},
        {"a sum of 4,900 terms",
         Compiles,
         surface("Ci = s" + each(4900, [](const std::string &n) { return " + t * 0." + n; }) +
                 ";\n"),
         {},
         true},
        {"4,000 else ifs", Compiles, chain(4000)},
        {"1,000 else ifs", Compiles, chain(1000), {}, true},
        {"300 traces", Compiles,
         surface(
             "Ci = 0;\n" +
             each(300, [](const std::string &n) { return "Ci += trace(P, N + " + n + " * I);"; }))},
        {"16 gathered samples that each gather 16, and their light", Compiles,
         surface("color c = 0; Ci = 0;\n"
                 "gather(\"\", P, N, 1, 16, \"surface:Ci\", c) {\n"
                 "gather(\"\", P, N, 1, 16, \"surface:Ci\", c) Ci += c;\n}")},
        {"200 light loops",
         Compiles,
         surface("color c = 0;\n" + repeat(200, "illuminance(P, N, PI / 2) c += Cl;") +
                 "Ci = c;\n"),
         {},
         true},
        {"3,000 light loops", Refused,
         surface("color c = 0;\n" + repeat(3000, "illuminance(P, N, PI / 2) c += Cl;") +
                 "Ci = c;\n"),
         "asks for light too often"},
        {"2,000 traces", Refused, surface("Ci = 0;\n" + repeat(2000, "Ci += trace(P, N);")),
         "asks for light too often"},
        {"a light with 150 emitters",
         Compiles,
         "light s() {\n" +
             each(150,
                  [](const std::string &n) {
                      return "illuminate(point(" + n + ", 0, 0)) Cl = 1 / (L . L);";
                  }) +
             "}\n",
         {},
         true},
        {"a spline of an array parameter of 1,000 knots",
         Compiles,
         surface("Ci = spline(s, a);\n", "", "float a[1000] = {1};"),
         {},
         true},
        {"a derivative of a spline of 1,200 knots that vary",
         Compiles,
         surface("Ci = Du(spline(s" +
                 each(1200, [](const std::string &n) { return ", 0." + n + " * t"; }) + "));\n"),
         {},
         true},
        {"an array of 16,000 known numbers",
         Compiles,
         surface("float a[16000] = {0" +
                 each(15999, [](const std::string &n) { return ", 0." + n; }) +
                 "};\nCi = a[s * 15999];\n"),
         {},
         true},
        {"a printf of 256 numbers", Compiles, surface(printOf(256)), {}, true},
        {"a printf of 2,000 numbers", Refused, surface(printOf(2000)), "prints at most"},
        {"8,000 strings", Compiles,
         surface("if (p1 == p2) Ci = 1;\n", "",
                 each(8000, [](const std::string &n) { return "string p" + n + " = \"x\";"; }))},
        {"3,000 defaults that are computed", Compiles,
         surface("Ci = p1;\n", "",
                 each(3000,
                      [](const std::string &n) { return "float p" + n + " = sin(" + n + ");"; }))},
        {"90 nested ifs", Compiles,
         surface("float x = u;\n" + repeat(90, "if (x > 0.5) { x += sin(x);") +
                 std::string(90, '}') + "\nCi = x;\n")},
        {"1,000 returns", Compiles,
         calls("f").insert(0, "float f(float x;) {\n" +
                                  each(1000,
                                       [](const std::string &n) {
                                           return "if (x == " + n + ") return sin(x + " + n + ");";
                                       }) +
                                  "return 0;\n}\n")},
    };
}

} // namespace candela::budgets
