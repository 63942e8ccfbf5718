# SPDX-License-Identifier: Apache-2.0
"""What a generator makes, and the table of all generators."""
from dataclasses import dataclass, field
from typing import Callable

ATTACKS = {}  # Each generator by its name.

HEAD = """Format 16 16 1
Display "out.exr" "openexr" "rgba"
Projection "perspective" "fov" [50]
"""
WORLD = """WorldBegin
LightSource "ambientlight" 1 "intensity" [.3]
LightSource "distantlight" 2
"""
RENDER = ["scene.rib", "--spp", "1", "--quiet"]
PLACES = {  # A shader of each kind, in the place of a request.
    "surface": ("", 'Surface "{0}"'),
    "displacement": ("", 'Displacement "{0}"'),
    "volume": ("", 'Atmosphere "{0}"'),
    "light": ("", 'LightSource "{0}" 3'),
    "imager": ('Imager "{0}"', ""),
    "filter": ('PushFilter "{0}"', ""),
}


@dataclass
class Attempt:
    """Files by name, and the words of the command line that gets them."""
    files: dict
    words: list = field(default_factory=lambda: list(RENDER))
    prepare: Callable = None  # Puts into the folder what is no plain file.

    def write(self, folder):
        self.write_files(folder)
        if self.prepare:
            self.prepare(folder)

    def write_files(self, folder):
        for name, content in self.files.items():
            data = content if isinstance(content, bytes) else content.encode()
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)


@dataclass
class Attack:
    make: Callable  # Of the size in bytes and a source of random numbers.
    quick: bool  # One of the everyday tests.


def attack(make=None, *, quick=False, name=None):
    """Puts a generator into the table, under its function's name if it is given no other."""
    def put(function):
        ATTACKS[name or function.__name__.replace("_", "-")] = Attack(function, quick)
        return function
    return put(make) if make else put


def scene(requests, options="", words=(), **files):
    """A scene of 16 x 16 pixels that holds these requests; files by their names without dots."""
    text = f"{HEAD}{options}{WORLD}{requests}\nWorldEnd\n"
    return Attempt({"scene.rib": text, **with_dots(files)}, [*RENDER, *words])


def shaded(source, shader="attack", words=(), requests="", options="", **files):
    """A scene with a shader of this source, in the place of its kind, on a sphere."""
    kind = source.lstrip().split()[0]
    option, attribute = (text.format(shader) for text in PLACES.get(kind, PLACES["surface"]))
    body = f"{attribute}\n{requests}\nTranslate 0 0 4\nSphere 1.4 -1.4 1.4 360"
    made = scene(body, option + "\n" + options, words, **files)
    made.files[f"{shader}.sl"] = source
    return made


def with_dots(files):
    return {name.replace("_dot_", "."): content for name, content in files.items()}


def filled(size, unit):
    """Copies of a text, as many as the size has room for."""
    return unit * (size // len(unit))


def counted(size, unit, first=0):
    """Copies of a text with {} in it, numbered, as many as the size has room for."""
    parts, left = [], size
    while left > 0:
        parts.append(unit.format(first + len(parts)))
        left -= len(parts[-1])
    return "".join(parts[:-1])


def numbers(values):
    return " ".join(f"{value:.6g}" for value in values)
