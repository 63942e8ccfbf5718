# SPDX-License-Identifier: Apache-2.0
"""One token as long as the file: names, strings, numbers, comments."""
from attacks.attack import HEAD, WORLD, Attempt, attack, filled, scene

SPHERE = "\nTranslate 0 0 5 Sphere 1 -1 1 360"
PLACES = {  # What a long word stands in the place of.
    "request": "{0} 1 2 3",
    "surface": 'Surface "{0}"',
    "light": 'LightSource "{0}" 3',
    "parameter": 'Surface "plastic" "{0}" [1]',
    "type": 'Surface "plastic" "uniform {0} Kd" [1]',
    "array": 'Surface "plastic" "uniform float[{0}] Kd" [1]',
    "declared": 'Declare "{0}" "uniform float"',
    "archive": 'ReadArchive "{0}"',
    "coordinate-system": 'CoordinateSystem "{0}" CoordSysTransform "{0}"',
    "attribute": 'Attribute "{0}" "{0}" [1]',
    "object": 'ObjectBegin "{0}" Sphere 1 -1 1 360 ObjectEnd ObjectInstance "{0}"',
    "condition": "IfBegin \"${0} == 1\" IfEnd",
    "geometry": 'Geometry "{0}"',
    "texture": 'Surface "paintedplastic" "string texturename" ["{0}"]',
    "unfinished": 'Surface "{0}',
}
LONG = {
    "letters": lambda size: "x" * size,
    "blanks": lambda size: " " * size,
    "words": lambda size: filled(size, "ab "),
    "dots": lambda size: filled(size, "../"),
    "colours-of-terminals": lambda size: filled(size, "\x1b[31m"),
    "quotes": lambda size: filled(size, "\\\""),
    "formats": lambda size: filled(size, "%s%n"),
    "many-bytes": lambda size: filled(size // 4, "\U0001f600"),
}


def long_word(place, text, word):
    def make(size, chance):
        return scene(text.format(LONG[word](size // text.count("{0}"))) + SPHERE)
    attack(make, quick=(place, word) in (("request", "letters"), ("unfinished", "words")),
           name=f"long-{place}-of-{word}")


for where, requests in PLACES.items():
    long_word(where, requests, "letters")
for kind in LONG:
    if kind != "letters":
        long_word("surface", PLACES["surface"], kind)
long_word("texture", PLACES["texture"], "dots")
long_word("unfinished", PLACES["unfinished"], "words")

OPTIONS = {
    "display": 'Display "{0}" "openexr" "rgba"\n',
    "display-type": 'Display "out.exr" "{0}" "rgba"\n',
    "display-channels": 'Display "out.exr" "openexr" "{0}"\n',
    "search-path": 'Option "searchpath" "string shader" ["{0}"]\n',
    "option": 'Option "render" "string integrator" ["{0}"]\n',
    "filter": 'PixelFilter "{0}" 2 2\n',
    "imager": 'Imager "{0}"\n',
    "variable": 'Option "searchpath" "string shader" ["%{0}%"]\n',
}
for where, option in OPTIONS.items():
    attack(lambda size, chance, option=option: scene(SPHERE, option.format("y" * size)),
           name=f"long-{where}")

NUMBERS = {
    "digits": "9" * 50,
    "zeros": "0" * 50,
    "signs": "-" * 50,
    "dots": "." * 50,
    "exponents": "1e9" * 20,
}
for kind, piece in NUMBERS.items():
    attack(lambda size, chance, piece=piece: scene("Translate 0 0 " + filled(size, piece) + SPHERE),
           name=f"long-number-of-{kind}")


@attack
def number_with_small_exponent(size, chance):
    return scene("Translate 0 0 ." + "0" * size + f"1e{size}" + SPHERE)


@attack
def comment_without_end(size, chance):
    return Attempt({"scene.rib": HEAD + WORLD + "#" * size})


@attack
def structure_comments(size, chance):
    return Attempt({"scene.rib": filled(size, "##RenderMan RIB-Structure 1.1 x\n")})


@attack(quick=True)
def array_without_end(size, chance):
    return scene('Polygon "P" [' + filled(size, "1 2 3 "))


@attack
def array_of_strings(size, chance):
    return scene('Attribute "user" "string[9] s" [' + filled(size, '"" ') + "]")


@attack
def blank_lines(size, chance):
    return Attempt({"scene.rib": "\n" * size})


@attack
def nothing_but_zeros(size, chance):
    return Attempt({"scene.rib": b"\0" * size})


@attack
def nothing_but_quotes(size, chance):
    return Attempt({"scene.rib": '"' * size})


@attack
def one_line(size, chance):
    """Errors all over one line of 100 kB: each quotes it."""
    return scene(filled(size, "Sphere 0 nosuch 0 0 "))


@attack
def bytes_of_every_kind(size, chance):
    return Attempt({"scene.rib": chance.randbytes(size)})
