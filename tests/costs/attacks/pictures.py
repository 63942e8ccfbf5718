# SPDX-License-Identifier: Apache-2.0
"""Pictures whose headers claim more than there is, as textures and for the verbs."""
import struct
import zlib

from attacks.attack import Attempt, attack, scene

HUGE = 2**31 - 1


def png_chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, data, more=b""):
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", header) + more + png_chunk(b"IDAT", data) + \
        png_chunk(b"IEND", b"")


def packed_zeros(size):
    """Nothing, packed: about a thousand times as much as the size."""
    packer, parts, length = zlib.compressobj(9), [], 0
    while length < size - 2000:
        parts.append(packer.compress(bytes(1 << 20)))
        length += len(parts[-1])
    return b"".join(parts) + packer.flush()


def exr_attribute(name, kind, data):
    return name + b"\0" + kind + b"\0" + struct.pack("<I", len(data)) + data


def exr(window, more=b"", rows=b""):
    channel = b"".join(name + b"\0" + struct.pack("<IIII", 2, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    box = struct.pack("<4i", *window)
    return b"\x76\x2f\x31\x01\x02\0\0\0" + exr_attribute(b"channels", b"chlist", channel) + \
        exr_attribute(b"compression", b"compression", b"\3") + exr_attribute(b"dataWindow", b"box2i", box) + \
        exr_attribute(b"displayWindow", b"box2i", box) + exr_attribute(b"lineOrder", b"lineOrder", b"\0") + \
        exr_attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1)) + \
        exr_attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)) + \
        exr_attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + more + b"\0" + rows


def tiff(entries, next_folder=0, rest=b""):
    folder = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", *entry) for entry in entries)
    return b"II*\0" + struct.pack("<I", 8) + folder + struct.pack("<I", next_folder) + rest


def tiff_picture(width, height, next_folder=0, offset=400, packed=1, rest=b""):
    return tiff([(256, 4, 1, width), (257, 4, 1, height), (258, 3, 1, 8), (259, 3, 1, packed), (262, 3, 1, 1),
                 (273, 4, 1, offset), (277, 3, 1, 1), (278, 4, 1, height), (279, 4, 1, HUGE)], next_folder, rest)


