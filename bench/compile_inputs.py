# SPDX-License-Identifier: Apache-2.0
"""Shader texts that are long in one way each, for bench/run: what compiling costs must grow with
their length and no faster."""
import random


def surface(name, lines, parameters=""):
    body = "\n".join("    " + line for line in lines)
    return (f"surface {name}({parameters})\n{{\n    float f = s;\n    normal Nf = faceforward("
            f"normalize(N), I);\n    color c = Cs;\n{body}\n"
            "    Ci = c * (f + diffuse(Nf) + specular(Nf, -normalize(I), .1));\n    Oi = Os;\n}\n")


def straight(count, seed=1):
    """Statements that all depend on each other, on eight floats and two colours."""
    chance = random.Random(seed)
    names = [f"x{k}" for k in range(8)]
    lines = [f"float {name} = {chance.choice('st')} * {1 + k};" for k, name in enumerate(names)]
    lines.append("color d = Cs;")

    def pick():
        return chance.choice(names)

    for _ in range(count):
        to = pick()
        lines.append(chance.choice([
            f"{to} = {pick()} * {pick()} + {chance.random():.3f};",
            f"{to} = mix({pick()}, {pick()}, {chance.random():.3f});",
            f"{to} = min({pick()}, {pick()}) - {pick()};",
            f"{to} = clamp({pick()} + {pick()}, -2, {chance.random():.3f});",
            f"c = mix(c, d, {pick()});", f"d = c * {pick()} + d * {chance.random():.3f};",
            f"{to} = sqrt(abs({pick()}));"] + [f"{to} = sin({pick()});"] * (len(lines) % 8 == 0)))
    return surface("straight", lines + ["f = " + " + ".join(names) + ";", "c = c + d;"])


