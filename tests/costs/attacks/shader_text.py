# SPDX-License-Identifier: Apache-2.0
"""Shaders whose text is what is dear: depth, width and length."""
from attacks.attack import Attempt, attack, counted, filled, shaded


def surface(statements, parameters="", **more):
    return shaded(f"surface attack({parameters}) {{\n{statements}\nOi = 1; }}\n", **more)


def nested(opening, middle, closing, before="Ci = ", after=";"):
    """An expression or statement within itself."""
    def make(size, chance):
        depth = size // len(opening + closing)
        return surface(before + opening * depth + middle + closing * depth + after)
    return make


DEEP = {
    "parentheses": nested("(", "1", ")"),
    "signs": nested("- ", "1", ""),
    "nots": nested("!", "1", "", "if (", ") Ci = 1;"),
    "casts": nested("float ", "1", ""),
    "spaces": nested('point "world" ', "P", "", "P = "),
    "calls": nested("sin(", "u", ")"),
    "noises": nested("noise(", "P", ")"),
    "choices": nested("u > .5 ? 1 : ", "2", ""),
    "choices-first": nested("u > .5 ? ", "2", " : 1"),
    "blocks": nested("{", "Ci = 1;", "}", "", ""),
    "ifs": nested("if (u > .5) ", "Ci = 1;", "", "", ""),
    "else-ifs": nested("if (u > .5) Ci = 1; else ", "Ci = 2;", "", "", ""),
    "loops": nested("while (Ci == 1) ", "Ci = 1;", "", "float x; ", ""),
    "functions": nested("float f() { ", "return 1;", " return 2; }", "", ""),
    "assignments": nested("u = ", "1", "", "", ";"),
    "indices": nested("a[", "0", "]", "float a[2]; Ci = "),
    "triples": nested("(1, 2, ", "3", ")", "vector v = "),
    "sums": nested("1 + (u * ", "v", ")"),
    "illuminances": nested("illuminance(P) { ", "Ci += Cl;", " }", "", ""),
    "brackets": nested("[", "", "]", ""),
}
for kind, maker in DEEP.items():
    attack(maker, name=f"shader-deep-{kind}", quick=kind in ("parentheses", "blocks", "choices"))

LONG = {  # Statements by the thousand; {0} makes each another.
    "locals": "float x{0} = noise({0} * u);\nCi += x{0};",
    "noises": "Ci += noise(P * {0});\n",
    "textures": 'Ci += texture("t{0}", s, t);\n',
    "strings": 'if (concat("a", "{0}") == "b") Ci += 1;\n',
    "conditions": "if (u > .{0}) Ci += noise(P * {0}); else Ci *= 2;\n",
    "loops": "for (x = 0; x < u * {0}; x += 1) Ci += noise(x);\n",
    "light-loops": "illuminance(P, N, {0}) Ci += Cl * L.N;\n",
    "diffuses": "Ci += diffuse(N) * {0};\n",
    "traces": "Ci += trace(P, N + {0});\n",
    "derivatives": "Ci += Du(noise(P * {0} * u));\n",
    "arrays": "float a{0}[60000]; a{0}[u * 60000] = 1; Ci += a{0}[v * 60000];\n",
    "prints": 'printf("%f\\n", {0});\n',
    "splines": "Ci += spline(u * {0}, color 0, color 1, color 2, color 3, color 4);\n",
    "matrices": 'Ci += color transform("world", P * {0});\n',
    "inverses": "m = 1 / (m * {0} + m);\n",
    "comparisons": "Ci = Ci == color({0}, 1, 2) ? Ci * 2 : Ci;\n",
    "random": "Ci += random() * {0};\n",
    "messages": 'surface("x{0}", x); Ci += x;\n',
    "empty": ";",
    "macros": "#define M{0} M{0} + 1\nCi += M{0};\n",
    "functions": "float f{0}(float a;) {{ return noise(a * {0}); }}\nCi += f{0}(u);\n",
    "occlusions": "Ci += occlusion(P, N, {0});\n",
    "environments": 'Ci += environment("e{0}", N);\n',
    "powers": "Ci += pow(u, {0}.5) * exp(v) * sin(u * {0}) * atan(v);\n",
}
for kind, text in LONG.items():
    attack(lambda size, chance, text=text: surface("float x; matrix m = 2;\n" + counted(size, text)),
           name=f"shader-long-{kind}", quick=kind in ("noises", "textures"))

