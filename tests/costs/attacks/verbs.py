# SPDX-License-Identifier: Apache-2.0
"""The verbs, given what is made to be dear."""
import gzip
import zlib

from attacks.attack import ATTACKS, Attempt, attack, counted, filled, scene, shaded
from attacks.pictures import png

PICTURE = png(16, 16, zlib.compress(bytes(16 * (3 * 16 + 1))))


def again(name, origin, words):
    """The files of another generator, for another verb."""
    def make(size, chance):
        return Attempt(ATTACKS[origin].make(size, chance).files, words)
    attack(make, name=name)


CAT = ["cat", "scene.rib", "-o", "out.rib"]
for origin in ("deep-attributes", "deep-conditions", "long-request-of-letters", "long-number-of-digits",
               "long-unfinished-of-words", "binary-strings-of-handles", "binary-string-names", "binary-lying-lengths",
               "binary-noise", "gzip-blanks", "gzip-one-array", "gzip-one-string", "messages-of-requests", "one-line",
               "structure-comments", "binary-worlds"):
    again(f"cat-{origin}", origin, [*CAT])
again("cat-binary-noise-to-binary", "binary-noise", [*CAT, "--binary", "--gzip"])
again("cat-unknown-words-to-binary", "messages-of-requests", [*CAT, "--binary"])

for origin in ("macros-twice", "shader-deep-parentheses", "shader-deep-choices", "shader-long-noises",
               "shader-one-sum", "shader-one-parameters", "functions-twice", "strings-twice", "shader-long-arrays",
               "shader-long-light-loops", "compiler-messages-of-unknown-variables", "derivatives-of-derivatives"):
    again(f"compile-{origin}", origin, ["compile", "attack.sl"])
    again(f"info-{origin}", origin, ["info", "attack.sl"])
for emit in ("passes", "ir", "llvm", "asm"):
    again(f"compile-to-{emit}", "shader-long-conditions",
          ["compile", "attack.sl", "--emit", emit, "-o", "out.txt"])
again("run-many-values", "shader-one-parameters", ["run", "attack.sl", "--size", "64x64", "-o", "out.exr"])
again("run-endless", "endless-while", ["run", "attack.sl", "--size", "16x16", "-o", "out.exr"])
again("run-bounds", "shader-long-noises", ["run", "attack.sl", "--bounds", "--size", "8x8", "-o", "out.exr"])
again("run-of-huge-size", "endless-of-nothing-needed", ["run", "attack.sl", "--size", "100000x100000"])
for origin in ("endless-filter", "endless-nested-filter"):
    def filtered(size, chance, origin=origin):
        files = dict(ATTACKS[origin].make(size, chance).files)
        files["p.png"] = PICTURE
        return Attempt(files, ["filter", "p.png", "q.exr", "-f", "attack", "--shader-path", "."])
    attack(filtered, name=f"filter-{origin}")


@attack
def filters_by_the_hundred(size, chance):
    return Attempt({"p.png": PICTURE}, ["filter", "p.png", "q.exr", *["-f", "bloom"] * 300])


@attack
def filter_of_many_values(size, chance):
    return Attempt({"p.png": PICTURE},
                   ["filter", "p.png", "q.exr", "-f", "bloom", *[f"nosuch{i}=1" for i in range(size // 20)]])


ROOM = 'Translate 0 0 5 Sphere 1 -1 1 360\n'
POINTS = {
    "lines": "0 0 0 0 0 1\n",
    "wrong": "nosuch {}\n",
    "numbers": "1e38 nan inf 0 0 0\n",
    "blank": "\n",
}
for kind, text in POINTS.items():
    attack(lambda size, chance, text=text: Attempt(
        {**scene(ROOM).files, "points.txt": counted(size, text) if "{}" in text else filled(size, text)},
        ["probe", "scene.rib", "points.txt", "--spp", "1"]),
        name=f"probe-points-{kind}")


@attack
def probe_of_one_line(size, chance):
    return Attempt({**scene(ROOM).files, "points.txt": filled(size, "1 ")},
                   ["probe", "scene.rib", "points.txt", "--spp", "1"])


@attack
def probe_of_packed_points(size, chance):
    return Attempt({**scene(ROOM).files, "points.txt": gzip.compress(bytes(50_000_000))},
                   ["probe", "scene.rib", "points.txt", "--spp", "1"])


@attack
def probe_of_huge_grid(size, chance):
    return Attempt(scene(ROOM).files, ["probe", "scene.rib", "--plane", "0,0,0,1,0,0,0,1,0", "--grid",
                                       "1000000000x1000000000", "--spp", "1", "-o", "out.exr"])


@attack
def probe_of_no_plane(size, chance):
    return Attempt(scene(ROOM).files, ["probe", "scene.rib", "--plane", "nan,inf,1e400,0,0,0,0,0,0", "--grid", "9x9"])


WORD = {
    "help": ["help", "{}"],
    "format": ["scene.rib", "--format", "{}"],
    "frames": ["scene.rib", "--frames", "{}"],
    "crop": ["scene.rib", "--crop", "{}"],
    "output": ["scene.rib", "-o", "{}"],
    "shader-path": ["scene.rib", "--shader-path", "{}"],
    "option": ["scene.rib", "--{}"],
    "verb": ["{}"],
    "scene": ["{}.rib"],
    "info": ["info", "{}"],
    "define": ["compile", "attack.sl", "-D", "{}"],
    "parameter": ["run", "attack.sl", "{}=1"],
    "value": ["run", "attack.sl", "Kd={}"],
}
for place, words in WORD.items():
    attack(lambda size, chance, words=words: Attempt(
        {**shaded("surface attack(float Kd = 1) { Ci = Kd; Oi = 1; }\n").files},
        [word.format("9" * size) for word in words]), name=f"word-of-{place}", quick=place in ("help", "frames"))


@attack
def frames_without_number(size, chance):
    """Ranges that overlap, each of two thousand million frames."""
    return Attempt(scene(ROOM).files, ["scene.rib", "--frames", ",".join(["1-2000000000"] * (size // 13))])


@attack
def checkpoint_of_anything(size, chance):
    return Attempt({**scene(ROOM).files, "c": chance.randbytes(size)}, ["scene.rib", "--resume", "c"])
