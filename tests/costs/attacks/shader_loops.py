# SPDX-License-Identifier: Apache-2.0
"""Shaders that are short to read and long to run."""
from attacks.attack import Attempt, attack, shaded

ENDLESS = {
    "while": "while (1 == 1) x += 1;",
    "for": "for (x = 0; x >= 0; x += 1) ;",
    "within-each-other": "while (x >= 0) while (x >= 0) while (x >= 0) x += 1;",
    "just-below-the-limit": "for (i = 0; i < 1000000; i += 1) x += noise(P * i);",
    "below-the-limit-twice": "for (i = 0; i < 1000; i += 1) for (j = 0; j < 1000; j += 1) x += noise(P * i + j);",
    "one-after-the-other": "for (i = 0; i < 1000000; i += 1) x += sin(x + i);\n" * 50,
    "of-functions": "float f(float a;) { float k, b = a; for (k = 0; k < 100000; k += 1) b = sin(b + k); return b; } "
                    + "x += f(x);\n" * 50,
    "of-strings": 'string s = ""; for (i = 0; i < 1000000; i += 1) { s = concat(s, "x"); x += 1; } '
                  'if (s == "") x = 1;',
    "of-textures": 'for (i = 0; i < 1000000; i += 1) x += float texture("nosuch.tx", s + i, t);',
    "of-traces": "for (i = 0; i < 1000000; i += 1) Ci += trace(P, N + i);",
    "of-messages": 'for (i = 0; i < 1000000; i += 1) surface("x", x);',
    "of-arrays": "float a[10000]; for (i = 0; i < 1000000; i += 1) a[mod(i, 10000)] += a[mod(i * 7, 10000)]; x = a[9];",
    "of-derivatives": "for (i = 0; i < 1000000; i += 1) x += Du(noise(P * x));",
    "of-light": "for (i = 0; i < 1000000; i += 1) Ci += diffuse(N);",
    "in-light": "illuminance(P) { while (x >= 0) x += 1; Ci += Cl * x; }",
    "of-matrices": 'matrix m = 2; for (i = 0; i < 1000000; i += 1) m = m / m; x = determinant(m);',
    "of-splines": "for (i = 0; i < 1000000; i += 1) x += spline(x, 1, 2, 3, 4, 5);",
    "of-nothing-needed": "float waste = 0; while (1 == 1) waste += 1;",
    "of-random": "for (i = 0; i < 1000000; i += 1) x += random();",
    "of-options": 'for (i = 0; i < 1000000; i += 1) option("Format", x);',
    "of-transforms": 'for (i = 0; i < 1000000; i += 1) Ci += color transform("world", P + i);',
    "of-no-numbers": "for (i = 0; i != x; i += 0 / 0) x += 1;",
    "of-occlusions": "for (i = 0; i < 1000000; i += 1) Ci += occlusion(P, N, 1000000);",
    "of-breaks": "while (1 == 1) { while (1 == 1) { x += 1; continue; } break 2; }",
}
VARIABLES = "float x = 0, i, j;\n"
for kind, text in ENDLESS.items():
    attack(lambda size, chance, text=text: shaded(f"surface attack() {{ {VARIABLES}{text}\nCi += x; Oi = 1; }}\n"),
           name=f"endless-{kind}", quick=kind in ("while", "of-nothing-needed"))

KINDS = {  # The other kinds of shaders.
    "displacement": "displacement attack() {{ {0} P += x * N; }}\n",
    "volume": "volume attack() {{ {0} Ci += x; }}\n",
    "light": "light attack() {{ {0} illuminate(point(0, 0, 0)) {{ Cl = x; }} }}\n",
    "imager": "imager attack() {{ {0} Ci += x; }}\n",
    "filter": "filter attack() {{ {0} Ci += x; }}\n",
}
for kind, text in KINDS.items():
    attack(lambda size, chance, text=text: shaded(text.format(VARIABLES + ENDLESS["while"])),
           name=f"endless-{kind}")
    attack(lambda size, chance, text=text: shaded(
        text.format(VARIABLES + ENDLESS["within-each-other"])), name=f"endless-nested-{kind}")


@attack
def endless_volume_of_steps(size, chance):
    """A march in steps that come to nothing."""
    return shaded("volume attack() { float at = 0; color c = 0; while (at < length(I)) "
                  "{ at += 1e-9; c += noise(P * at) * 1e-9; } Ci += c; }\n")


@attack
def endless_volume_of_light(size, chance):
    return shaded("volume attack() { float i; color c = 0; for (i = 0; i < 1000000; i += 1) "
                  "illuminance(P + i * I) c += Cl; Ci += c; }\n")


@attack
def recursion(size, chance):
    return shaded("surface attack() { float f(float a;) { return f(a + 1); } Ci = f(1); Oi = 1; }\n")


@attack
def recursion_of_each_other(size, chance):
    return shaded("surface attack() { float g(float a;); float f(float a;) { return g(a); }\n"
                  "float g(float a;) { return f(a); } Ci = f(1); Oi = 1; }\n")


@attack
def sampling_without_measure(size, chance):
    return shaded("surface attack() { Ci = occlusion(P, N, 1000000000) + indirectdiffuse(P, N, 1e30); "
                  'gather("illuminance", P, N, 3, 1000000000, "surface:Ci", Ci) Oi += 1; }\n')


@attack
def textures_without_measure(size, chance):
    """Blurred and filtered as widely as numbers allow."""
    return shaded('surface attack() { Ci = texture("nosuch.tx", s, t, "blur", 1e30, "width", 1e30, "samples", 1e9)'
                  ' + environment("nosuch.env", N, "samples", 1e9) + shadow("nosuch.sm", P, "samples", 1e9);'
                  " Oi = 1; }\n")


@attack
def turns_as_many_as_asked(size, chance):
    """The limit of turns lifted by the scene itself."""
    return shaded(f"surface attack() {{ {VARIABLES}{ENDLESS['while']} Ci = x; Oi = 1; }}\n",
                  options='Option "shading" "integer loopturns" [2147483647]\n', words=["--time-limit", "3"])


@attack
def run_verb_endless(size, chance):
    made = shaded(f"surface attack() {{ {VARIABLES}{ENDLESS['within-each-other']} Ci = x; Oi = 1; }}\n")
    return Attempt(made.files, ["run", "attack.sl", "--size", "16x16"])