WORD = {  # One piece as long as the file.
    "identifier": lambda size: surface(f"float {'x' * size} = 1;"),
    "number": lambda size: surface(f"Ci = {'1' * size};"),
    "fraction": lambda size: surface(f"Ci = .{'0' * size}1;"),
    "string": lambda size: surface(f'string s = "{"x" * size}"; if (s == "y") Ci = 1;'),
    "comment": lambda size: surface("/*" + "x" * size),
    "string-without-end": lambda size: surface('string s = "' + "x" * size),
    "sum": lambda size: surface("Ci = 1" + filled(size, " + u") + ";"),
    "product": lambda size: surface("Ci = 1" + filled(size, " * u") + ";"),
    "comparison": lambda size: surface("if (u > 1" + filled(size, " || u > v") + ") Ci = 1;"),
    "arguments": lambda size: surface("Ci = spline(u" + filled(size, ", v") + ");"),
    "arguments-of-mix": lambda size: surface("Ci = max(u" + filled(size, ", v") + ");"),
    "parameters": lambda size: surface("Ci = 1;", counted(size, "float p{} = 1;\n")),
    "parameters-used": lambda size: surface(counted(size // 3, "Ci += p{};\n"),
                                            counted(size // 2, "float p{} = 1;\n")),
    "string-parameters": lambda size: surface(counted(size // 3, 'if (p{} == "x") Ci += 1;\n'),
                                              counted(size // 2, 'string p{} = "y";\n')),
    "outputs": lambda size: surface("Ci = 1;", counted(size, "output varying float p{} = 1;\n")),
    "array-parameter": lambda size: surface("Ci = a[u * 9];",
                                            f"float a[{size // 2}] = {{{filled(size - 9, '1,')}1}}"),
    "array-too-large": lambda size: surface("float a[2000000000]; a[0] = 1; Ci = a[u];"),
    "macro-arguments": lambda size: surface(f"#define M({counted(size // 2, 'a{},')}b) b\n"
                                            f"Ci = M({filled(size // 3, '1,')}1);"),
    "macro-body": lambda size: surface(f"#define M {filled(size // 2, 'u + ')} 1\n"
                                       + filled(size // 2, "Ci += M;\n")),
    "macro-of-arguments": lambda size: surface(f"#define M(x) {filled(size // 2, 'x ')}\n"
                                               f"Ci = M({'1 ' * (size // 4)});"),
    "line-of-backslashes": lambda size: surface(filled(size, "\\\n") + "Ci = 1;"),
    "directives": lambda size: surface(filled(size, "#if 1\n#endif\n") + "Ci = 1;"),
    "open-directives": lambda size: surface(filled(size, "#if 1\n") + "Ci = 1;"),
    "directive-expression": lambda size: surface("#if " + filled(size, "1 + ") + "1\n#endif\nCi = 1;"),
    "directive-parentheses": lambda size: surface("#if " + "(" * size + "\n#endif\nCi = 1;"),
    "zeros": lambda size: surface("\0" * size),
    "shaders": lambda size: Attempt({"scene.sl": counted(size, "surface s{}() {{ Ci = 1; }}\n")},
                                    ["compile", "scene.sl"]),
}
for kind, maker in WORD.items():
    attack(lambda size, chance, maker=maker: maker(size), name=f"shader-one-{kind}",
           quick=kind in ("identifier", "sum", "parameters"))


@attack
def shader_of_noise(size, chance):
    return surface("".join(chance.choice("(){};+-*/,.=<>!&|u1P \n\"#") for _ in range(size)))


@attack
def shader_of_a_polynomial(size, chance):
    """Nested products by Horner, as long as there is room for: its derivatives are as long each."""
    terms = counted(size, "x = x * u + {};\n")
    return surface("float x = 1;\n" + terms + "N = calculatenormal(P + x * N); Ci = diffuse(N) + Du(x);")


@attack
def shader_of_many_values_alive(size, chance):
    """Each number is used at the very end: all of them are kept."""
    unit = "float x{0} = noise(P * {0});\n"
    count = size // 45
    return surface("".join(unit.format(i) for i in range(count)) +
                   "".join(f"Ci += x{count - 1 - i};" for i in range(count)))
