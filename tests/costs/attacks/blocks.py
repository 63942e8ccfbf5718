# SPDX-License-Identifier: Apache-2.0
"""Depth: what can stand within itself, as deep as the size allows."""
from attacks.attack import attack, filled, scene

BLOCKS = {  # What opens and closes one level.
    "attributes": ("AttributeBegin ", "AttributeEnd "),
    "transforms": ("TransformBegin Translate 0 0 .001 ", "TransformEnd "),
    "unions": ('SolidBegin "union" ', "SolidEnd "),
    "differences": ('SolidBegin "difference" SolidBegin "primitive" Sphere 1 -1 1 360 SolidEnd ', "SolidEnd "),
    "conditions": ('IfBegin "1" ', "IfEnd "),
    "else-ifs": ('IfBegin "0" Else ', "IfEnd "),
    "archives": ('ArchiveBegin "a" ', "ArchiveEnd "),
    "objects": ('ObjectBegin "o" ', "ObjectEnd "),
    "motions": ("MotionBegin [0 1] ", "MotionEnd "),
    "resources": ("ResourceBegin ", "ResourceEnd "),
    "frames": ("FrameBegin 1 ", "FrameEnd "),
    "worlds": ("WorldBegin ", "WorldEnd "),
}
INSIDE = "Translate 0 0 5 Sphere 1 -1 1 360 "


def deep(name, opening, closing, quick):
    def closed(size, chance):
        depth = size // len(opening + closing)
        return scene(opening * depth + INSIDE + closing * depth)

    def unclosed(size, chance):
        return scene(filled(size, opening) + INSIDE)

    attack(closed, quick=quick, name=f"deep-{name}")
    attack(unclosed, name=f"unclosed-{name}")


for kind, (begins, ends) in BLOCKS.items():
    deep(kind, begins, ends, quick=kind in ("attributes", "unions", "conditions"))


@attack
def brackets(size, chance):
    return scene('Surface "matte" "Kd" ' + "[" * size)


@attack(quick=True)
def condition_of_parentheses(size, chance):
    return scene('IfBegin "' + "(" * (size // 2) + "1" + ")" * (size // 2) + '" Sphere 1 -1 1 360 IfEnd')


@attack
def condition_of_signs(size, chance):
    return scene('IfBegin "' + filled(size, "!-") + '1" Sphere 1 -1 1 360 IfEnd')


@attack
def condition_of_operators(size, chance):
    return scene('IfBegin "1' + filled(size, "+1") + '" Sphere 1 -1 1 360 IfEnd')


@attack
def condition_of_concats(size, chance):
    depth = size // 12
    return scene('IfBegin "' + "concat('a'," * depth + "'b'" + ")" * depth + " == 'x'\" IfEnd")


@attack
def condition_of_regular_expression(size, chance):
    """A pattern that a backtracking matcher takes exponential time for."""
    text = "a" * (size // 4)
    pattern = "(a|aa)+" * 20 + "(a*)*" * 20 + "b"
    return scene(f"IfBegin \"'{text}' =~ '{pattern}'\" Sphere 1 -1 1 360 IfEnd")


@attack
def condition_of_large_repeats(size, chance):
    """A pattern of repeats in repeats, which an automaton writes out."""
    return scene("IfBegin \"'aaaa' =~ '((((a{1,100}){1,100}){1,100}){1,100}){1,100}'\" IfEnd")
