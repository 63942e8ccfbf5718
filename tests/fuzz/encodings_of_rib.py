# SPDX-License-Identifier: Apache-2.0
"""The other forms of RIB for fuzz.py: tokens in binary (RI 3.2, appendix C.2), whole files packed by
gzip, and bytes that are then changed."""
import gzip
import re
import struct

WHOLE = re.compile(r"[-+]?\d{1,9}$")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$")


def binary_number(text):
    if WHOLE.match(text):
        value = int(text)
        size = next(n for n in (1, 2, 4) if -(1 << (8 * n - 1)) <= value < 1 << (8 * n - 1))
        return bytes([0o200 + size - 1]) + value.to_bytes(size, "big", signed=True)
    value = float(text)
    return b"\244" + struct.pack(">f", value) if abs(value) < 3e38 else b"\245" + struct.pack(">d", value)


def binary_string(text):
    content = text.encode("latin-1", "replace")
    if len(content) < 16:
        return bytes([0o220 + len(content)]) + content
    return b"\241" + len(content).to_bytes(2, "big") + content[:65535]


def binary(tokens, chance):
    """The tokens, most of them in binary; the others stay as they are."""
    codes, result, i = {}, b"", 0
    while i < len(tokens):
        token = tokens[i]
        i += 1
        if chance.random() < .1:
            result += b" " + token.encode("latin-1", "replace") + b" "
        elif token == "#":
            while i < len(tokens) and "\n" not in tokens[i]:
                i += 1
        elif NUMBER.match(token):
            result += binary_number(token)
        elif token.startswith('"') and len(token) > 1:
            if token in codes and codes[token] < 256:
                result += bytes([0o317, codes[token]])
            elif chance.random() < .3 and len(codes) < 256:
                codes[token] = len(codes)
                result += bytes([0o315, codes[token]]) + binary_string(token[1:-1])
                result += bytes([0o317, codes[token]])
            else:
                result += binary_string(token[1:-1])
        elif token.isalpha():
            if token not in codes and len(codes) < 256:
                codes[token] = len(codes)
                result += bytes([0o314, codes[token]]) + binary_string(token)
            result += bytes([0o246, codes[token]]) if token in codes else token.encode("latin-1", "replace")
        else:
            result += token.encode("latin-1", "replace")
    return result


def mutate_bytes(content, chance):
    """Changes some bytes, drops, doubles and inserts some, or ends early."""
    content = bytearray(content)
    for _ in range(chance.choice([0, 1, 1, 2, 5, 20])):
        if not content:
            break
        at = chance.randrange(len(content))
        kind = chance.randrange(6)
        if kind < 2:
            content[at] = chance.randrange(256)
        elif kind == 2:
            del content[at:at + chance.choice([1, 1, 4, 50])]
        elif kind == 3:
            content[at:at] = bytes([chance.randrange(0o200, 0o400)])
        elif kind == 4:
            content[at:at] = content[at:at + 30] * chance.choice([1, 2, 50])
        elif chance.random() < .3:
            del content[at:]
    return bytes(content)


def encode(tokens, chance):
    """The tokens as a file: mostly text, else binary, packed, or both; maybe damaged."""
    kind = chance.choices(["text", "binary", "gzip", "both"], [5, 3, 1, 1])[0]
    text = "".join(tokens).encode("utf-8", "replace")
    if kind == "text":
        return text
    content = mutate_bytes(binary(tokens, chance), chance) if kind != "gzip" else text
    return content if kind == "binary" else mutate_bytes(gzip.compress(content, mtime=0), chance)
