# SPDX-License-Identifier: Apache-2.0
"""Binary RIB (RI 3.2, appendix C.2) and gzip: most requests for a byte."""
import gzip
import struct

from attacks.attack import HEAD, WORLD, Attempt, attack, filled

COUNT_1 = 0o310  # An array of floats whose length is told in one byte; + 3: in four.
STRING_4 = 0o243  # A string whose length is told in four.


def request(code, name):
    return bytes([0o314, code, 0o220 + len(name)]) + name


def call(code):
    return bytes([0o246, code])


def binary_scene(body):
    return Attempt({"scene.rib": (HEAD + WORLD).encode() + body + b"\nWorldEnd\n"})


def plain_scene(body):
    return (HEAD + WORLD + body + "\nWorldEnd\n").encode()


@attack(quick=True)
def binary_depth(size, chance):
    """Two bytes a level."""
    return binary_scene(request(0, b"AttributeBegin") + call(0) * (size // 2))


@attack
def binary_worlds(size, chance):
    """Four bytes a picture."""
    codes = request(0, b"WorldBegin") + request(1, b"WorldEnd")
    return Attempt({"scene.rib": HEAD.encode() + codes + (call(0) + call(1)) * (size // 4)})


@attack
def binary_instances(size, chance):
    codes = request(0, b"ObjectInstance") + b'\nTranslate 0 0 5 ObjectBegin 1 Sphere 1 -1 1 360 ObjectEnd\n'
    return binary_scene(codes + (call(0) + bytes([0o200, 1])) * (size // 4))


@attack
def binary_teapots(size, chance):
    return binary_scene(request(0, b"Geometry") + bytes([0o315, 1, 0o226]) + b"teapot" +
                        (call(0) + bytes([0o317, 1])) * (size // 4))


@attack
def binary_strings_of_handles(size, chance):
    """A long string, said again by two bytes."""
    half = size // 2
    define = bytes([0o315, 1, STRING_4]) + half.to_bytes(4, "big") + b"x" * half
    return binary_scene(define + b' Attribute "user" "string s" [' + bytes([0o317, 1]) * (half // 2) + b"]")


@attack
def binary_string_names(size, chance):
    """A long name of a shader, said again by two bytes."""
    half = size // 2
    define = bytes([0o315, 1, STRING_4]) + half.to_bytes(4, "big") + b"x" * half
    return binary_scene(define + request(0, b"Surface") +
                        (call(0) + bytes([0o317, 1]) + b" Sphere 1 -1 1 360 ") * (half // 24))


@attack(quick=True)
def binary_lying_lengths(size, chance):
    huge = b"\xff\xff\xff\xff"
    arrays = b'Polygon "P" ' + bytes([COUNT_1 + 3]) + huge + b"\0\0\0\0" * 9
    strings = b" Surface " + bytes([STRING_4]) + huge
    return binary_scene((arrays + strings) * (size // len(arrays + strings)))


@attack
def binary_noise(size, chance):
    return binary_scene(chance.randbytes(size))


@attack
def binary_control_bytes(size, chance):
    return binary_scene(bytes(chance.randrange(0o200, 0o400) for _ in range(size)))


def bomb(name, unit, megabytes, before=None, quick=False):
    """A gzip file of many copies of a unit, to be read whole."""
    def make(size, chance):
        text = unit * (megabytes * 1_000_000 // len(unit))
        content = gzip.compress((before or HEAD + WORLD).encode() + text.encode(), 9)
        return Attempt({"scene.rib": content[:size] if len(content) > size else content})
    attack(make, quick=quick, name=name)


bomb("gzip-blanks", " ", 100)
bomb("gzip-comments", "#" + " " * 77 + "\n", 100)
bomb("gzip-one-comment", "x", 100, before="#")
bomb("gzip-one-string", "x", 100, before='Surface "')
bomb("gzip-one-number", "1", 100, before="Format ")
bomb("gzip-one-array", "0 ", 100, before=HEAD + WORLD + 'Polygon "P" [')
bomb("gzip-spheres", "Sphere 1 -1 1 360\n", 25)
bomb("gzip-blocks", "AttributeBegin\n", 25)
bomb("gzip-errors", "Sphere 0 0 0 0 0\n", 25)
bomb("gzip-unknown-words", "nosuch ", 25)


@attack
def gzip_of_gzip(size, chance):
    content = plain_scene(" " * 50_000_000)
    for _ in range(5):
        content = gzip.compress(content, 9)
    return Attempt({"scene.rib": content})


@attack
def gzip_members(size, chance):
    """Thousands of packed files one behind the other."""
    return Attempt({"scene.rib": filled_bytes(size, gzip.compress(b"Sphere 1 -1 1 360\n"))})


def filled_bytes(size, unit):
    return unit * (size // len(unit))


@attack
def gzip_cut(size, chance):
    return Attempt({"scene.rib": gzip.compress(plain_scene(filled(size, "Sphere 1 -1 1 360\n")))[:-20]})


@attack
def binary_matrices(size, chance):
    floats = struct.pack(">16f", *(chance.uniform(-1, 1) for _ in range(16)))
    matrix = bytes([COUNT_1, 16]) + floats
    body = request(0, b"ConcatTransform") + (call(0) + matrix) * (size // (len(matrix) + 2))
    return binary_scene(body + b" Sphere 1 -1 1 360")