def branches(statements, ifs, seed=2):
    """Statements of which many stand behind conditions of their own."""
    chance = random.Random(seed)
    names = [f"x{k}" for k in range(8)]
    lines = [f"float {name} = {chance.choice('st')} * {1 + k};" for k, name in enumerate(names)]
    for k in range(statements):
        to, a, b = (chance.choice(names) for _ in range(3))
        line = f"{to} = {a} * {chance.random():.3f} + {b};"
        lines.append(f"if ({chance.choice(names)} > {chance.random():.3f}) {line}"
                     if k * ifs // statements != (k + 1) * ifs // statements else line)
    return surface("branches", lines + ["f = " + " + ".join(names) + ";"])


def everyday(number, count=50):
    """A shader as people write them, of `count` lines: a pattern of noise, ramps and tiles, a few
    decisions, and one of the usual illumination models. Equal numbers give equal texts."""
    chance = random.Random(number)
    lines = ["point PP = transform(\"shader\", P) * frequency;", "float f, g = 0, h = 0, k;",
             "color layer, paint = Cs;", "normal Nf = faceforward(normalize(N), I);",
             "vector V = -normalize(I);"]
    while len(lines) < count - 6:
        a, b = chance.random(), chance.random()
        lines.extend(chance.choice([
            [f"f = noise(PP * {1 + 9 * a:.2f});", f"g += {b:.3f} * abs(f - .5);"],
            [f"k = mod(s * {1 + int(20 * a)}, 1);",
             f"h = smoothstep(.1, .2, k) - smoothstep({.8 + .1 * a:.3f}, .95, k);"],
            [f"for (k = 0; k < {2 + int(4 * a)}; k += 1)",
             "    g += snoise(PP * pow(2, k)) / pow(2, k);"],
            [f"layer = color({a:.3f}, {b:.3f}, {a * b:.3f});", "paint = mix(paint, layer, h);"],
            [f"if (f > {a:.3f})", f"    paint *= {b:.3f};", "else",
             f"    paint = paint * .9 + {.1 * b:.3f};"],
            [f"f = clamp(g * {2 * a:.3f} + t, 0, 1);", "paint = spline(f, paint, layer, Cs, paint);"],
            [f"g = pow(abs(sin(g * {6 * a:.3f})), {1 + 3 * b:.3f});"],
            [f"h = max(h, step({a:.3f}, noise(s * 20, t * 20)));"]]))
    model = chance.choice([
        "Ci = Oi * (paint * (Ka * ambient() + Kd * diffuse(Nf)) + Ks * specular(Nf, V, roughness));",
        "Ci = Oi * paint * (Ka * ambient() + Kd * diffuse(Nf) + Ks * phong(Nf, V, 1 / roughness));",
        "Ci = Oi * paint * (Ka * ambient() + Kd * diffuse(Nf));"])
    body = "\n".join("    " + line for line in lines + ["Oi = Os;", model])
    return (f"#define snoise(x) (2 * noise(x) - 1)\nsurface everyday{number}(float Ka = 1, Kd = .6, "
            f"Ks = .3, roughness = .1, frequency = {1 + 3 * chance.random():.3f})\n{{\n{body}\n}}\n")


def many_alive(statements, ifs, alive, seed=6):
    """Many variables that all live to the end, changed behind conditions."""
    chance = random.Random(seed)
    names = [f"x{k}" for k in range(alive)]
    lines = [f"float {name} = s * {k + 1} + t;" for k, name in enumerate(names)]
    for k in range(statements):
        to, a, b = (chance.choice(names) for _ in range(3))
        line = f"{to} = {a} * {chance.random():.3f} + {b};"
        if k * ifs // statements != (k + 1) * ifs // statements:
            line = (f"if ({chance.choice(names)} > {chance.random():.3f}) {{ {line} "
                    f"{chance.choice(names)} = sin({a}); }} else {{ {b} = {a} * .5; }}")
        lines.append(line)
    return surface("alive", lines + ["f = " + " + ".join(names) + ";"])


def spline(knots, seed=3):
    chance = random.Random(seed)
    values = ", ".join(f"{chance.random():.3f}" for _ in range(knots))
    return surface("knots", [f"f = spline(s, {values});"])


def noises(count):
    return surface("noises", [f"f += noise(P * {1 + k * .37:.2f} + {k});" for k in range(count)])


def selects(count):
    return surface("selects", [f"f = f * 1.01 > {k / count:.4f} ? f + {k * .01:.3f} : f * .98;"
                               for k in range(count)])


def lobes(count):
    return surface("lobes", [f"c += {k * .01:.2f} * (diffuse(Nf + {k * .01:.2f}) + specular(Nf, "
                             f"-normalize(I), {.05 + k * .01:.2f}));" for k in range(count)])


def light_loops(count):
    return surface("loops", ["illuminance(P, Nf, PI / 2) c += Cl;"] * count)


def traces(count):
    return surface("traces", [f"c += trace(P, vector(s, t, {k}));" for k in range(count)])


def curve_of_parameter(knots):
    return surface("curve", ["f = spline(s, a);"],
                   f"float a[{knots}] = {{{', '.join(str(k % 7) for k in range(knots))}}};")


def slope_of_curve(knots):
    chosen = ", ".join(f"{k % 7} * t" for k in range(knots))
    return surface("slope", [f"f = Du(spline(s, {chosen}));"])


def table(entries):
    return surface("table", [f"float a[{entries}] = {{{', '.join(str(k % 9) for k in range(entries))}}};",
                             f"f = a[s * {entries - 1}];"])


def prints(numbers):
    return surface("prints", [f'printf("{"%f " * numbers}\\n"{", s" * numbers});'])


def emitters(count):
    lines = "\n".join(f"    illuminate(point({k}, 0, 0)) Cl = {k} / (L . L);" for k in range(count))
    return f"light emitters()\n{{\n{lines}\n}}\n"


def many_parameters(count):
    return surface("parameters", [f"c += p{k};" for k in range(count)],
                   " ".join(f"color p{k} = 1;" for k in range(count)))


def brick():
    """Two hundred lines as people write them: courses of brick with mortar, dirt, lichen, wear."""
    lines = ["point Q = transform(\"shader\", P);", "color total = 0;", "float grit = 0;"]
    for k in range(12):
        lines += [
            f"float row{k} = floor(t * {8 + k});",
            f"float shift{k} = mod(row{k}, 2) * .5;",
            f"float across{k} = s * {4 + k} + shift{k};",
            f"float column{k} = floor(across{k});",
            f"float u{k} = across{k} - column{k};",
            f"float v{k} = t * {8 + k} - row{k};",
            f"float edge{k} = smoothstep(0, mortar, u{k}) - smoothstep(1 - mortar, 1, u{k});",
            f"edge{k} *= smoothstep(0, mortar * 2, v{k}) - smoothstep(1 - mortar * 2, 1, v{k});",
            f"float own{k} = cellnoise(column{k}, row{k});",
            f"color tint{k} = mix(brickcolor, Cs * own{k}, .3 + .1 * noise(Q * {3 + k}));",
            f"if (own{k} > .8) {{",
            f"    tint{k} *= color(.6, .55, .5) * (1 + .2 * snoise(Q * {9 + k}));",
            f"    grit += .05 * edge{k};",
            "}",
            f"total = mix(mortarcolor * (1 - .1 * grit), mix(total, tint{k}, .5), edge{k});",
            f"total = clamp(total, color 0, color({1 + k * .01:.2f}, 1, 1));",
        ]
    text = surface("brick", lines + ["c = total;", "f = .2 + grit;"],
                   "float mortar = .05; color brickcolor = color(.5, .2, .1), "
                   "mortarcolor = color(.7, .7, .65);")
    return "#define snoise(x) (2 * noise(x) - 1)\n" + text


INPUTS = {
    "brick": brick(),
    "straight500": straight(500),
    "straight2000": straight(2000),
    "straight8000": straight(8000),
    "branches8000": branches(8000, 3200),
    "alive64": many_alive(8000, 3200, 64),
    "spline5000": spline(5000),
    "noises2000": noises(2000),
    "selects2000": selects(2000),
    "lobes96": lobes(96),
    "loops300": light_loops(300),
    "traces200": traces(200),
    "curve500": curve_of_parameter(500),
    "curve20000": curve_of_parameter(20000),
    "slope300": slope_of_curve(300),
    "slope1200": slope_of_curve(1200),
    "table4096": table(4096),
    "prints256": prints(256),
    "emitters150": emitters(150),
    "parameters3000": many_parameters(3000),
}
