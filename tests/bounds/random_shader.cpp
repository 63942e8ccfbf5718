// SPDX-License-Identifier: Apache-2.0
#include "random_shader.h"

#include <fmt/format.h>
#include <random>
#include <vector>

namespace candela::bounds {

namespace {

class Writer {
public:
    explicit Writer(unsigned seed) : bits_(seed) {}

    std::string shader(const std::string &name) {
        std::string body;
        for (int n = 0, count = 3 + below(6); n < count; ++n)
            body += statement(2);
        const std::string light = below(4) == 0 ? loop() : below(3) == 0 ? highlight() : "";
        return fmt::format(
            "surface {}(float Kd = .8; float few = 3;)\n{{\n"
            "    float a = s, b = t, c = .3, k;\n    float list[4] = {{ .1, .5, -.2, 1 }};\n"
            "    point Q = transform(\"shader\", P);\n    normal Nf = normalize(N);\n{}"
            "    color own = color (clamp(a, 0, 1), abs(b), .5 + .5 * sin(c));\n"
            "    Oi = Os * clamp(b, .2, 1);\n    Ci = own * Kd * diffuse(Nf);\n{}{}}}\n",
            name, body, light, below(3) ? "" : "    Ci += own * max(0, c);\n");
    }

private:
    int below(int n) { return int(bits_() % unsigned(n)); }
    std::string one(const std::vector<std::string> &list) {
        return list[size_t(below(int(list.size())))];
    }
    std::string number() {
        return one({".1", ".25", ".5", "1", "2", "3", "7", "-.4", "few", "Kd"});
    }
    std::string variable() {
        return one({"a", "b", "c", "u", "v", "s", "t", "xcomp(Q)", "ycomp(P)", "zcomp(Nf)"});
    }

    std::string expression(int depth) {
        if (depth == 0)
            return below(3) ? variable() : number();
        const auto e = [&] { return expression(depth - 1); };
        switch (below(26)) {
        case 0: return fmt::format("({} + {})", e(), e());
        case 1: return fmt::format("({} - {})", e(), e());
        case 2: return fmt::format("({} * {})", e(), e());
        case 3: return fmt::format("({} / (2 + abs({})))", e(), e());
        case 4: return fmt::format("sin({} * {})", number(), e());
        case 5: return fmt::format("cos({})", e());
        case 6: return fmt::format("sqrt(abs({}))", e());
        case 7: return fmt::format("pow(abs({}), {})", e(), one({".5", "2", "3", "few"}));
        case 8: return fmt::format("exp(-abs({}))", e());
        case 9: return fmt::format("log(1 + abs({}))", e());
        case 10:
            return fmt::format("smoothstep({}, {}, {})", one({"0", ".2"}), one({".5", "1"}), e());
        case 11: return fmt::format("mod({}, {})", e(), one({"1", ".3", "2"}));
        case 12: return fmt::format("floor({} * {})", one({"4", "10"}), e());
        case 13: return fmt::format("step({}, {})", e(), e());
        case 14: return fmt::format("min({}, {})", e(), e());
        case 15: return fmt::format("max({}, {})", e(), e());
        case 16: return fmt::format("clamp({}, 0, 1)", e());
        case 17: return fmt::format("mix({}, {}, clamp({}, 0, 1))", e(), e(), e());
        case 18:
            return fmt::format("float noise({} * {})", one({"3", "8"}), one({"Q", "s", "P", "N"}));
        case 19: return fmt::format("float noise({} * s, {} * t)", number(), number());
        case 20:
            return fmt::format("float cellnoise({} * s, {} * t)", one({"4", "9"}), one({"4", "9"}));
        case 21: return fmt::format("spline(clamp({}, 0, 1), 0, .1, .8, .3, 1, 1)", e());
        case 22: return fmt::format("atan({}, {})", e(), one({"2", "a + 3", "b"}));
        case 23: return fmt::format("({} - floor({}))", variable(), variable());
        case 24: return fmt::format("pnoise({} * s, 4)", number());
        default: return fmt::format("({} < {} ? {} : {})", e(), e(), e(), e());
        }
    }

    std::string statement(int depth) {
        const std::string name = one({"a", "b", "c"});
        switch (depth > 0 ? below(9) : 0) {
        case 1:
            return fmt::format("    if ({} < {}) {{\n{}    }} else {{\n{}    }}\n", expression(1),
                               expression(1), statement(depth - 1), statement(depth - 1));
        case 2:
            return fmt::format("    for (k = 0; k < few; k += 1) {{\n        {} = .5 * {} + .2 * k "
                               "* {};\n    }}\n",
                               name, name, expression(1));
        case 3:
            return fmt::format("    list[{} * 1.9] = {};\n    {} = list[floor(abs({}))];\n",
                               one({"u", "v", "few"}), expression(1), name, variable());
        case 4:
            return fmt::format(
                "    k = 0;\n    while (k < {}) {{\n        {} += .1;\n        k += 1;\n    }}\n",
                one({"few", "2 + 2 * s"}), name);
        case 5:
            return fmt::format("    if ({} > {} && {} < {})\n        {} = {};\n", variable(),
                               number(), variable(), number(), name, expression(1));
        default: return fmt::format("    {} = {};\n", name, expression(depth > 0 ? 3 : 2));
        }
    }

    std::string loop() {
        return "    illuminance(P, Nf, PI / 2) {\n        vector Ln = normalize(L);\n"
               "        Ci += own * Cl * pow(max(0, Ln . Nf), 1 + abs(c)) * .3;\n    }\n";
    }
    std::string highlight() {
        return "    Ci += .3 * specular(Nf, -normalize(I), .3 + .1 * abs(a));\n";
    }

    std::mt19937 bits_;
};

} // namespace

std::string randomShader(unsigned seed, const std::string &name) {
    return Writer(seed).shader(name);
}

} // namespace candela::bounds
