# SPDX-License-Identifier: Apache-2.0
"""Messages: every mistake as often as there is room for, each time with other words."""
from attacks.attack import attack, counted, scene, shaded

WORDS = {  # One message each, at least; {0} makes it another.
    "requests": "Nosuch{0} 1 2 3\n",
    "requests-of-letters": "Sphere{0}x\n",
    "parameters": 'Surface "plastic" "nosuch{0}" [1]\n',
    "parameter-types": 'Surface "plastic" "unifrom flaot x{0}" [1]\n',
    "attributes": 'Attribute "nosuch{0}" "x{0}" [1]\n',
    "options-within-worlds": 'Option "nosuch{0}" "x{0}" [1]\n',
    "values": 'Attribute "visibility" "string transmission" ["no{0}"]\n',
    "archives": 'ReadArchive "no/such/{0}"\n',
    "shaders": 'Surface "nosuch{0}" Sphere 1 -1 1 360\n',
    "lights": 'LightSource "nosuch{0}" {0}\n',
    "objects": 'ObjectInstance "{0}"\n',
    "illuminated": 'Illuminate "{0}" 1\n',
    "spaces": 'CoordSysTransform "nosuch{0}"\n',
    "arguments": 'Sphere "{0}" 1\n',
    "counts": 'Polygon "P" [0 0 0 1 0 0 0 1 0] "varying float s{0}" [1 2 3 4 5]\n',
    "degenerate": "Sphere 0 {0} {0} 360\n",
    "textures": 'Surface "paintedplastic" "string texturename" ["no{0}.tx"] Sphere 1 -1 1 9\n',
    "geometry": 'Geometry "nosuch{0}"\n',
    "procedurals": 'Procedural "nosuch{0}" ["x"] [0 1 0 1 0 1]\n',
    "conditions": 'IfBegin "{0} +* $$" IfEnd\n',
    "bases": 'Basis "nosuch{0}" 3 "nosuch{0}" 3\n',
    "declarations": 'Declare "x{0}" "flaot{0}"\n',
    "ends": "AttributeEnd SolidEnd MotionEnd # {0}\n",
    "strings-with-returns": 'Surface "x\\r{0}\\e[2J"\n',
    "singular": "AttributeBegin Scale 1 0 {0} Sphere 1 -1 1 360 AttributeEnd\n",
    "motion": "MotionBegin [0 1] Translate {0} 0 0 Scale 1 1 1 MotionEnd\n",
    "quotes-forgotten": 'Surface "matte{0}\n',
    "brackets-forgotten": 'Surface "plastic" "Kd" [1 {0}\n',
    "commas": "Color [.1, .2, .{0}]\n",
    "foreign": 'ShaderLayer "x{0}" "y" "z"\n',
    "solids": 'SolidBegin "nosuch{0}" Sphere 1 -1 1 360 SolidEnd\n',
    "trims": "TrimCurve [1] [{0}] [0] [0] [1] [9] [0] [0] [0]\n",
    "nurbs": 'NuPatch {0} 3 [1] 0 1 2 2 [1] 0 1 "P" [1]\n',
    "subdivision": 'SubdivisionMesh "nosuch{0}" [4] [0 1 2 {0}] "P" [0 0 0]\n',
    "blobs": 'Blobby 1 [9{0} 0] [1] [""]\n',
}
for kind, text in WORDS.items():
    attack(lambda size, chance, text=text: scene(counted(size, text)), name=f"messages-of-{kind}",
           quick=kind in ("requests", "shaders", "conditions"))

OPTIONS = {
    "options": 'Option "nosuch{0}" "x{0}" [1]\n',
    "displays": 'Display "+d{0}.exr" "nosuch{0}" "nosuch{0}"\n',
    "folders": 'Display "+no/such/{0}/d.exr" "openexr" "rgba"\n',
    "pixel-filters": 'PixelFilter "nosuch{0}" 2 2\n',
    "projections": 'Projection "nosuch{0}"\n',
    "hiders": 'Hider "nosuch{0}"\n',
    "imagers": 'Imager "nosuch{0}"\n',
    "frame-filters": 'PushFilter "nosuch{0}"\n',
    "quantizers": 'Quantize "nosuch{0}" {0} 0 1 1\n',
    "channels": 'Display "+d{0}.exr" "openexr" "nosuch{0}"\n',
    "made-textures": 'MakeTexture "nosuch{0}" "x{0}" "nosuch" "nosuch" "nosuch{0}" {0} {0}\n',
}
for kind, text in OPTIONS.items():
    attack(lambda size, chance, text=text: scene("", counted(size, text)), name=f"messages-of-{kind}",
           quick=kind == "displays")


def body(statements):
    return shaded("surface attack() {\n" + statements + "Ci = Cs; Oi = Os;\n}\n")


STATEMENTS = {
    "unknown-variables": "Ci = nosuch{0};\n",
    "unknown-functions": "Ci = nosuch{0}(P);\n",
    "unknown-types": "flaot{0} x{0} = 1;\n",
    "types": "float x{0} = matrix;\n",
    "missing-semicolons": "Ci = {0}\n",
    "spaces": 'Ci = color "nosuch{0}" 1;\n',
    "later-functions": "Ci = photonmap(\"m{0}\", P, N);\n",
    "unused": "float x{0} = {0};\n",
    "characters": "\x01\x1b[2J {0};\n",
    "directives": "#nosuch{0}\n",
    "includes": '#include "nosuch{0}.h"\n',
    "error-directives": "#error words {0}\n",
    "again": "float same = {0};\n",
    "redefined": "#define M {0}\n",
    "strings": 'string s{0} = "\\q{0}\n',
}
for kind, text in STATEMENTS.items():
    attack(lambda size, chance, text=text: body(counted(size, text)), name=f"compiler-messages-of-{kind}",
           quick=kind == "unknown-variables")


@attack
def messages_of_shaders_each_another(size, chance):
    """As many shaders as there is room for, each with errors of its own."""
    count = size // 250
    made = scene("".join(f'Surface "s{i}" Sphere 1 -1 1 9\n' for i in range(count)))
    made.files |= {f"s{i}.sl": f"surface s{i}() {{\n" + f"Ci = nosuch{i};\n" * 10 + "}\n" for i in range(count)}
    return made


@attack
def printed_by_every_point(size, chance):
    """Points by the hundred, each with a kilobyte to say."""
    text = "x" * 1000
    return shaded(f'surface attack() {{ float i; for (i = 0; i < 1000000; i += 1) printf("{text} %f\\n", i);'
                  " Ci = 1; Oi = 1; }\n")


@attack
def printed_by_arrays(size, chance):
    return shaded("surface attack() { uniform float i = 0; while (i < 1000000) { i += 1; " +
                  'printf("%m %m\\n", matrix 1, matrix 2); } Ci = i; Oi = 1; }\n')


@attack
def warned_by_every_texture(size, chance):
    return shaded('surface attack() { string s = ""; float i; for (i = 0; i < 1000; i += 1) '
                  'Ci += texture(format("no%f.tx", i), s, t); Oi = 1; }\n')