LIARS = {  # Bytes of a picture, of a size.
    "png-huge": lambda size: png(HUGE, HUGE, zlib.compress(bytes(size))),
    "png-large": lambda size: png(30000, 30000, zlib.compress(bytes(size))),
    "png-bomb": lambda size: png(5800, 5800, packed_zeros(size)),
    "png-one-column": lambda size: png(1, HUGE, packed_zeros(size)),
    "png-of-text": lambda size: png(1, 1, zlib.compress(bytes(4)),
                                    png_chunk(b"zTXt", b"x\0\0" + packed_zeros(size))),
    "exr-huge": lambda size: exr((-HUGE, -HUGE, HUGE, HUGE)),
    "exr-large": lambda size: exr((0, 0, 100000, 100000)),
    "exr-large-square": lambda size: exr((0, 0, 20000, 20000), rows=bytes(size)),
    "exr-turned-round": lambda size: exr((9, 9, -9, -9)),
    "exr-attributes": lambda size: exr((0, 0, 9, 9), b"".join(
        exr_attribute(b"a%d" % i, b"int", bytes(4)) for i in range(size // 20))),
    "exr-attribute-huge": lambda size: exr((0, 0, 9, 9), b"a\0string\0\xff\xff\xff\x7f"),
    "exr-offsets": lambda size: exr((0, 0, 1000, 200000), rows=b"\xff" * size),
    "tiff-huge": lambda size: tiff_picture(HUGE, HUGE),
    "tiff-large": lambda size: tiff_picture(40000, 40000, rest=bytes(size)),
    "tiff-folder-of-itself": lambda size: tiff_picture(4, 4, next_folder=8, rest=bytes(1000)),
    "tiff-of-many-samples": lambda size: tiff([(256, 4, 1, 1000), (257, 4, 1, 1000), (258, 3, 1, 8),
                                               (277, 3, 1, 65535), (273, 4, 1, 8), (279, 4, 1, 9)]),
    "tiff-huge-counts": lambda size: tiff([(273, 4, HUGE, 8), (256, 4, 1, 4), (257, 4, 1, 4), (279, 4, HUGE, 8)]),
    "tiff-packed": lambda size: tiff_picture(20000, 20000, packed=8, rest=bytes(300) + packed_zeros(size)),
    "hdr-huge": lambda size: b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n" + bytes(size),
    "hdr-large": lambda size: b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 30000\n" + bytes(size),
    "hdr-header-without-end": lambda size: b"#?RADIANCE\n" + b"x=1\n" * (size // 4),
    "jpeg-large": lambda size: b"\xff\xd8\xff\xc0\0\x11\x08\xff\xff\xff\xff\3\1\x22\0\2\x11\1\3\x11\1" +
                  b"\xff\xda\0\x0c\3\1\0\2\x11\3\x11\0\x3f\0" + bytes(size),
    "gif-large": lambda size: b"GIF89a\xff\xff\xff\xff\x80\0\0" + bytes(6) +
                 b"\x2c\0\0\0\0\xff\xff\xff\xff\0\2" + bytes(size),
    "bmp-large": lambda size: b"BM" + struct.pack("<IHHIIiiHHIIiiII", HUGE, 0, 0, 54, 40, 30000, 30000, 1, 24,
                                                  0, 0, 1, 1, 0, 0) + bytes(size),
    "tga-large": lambda size: b"\0\0\x0a" + bytes(9) + struct.pack("<HHBB", 65535, 65535, 32, 0) +
                 b"\xff\0\0\0\0" * (size // 5),
    "pnm-large": lambda size: b"P6 30000 30000 255\n" + bytes(size),
    "pnm-huge": lambda size: b"P6 2000000000 2000000000 65535\n" + bytes(size),
    "psd-large": lambda size: b"8BPS\0\1" + bytes(6) + struct.pack(">HIIHH", 3, 30000, 30000, 8, 3) + bytes(size),
    "text": lambda size: b"no picture at all " * (size // 18),
}
USES = {  # What a picture is given to.
    "texture": ["--spp", "1"],
    "tex": ["tex", "p.{}", "q.tx"],
    "shadow-tex": ["tex", "--shadow", "p.{}", "q.tx"],
    "diff": ["diff", "p.{}", "p.{}"],
    "filter": ["filter", "p.{}", "q.exr", "-f", "bloom"],
    "merge": ["merge", "p.{0}", "p.{0}", "-o", "q.exr"],
}


def textured(name):
    return scene(f'Surface "paintedplastic" "string texturename" ["{name}"]\nTranslate 0 0 4 Sphere 1 -1 1 360\n'
                 f'LightSource "shadowspot" 5 "string shadowname" ["{name}"]\n')


def liar(name, content, use):
    ending = name.split("-")[0]

    def make(size, chance):
        if use == "texture":
            made = textured(f"p.{ending}")
        else:
            made = Attempt({}, [word.format(ending) for word in USES[use]])
        made.files[f"p.{ending}"] = content(size)
        return made
    attack(make, name=f"{use}-of-{name}", quick=(use, name) in (("texture", "png-huge"), ("tex", "exr-huge")))


for picture, bytes_of in LIARS.items():
    for purpose in ("texture", "tex"):
        liar(picture, bytes_of, purpose)
for picture in ("png-bomb", "png-huge", "exr-large", "exr-huge", "exr-attributes", "exr-large-square"):
    for purpose in ("diff", "filter", "merge", "shadow-tex"):
        liar(picture, LIARS[picture], purpose)


@attack
def environments_asked_large(size, chance):
    made = textured("p.png")
    made.files["p.png"] = png(1, 1, zlib.compress(bytes(4)))
    made.files["scene.rib"] = 'MakeTexture "p.png" "q.tx" "black" "black" "sinc" 1000000000 1000000000\n' \
                              'MakeLatLongEnvironment "p.png" "r.tx" "gaussian" 1e9 1e9\n' \
        + made.files["scene.rib"]
    return made
