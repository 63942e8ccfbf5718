# SPDX-License-Identifier: Apache-2.0
"""Doubling: forty lines that mean 2^40 things."""
from attacks.attack import attack, counted, filled, scene, shaded

LEVELS = 40


def objects(first, instance="ObjectInstance {0}", between=""):
    """Objects that each hold the one before twice."""
    text = f"ObjectBegin 0 {first} ObjectEnd\n"
    for i in range(1, LEVELS):
        one = instance.format(i - 1)
        text += f"ObjectBegin {i} {one} Translate .001 0 0 {between} {one} ObjectEnd\n"
    return text + f"Translate 0 0 5 ObjectInstance {LEVELS - 1}"


@attack(quick=True)
def objects_twice(size, chance):
    return scene(objects("Sphere 1 -1 1 360"))


@attack
def objects_twice_moving(size, chance):
    return scene(objects("Sphere 1 -1 1 360", between="MotionBegin [0 1] Scale 1 1 1 Scale 2 1 1 MotionEnd"),
                 options="Shutter 0 1\n")


@attack
def objects_twice_lamps(size, chance):
    text = 'AreaLightSource "arealight" 9 "intensity" [1] Illuminate 9 1\n'
    return scene(text + objects("Sphere 1 -1 1 360"))


@attack
def objects_twice_solids(size, chance):
    solid = 'SolidBegin "union" {0} {0} SolidEnd'
    primitive = 'SolidBegin "primitive" Sphere 1 -1 1 360 SolidEnd'
    return scene(objects(solid.format(primitive), instance=solid.format("ObjectInstance {0}")))


@attack
def objects_large_often(size, chance):
    """Some thousand instances of some thousand spheres."""
    text = f"ObjectBegin 1 {filled(size // 2, 'Sphere 1 -1 1 360 ')} ObjectEnd\nTranslate 0 0 5\n"
    return scene(text + filled(size // 2, "ObjectInstance 1\n"))


@attack
def lamps_large_often(size, chance):
    """A light of some thousand instances of some thousand discs."""
    text = f"ObjectBegin 1 {filled(size // 2, 'Disk 0 1 360 ')} ObjectEnd\nTranslate 0 0 5\n"
    lamp = 'AreaLightSource "arealight" 9 "intensity" [1]\n'
    return scene(text + lamp + filled(size // 2, "ObjectInstance 1\n"))


@attack
def displaced_often(size, chance):
    text = "ObjectBegin 1 Sphere 1 -1 1 360 ObjectEnd\nTranslate 0 0 5\n" \
           'Displacement "bumpy" Attribute "displacementbound" "sphere" [1]\n'
    return scene(text + filled(size, "Scale 1.01 1 1 ObjectInstance 1\n"))


@attack
def declared_solids_twice(size, chance):
    """Unions in pairs, fifteen levels deep."""
    def union(depth):
        if depth == 0:
            return 'SolidBegin "primitive" Sphere 1 -1 1 360 SolidEnd '
        half = union(depth - 1)
        return f'SolidBegin "union" {half}{half}SolidEnd '
    text = union(10)
    return scene("Translate 0 0 5 " + filled(size, text))


def macros(twice, last, levels=LEVELS):
    """Macros that each hold the next one twice."""
    text = f"#define m{levels} {last}\n"
    for i in reversed(range(levels)):
        text += f"#define m{i} {twice.format(f'm{i + 1}')}\n"
    return text


@attack(quick=True)
def macros_twice(size, chance):
    return shaded(f"surface attack() {{\n{macros('{0} + {0}', '1')}Ci = m0; Oi = 1; }}\n")


@attack
def macros_with_arguments(size, chance):
    text = f"#define m{LEVELS}(x) x\n"
    for i in reversed(range(LEVELS)):
        text += f"#define m{i}(x) m{i + 1}(x + x)\n"
    return shaded(f"surface attack() {{\n{text}Ci = m0(1); Oi = 1; }}\n")


@attack
def macros_to_nothing(size, chance):
    return shaded(f"surface attack() {{\n{macros('{0} {0}', '')}m0 Ci = 1; Oi = 1; }}\n")


@attack
def macros_in_conditions(size, chance):
    text = macros("({0} || {0})", "0")
    return shaded(f"{text}#if m0\n#endif\nsurface attack() {{ Ci = 1; Oi = 1; }}\n".lstrip(), "attack")


@attack
def includes_twice(size, chance):
    files = {f"i{i}_dot_h": f'#include "i{i + 1}.h"\n' * 2 for i in range(LEVELS)}
    files[f"i{LEVELS}_dot_h"] = "\n"
    return shaded('surface attack() {\n#include "i0.h"\nCi = 1; Oi = 1; }\n', **files)


@attack
def includes_of_itself(size, chance):
    return shaded('surface attack() {\n#include "i.h"\nCi = 1; Oi = 1; }\n',
                  i_dot_h=filled(size, '#include "i.h"\n'))


@attack
def includes_often(size, chance):
    return shaded("surface attack() {\n" + filled(size // 2, '#include "i.h"\n') + "Ci = 1; Oi = 1; }\n",
                  i_dot_h=filled(size // 2, "/* nothing */\n"))


@attack(quick=True)
def strings_twice(size, chance):
    return shaded('surface attack() { string s = "x";\n' + "s = concat(s, s);\n" * LEVELS +
                  'Ci = s == "x" ? 1 : 0; Oi = 1; }\n')


@attack
def functions_twice(size, chance):
    text = "surface attack() {\nfloat f0(float x;) { return noise(x); }\n"
    for i in range(1, 30):
        text += f"float f{i}(float x;) {{ return f{i - 1}(x) + f{i - 1}(x + 1); }}\n"
    return shaded(text + "Ci = f29(s); Oi = 1; }\n")


@attack
def loops_of_eight_levels(size, chance):
    loops = "".join(f"for (x{i} = 0; x{i} < 8; x{i} += 1) " for i in range(12))
    names = ", ".join(f"x{i}" for i in range(12))
    return shaded(f"surface attack() {{ float {names}, a = 0; {loops} a += noise(a); Ci = a; Oi = 1; }}\n")


@attack
def derivatives_of_derivatives(size, chance):
    depth = 40
    return shaded("surface attack() { Ci = " + "Du(" * depth + "noise(P * u)" + ")" * depth + "; Oi = 1; }\n")


@attack
def normals_of_normals(size, chance):
    return shaded("surface attack() { point p = P;\n" + "p += calculatenormal(p) * noise(p);\n" * 60 +
                  "Ci = color p; Oi = 1; }\n")


@attack
def squares_of_vectors(size, chance):
    """Sums that each use the last twice: a tree of 2^n leaves, a list of n operations."""
    return shaded("surface attack() { color c = noise(P);\n" + counted(size, "c = c * c + {};\n") +
                  "Ci = c; Oi = 1; }\n")
