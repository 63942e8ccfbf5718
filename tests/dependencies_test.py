#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Keeps the house in order: who may include and link whom (docs: the design's section on wings).

Reads every #include line and every ROOMS and DOOR word of the CMake files. Before it judges the
real tree it breaks small trees on purpose, one rule each, and demands to be told of it.

usage: dependencies_test.py SOURCE_FOLDER
"""
import pathlib
import re
import sys
import tempfile

# The wings from the top down: a wing may use those that stand below it in this table.
BELOW = {
    "foundation": [],
    "interface": ["foundation"],
    "language": ["foundation"],
    "world": ["language", "interface", "foundation"],
    "light": ["world", "language", "interface", "foundation"],
    "image": ["world", "language", "interface", "foundation"],
    "render": ["light", "image", "world", "language", "interface", "foundation"],
    "binding": ["render", "light", "image", "world", "language", "interface", "foundation"],
    "apps": ["render", "light", "image", "world", "language", "interface", "foundation"],
}

# Each third-party library has one door: how its headers begin, its CMake targets, its room.
DOORS = [
    ("LLVM", r"llvm(-c)?/", r"LLVM\w*", "src/language/jit"),
    ("Embree", r"embree\d*/", r"embree", "src/world/rays"),
    ("OpenEXR", r"(OpenEXR/|Imath/|Imf|Imath|half\.h)", r"(OpenEXR|Imath)::\w+", "src/image"),
    ("libpng", r"(libpng\w*/)?png\w*\.h", r"PNG::\w+", "src/image"),
    ("SLEEF", r"sleef", r"(PkgConfig::)?SLEEF", "src/language/runtime"),
    ("TBB", r"(oneapi/)?tbb/", r"TBB::\w+", "src/foundation/base"),
    ("zlib", r"zlib\.h|zconf\.h", r"ZLIB::\w+", "src/interface/rib"),
    ("CLI11", r"CLI/", r"CLI11::\w+", "apps"),
    ("OpenSubdiv", r"opensubdiv/", r"OpenSubdiv::\w+", "src/world/geometry"),
    ("Python", r"(pybind11/|Python\.h|numpy/)", r"(pybind11|Python3)::\w+", "src/binding/python"),
    ("SDL", r"SDL", r"(PkgConfig::)?SDL2(::\w+)?", "src/image/view"),
    ("OpenImageIO", r"OpenImageIO/", r"OpenImageIO::\w+", "src/world/texture"),
]
# Besides its room, who may open a door: the yardsticks of the benchmarks stand on the bare library.
ALSO_OPENS = {"Embree": ("bench",), "SLEEF": ("bench",), "OpenImageIO": ("bench",)}
# How the build refers to libraries that every room and test may use.
FREE_TARGETS = {"fmt::fmt", "GTest::gtest", "GTest::gtest_main"}

KEYWORDS = ("ROOMS", "TEST_ROOMS", "DOOR", "SOURCES")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
ROOM = re.compile(r"candela_room\s*\(([^)]*)\)")
LINK = re.compile(r"target_link_libraries\s*\(([^)]*)\)")


def wing_of(path):
    """"src/world/scene/a.h" -> "world"; "apps/a.cpp" -> "apps"; others -> None."""
    parts = pathlib.PurePosixPath(path).parts
    if parts[0] == "apps":
        return "apps"
    return parts[1] if parts[0] == "src" and len(parts) > 2 else None


def inside(folder, path):
    return path.startswith(folder + "/")


def may_open(library, door, path):
    return any(inside(folder, path) for folder in (door, *ALSO_OPENS.get(library, ())))


class House:
    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.problems = []
        self.includes = self.links = 0
        self.cmake = self.files("CMakeLists.txt")
        self.rooms = self.find_rooms()
        self.folders = {folder: name for name, folder in self.rooms.items()}
        self.builds_upon = self.find_steps()

    def files(self, *patterns):
        found = []
        for top in ("src", "apps", "tests", "bench"):
            for pattern in patterns:
                found += (self.root / top).rglob(pattern)
        return {p.relative_to(self.root).as_posix(): p.read_text(errors="replace")
                for p in sorted(found)}

    def find_rooms(self):
        """The folder of each room, by its name."""
        rooms = {}
        for path, text in self.cmake.items():
            for arguments in ROOM.findall(without_comments(text)):
                rooms[arguments.split()[0]] = path.rsplit("/", 1)[0]
        return rooms

    def find_steps(self):
        """For each room the rooms that it builds upon, and for its tests those that they use."""
        direct, for_tests = {}, {}
        for text in self.cmake.values():
            for arguments in ROOM.findall(without_comments(text)):
                keyword, name = None, arguments.split()[0]
                direct[name], for_tests[name] = [], []
                for word in arguments.split()[1:]:
                    if word in KEYWORDS:
                        keyword = word
                    elif keyword == "ROOMS":
                        direct[name].append(word)
                    elif keyword == "TEST_ROOMS":
                        for_tests[name].append(word)
        return {name: (closure(direct, [name]), closure(direct, [name, *for_tests[name]]))
                for name in direct}

    def room_of(self, path):
        return self.folders.get(path.rsplit("/", 1)[0])

    def problem(self, path, text):
        self.problems.append(f"{path}: {text}")

    def check(self):
        for path, text in self.files("*.h", "*.cpp").items():
            for bracket, header in INCLUDE.findall(text):
                self.includes += 1
                self.check_include(path, bracket, header)
        for path, text in self.cmake.items():
            self.check_links(path, without_comments(text))
        return self.problems

    def check_include(self, path, bracket, header):
        for library, headers, _, door in DOORS:
            if re.match(headers, header) and not may_open(library, door, path):
                if bracket == "<" or not (self.root / "src" / header).exists():
                    self.problem(path, f"includes <{header}>, but {library} is opened in {door} alone")
        if bracket == '"':
            target = f"src/{header}" if (self.root / "src" / header).exists() else header
            if target.startswith(("src/", "apps/")):
                self.check_step(path, target, f'includes "{header}"')

    def check_step(self, path, target, what):
        """From one file's wing to another's."""
        here, there = wing_of(path), wing_of(target)
        if here is None or there is None:
            return
        if here == there:
            self.check_room_step(path, target, what)
            return
        if here not in BELOW or there not in BELOW:
            self.problem(path, f"{what}: the design knows no wing {here if here not in BELOW else there}")
        elif there not in BELOW[here]:
            self.problem(path, f"{what}: {here} may not depend on {there}")

    def check_room_step(self, path, target, what):
        """From one file's room to another's in the same wing."""
        here, there = self.room_of(path), self.room_of(target)
        if here is None or there is None or path.endswith("CMakeLists.txt"):
            return
        is_test = "_test" in path or path.endswith("test_support.h")
        if there not in self.builds_upon[here][is_test]:
            self.problem(path, f"{what}: {here} does not build upon {there}")

    def check_links(self, path, text):
        for arguments in ROOM.findall(text):
            self.check_room(path, arguments.split())
        for arguments in LINK.findall(text):
            for word in arguments.split()[1:]:
                self.check_target(path, word)

    def check_room(self, path, words):
        keyword = None
        for word in words[1:]:
            if word in KEYWORDS:
                keyword = word
            elif keyword in ("ROOMS", "TEST_ROOMS") and word not in self.rooms:
                self.problem(path, f"builds upon {word}, which is no room")
            elif keyword in ("ROOMS", "TEST_ROOMS", "DOOR"):
                self.check_target(path, word)
                if keyword == "DOOR" and word in self.rooms:
                    self.problem(path, f"{word} is a room, not a library")

    def check_target(self, path, word):
        self.links += 1
        if word in self.rooms:
            self.check_step(path, self.rooms[word] + "/CMakeLists.txt", f"links {word}")
            return
        for library, _, targets, door in DOORS:
            if re.fullmatch(targets, word) and not may_open(library, door, path):
                self.problem(path, f"links {word}, but {library} is opened in {door} alone")
        known = any(re.fullmatch(targets, word) for _, _, targets, _ in DOORS)
        if "::" in word and not known and word not in FREE_TARGETS and path.startswith("src/"):
            self.problem(path, f"links {word}, a library without a door")


def closure(steps, names):
    """The names and all that can be reached from them."""
    reached, open_names = set(), list(names)
    while open_names:
        name = open_names.pop()
        if name not in reached:
            reached.add(name)
            open_names += steps.get(name, [])
    return reached


def without_comments(text):
    return re.sub(r"#.*", "", text)


# A tree in order, and changes that each break one rule: the file and what it gets.
SOUND_TREE = {
    "src/foundation/base/CMakeLists.txt": "candela_room(base DOOR TBB::tbb)",
    "src/foundation/base/parallel.cpp": "#include <tbb/parallel_for.h>",
    "src/foundation/base/vec3.h": "#include <cmath>",
    "src/interface/ri/CMakeLists.txt": "candela_room(ri ROOMS base)",
    "src/interface/ri/options.h": '#include "foundation/base/vec3.h"',
    "src/interface/rib/CMakeLists.txt": "candela_room(rib ROOMS ri DOOR ZLIB::ZLIB)",
    "src/language/jit/CMakeLists.txt": "candela_room(jit ROOMS base DOOR LLVM)",
    "src/language/jit/jit.h": '#include "foundation/base/vec3.h"',
    "src/world/scene/CMakeLists.txt": "candela_room(scene ROOMS ri jit)",
    "src/world/scene/scene.h": '#include "interface/ri/options.h"',
    "src/light/path/CMakeLists.txt": "candela_room(path ROOMS scene)",
    "src/light/path/path.h": '#include "world/scene/scene.h"',
    "src/light/frame/CMakeLists.txt": "candela_room(frame ROOMS path TEST_ROOMS ri)",
    "src/light/frame/frame.h": '#include "light/path/path.h"',
    "src/light/frame/frame_test.cpp": '#include "interface/ri/options.h"',
    "src/image/CMakeLists.txt": "candela_room(image ROOMS scene DOOR PNG::PNG)",
    "src/image/film.h": '#include "world/scene/scene.h"',
    "src/render/CMakeLists.txt": "candela_room(render ROOMS rib path image)",
    "src/render/render.h": '#include "image/film.h"',
    "apps/CMakeLists.txt": "target_link_libraries(candela PRIVATE render CLI11::CLI11)",
    "apps/candela.cpp": '#include <CLI/CLI.hpp>\n#include "render/render.h"',
    "tests/a_test.cpp": '#include "image/film.h"',
}
BREAKS = [
    ("src/foundation/base/vec3.h", '#include "interface/ri/options.h"'),
    ("src/light/path/path.h", '#include "image/film.h"'),
    ("src/image/film.h", '#  include "light/path/path.h"'),
    ("src/light/path/path.h", '#include "light/frame/frame.h"'),
    ("src/light/path/path_test.cpp", '#include "light/frame/frame.h"'),
    ("src/language/jit/jit.h", '#include "interface/ri/options.h"'),
    ("src/interface/ri/options.h", '#include "language/jit/jit.h"'),
    ("src/world/scene/scene.h", '#include "render/render.h"'),
    ("src/render/render.h", '#include "apps/candela.cpp"'),
    ("src/interface/ri/CMakeLists.txt", "candela_room(ri ROOMS base scene)"),
    ("src/light/path/CMakeLists.txt", "candela_room(path ROOMS scene image)"),
    ("src/language/jit/CMakeLists.txt", "candela_room(jit ROOMS ri DOOR LLVM)"),
    ("src/world/scene/CMakeLists.txt", "candela_room(scene ROOMS ri jit attic)"),
    ("src/world/scene/CMakeLists.txt", "candela_room(scene ROOMS ri jit TBB::tbb)"),
    ("src/image/CMakeLists.txt", "candela_room(image ROOMS scene DOOR Boost::regex)"),
    ("src/image/CMakeLists.txt",
     "candela_room(image ROOMS scene)\ntarget_link_libraries(image PRIVATE path)"),
    ("src/world/scene/scene.h", "#include <llvm/IR/Module.h>"),
    ("src/light/path/path.h", "#include <embree3/rtcore.h>"),
    ("src/render/render.h", "#include <ImfRgbaFile.h>"),
    ("src/render/render.h", "#include <png.h>"),
    ("src/language/jit/jit.h", "#include <sleef.h>"),
    ("src/world/scene/scene.h", "#include <tbb/parallel_for.h>"),
    ("src/interface/ri/options.h", "#include <zlib.h>"),
    ("src/render/render.h", "#include <CLI/CLI.hpp>"),
    ("tests/a_test.cpp", "#include <OpenEXR/ImfInputFile.h>"),
]


def problems_of_tree(tree):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in tree.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text + "\n")
        return House(folder).check()


def test_the_test():
    """Complaints about the checker itself."""
    complaints = [f"the sound tree is said to be broken: {p}" for p in problems_of_tree(SOUND_TREE)]
    for name, text in BREAKS:
        if len(problems_of_tree({**SOUND_TREE, name: text})) != 1:
            complaints.append(f"not noticed, or noticed twice: {name} with {text!r}")
    return complaints


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    complaints = test_the_test()
    house = House(sys.argv[1])
    complaints += house.check()
    if len(house.rooms) < 10 or house.includes < 100 or house.links < 10:
        complaints.append(f"{sys.argv[1]} does not look like the source folder")
    for complaint in complaints:
        print(complaint)
    print(f"{len(house.rooms)} rooms, {house.includes} includes, {house.links} links, "
          f"{len(BREAKS)} broken trees: {len(complaints)} complaints")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
