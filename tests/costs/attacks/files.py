# SPDX-License-Identifier: Apache-2.0
"""Files that are no plain files: devices, folders, pipes, loops of links, thousands of names."""
import os

from attacks.attack import RENDER, Attempt, attack, counted, scene, shaded

STRANGE = ("/dev/zero", "/dev/urandom", "/dev/full", "/dev/stdin", "pipe", "folder", "loop", "sparse", "/proc/self/mem",
           "/proc/self/pagemap", "nowhere/", "")
USES = {  # Where a name may stand.
    "archive": 'ReadArchive "{0}"\n',
    "surface": 'Surface "{0}" Translate 0 0 5 Sphere 1 -1 1 360\n',
    "texture": 'Surface "paintedplastic" "string texturename" ["{0}"] Translate 0 0 5 Sphere 1 -1 1 360\n',
    "shadow": 'LightSource "shadowspot" 5 "string shadowname" ["{0}"] Translate 0 0 5 Sphere 1 -1 1 360\n',
    "procedural": 'Procedural "DelayedReadArchive" ["{0}"] [-1 1 -1 1 -1 1]\n',
}


def prepare(folder):
    os.mkfifo(folder / "pipe")
    os.mkfifo(folder / "pipe.sl")
    (folder / "folder").mkdir()
    (folder / "folder.sl").mkdir()
    os.symlink("loop", folder / "loop")
    os.symlink("/dev/zero", folder / "zero.sl")
    for name in "sparse", "sparse.sl":  # A terabyte of nothing, in no blocks.
        with open(folder / name, "wb") as file:
            file.truncate(1 << 40)


def strange(use, text):
    def make(size, chance):
        made = scene("".join(f"AttributeBegin {text.format(name)} AttributeEnd\n" for name in (*STRANGE, "zero")))
        made.prepare = prepare
        return made
    attack(make, quick=use == "surface", name=f"strange-{use}")


for place, requests in USES.items():
    strange(place, requests)


@attack
def strange_scenes(size, chance):
    """A pipe that no one writes, by mistake before the scene."""
    made = scene("Sphere 1 -1 1 360")
    return Attempt(made.files, ["folder", "loop", "scene.rib"], prepare)


@attack
def scene_of_zeros_from_a_device(size, chance):
    return Attempt({}, ["/dev/zero", "--spp", "1"])


@attack
def strange_includes(size, chance):
    text = "".join(f'#include "{name}"\n' for name in (*STRANGE, "zero.sl"))
    made = shaded(f"surface attack() {{\n{text}Ci = 1; Oi = 1; }}\n")
    made.prepare = prepare
    return made


@attack
def strange_displays(size, chance):
    text = "".join(f'Display "+{name}" "openexr" "rgba"\n' for name in STRANGE)
    made = scene("Translate 0 0 5 Sphere 1 -1 1 360", text)
    made.prepare = prepare
    return made


@attack
def shader_folder_of_many_files(size, chance):
    """Names that differ in a letter from the one that is missing."""
    made = scene(counted(size // 2, 'Surface "mosuch{}" Sphere 1 -1 1 9\n'))
    made.files |= {f"nosuch{i}.sl": "" for i in range(size // 100)}
    return made


@attack
def many_scenes_on_the_command_line(size, chance):
    made = scene("Sphere 1 -1 1 360")
    return Attempt(made.files, [*RENDER, *["scene.rib"] * (size // 100)])
