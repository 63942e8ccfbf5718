#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""An installation that is moved still works: the program, and the libraries under others' programs.

Installs what is built, moves it, and has the example in C (examples/c_interface) built against it by
pkg-config, shared and static, and by CMake. Each renders the picture that the build's own example
renders. The libraries show the calls of ri.h, one for each request, and nothing else.

usage: installation_test.py BUILD_FOLDER SOURCE_FOLDER C_COMPILER
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

CONSUMER = """
cmake_minimum_required(VERSION 3.25)
project(Consumer LANGUAGES C)
find_package(Candela 0.1 REQUIRED)
add_executable(by_cmake {source})
target_link_libraries(by_cmake PRIVATE Candela::candela m)
"""
# A shader of the library, and a texture, which the module of pictures reads.
SCENE = """
Display "scene.exr" "openexr" "rgba"
Format 16 16 1
MakeTexture "balls.exr" "balls.tx" "black" "black" "box" 1 1
WorldBegin
Surface "paintedplastic" "texturename" "balls.tx"
LightSource "ambientlight" 1
Polygon "P" [-1 -1 1  -1 1 1  1 1 1  1 -1 1]
WorldEnd
"""
# A module that tells that it was loaded, for places where none is to be looked for.
PLANTED = """
#include <stdio.h>
__attribute__((constructor)) static void tell(void) { puts("planted"); }
"""
# Of the table: what RIB alone has.
NOT_IN_C = {"version"}


def run(*words, **how):
    done = subprocess.run(words, capture_output=True, text=True, check=False, **how)
    if done.returncode or done.stderr:
        sys.exit(f"{shlex.join(map(str, words))} ended with {done.returncode}\n"
                 f"{done.stdout}{done.stderr}")
    return done.stdout


def names_shown(*nm):
    """Names that others can link to; those of templates ('W', 'V', 'u') yield to anybody's, and 'A'
    are versions."""
    rows = [line.split() for line in run("nm", "--defined-only", *nm).splitlines()]
    return {row[-1].split("@")[0] for row in rows if len(row) == 3 and row[1] not in "AWVu"}


def expected_names(source):
    """From the table of requests: each has a call, and a second one if it has a parameter list."""
    table = (source / "src/interface/ri/requests.def").read_text()
    names = set()
    for name, rest in re.findall(r"^REQUEST\w*\((\w+), (.*)\)$", table, re.MULTILINE):
        if name not in NOT_IN_C:
            names |= {f"Ri{name}", f"Ri{name}V"} if "TokenList" in rest else {f"Ri{name}"}
    return names


def check_names(prefix, source):
    shared = names_shown("-D", prefix / "lib/libcandela.so")
    strangers = sorted(name for name in shared if not re.match("Ri[A-Z]", name))
    assert not strangers, f"libcandela.so shows {strangers[:5]} and {len(strangers)} names in all"
    missing = sorted(expected_names(source) - shared)
    assert len(expected_names(source)) > 150 and not missing, f"without a call in C: {missing}"
    declared = set(re.findall(r"\bRi[A-Z]\w+(?=\(|[,;])", (source / "include/ri.h").read_text()))
    assert declared == shared, f"in one of ri.h and libcandela.so: {sorted(declared ^ shared)}"
    strangers = sorted(names_shown("-g", prefix / "lib/libcandela.a") - shared)
    assert not strangers, f"libcandela.a shows {strangers[:5]} and {len(strangers)} in all"


def check_strangers_are_not_loaded(prefix, environment, compiler):
    """With its own modules gone, the program loads none that lie in folders around the installation,
    the current one or the scene's."""
    around = prefix.parent
    (around / "planted.c").write_text(PLANTED)
    (prefix / "lib/candela").rename(prefix / "lib/away")
    for folder in (around, prefix / "bin", prefix / "lib"):
        (folder / "lib/candela").mkdir(parents=True)
        for module in (prefix / "lib/away").iterdir():
            run(compiler, "-shared", "-fPIC", around / "planted.c", "-o",
                folder / "lib/candela" / module.name)
    for words in (["scene.rib"], ["view", "scene.exr"]):
        done = subprocess.run([prefix / "bin/candela", *words], capture_output=True, text=True,
                              check=False, cwd=around, env=environment)
        assert done.returncode == 1 and "planted" not in done.stdout, done
        assert "there is no lib/candela/" in done.stderr, done


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    build, source = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    compiler = sys.argv[3]
    example = source / "examples/c_interface/balls.c"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run("cmake", "--install", build, "--prefix", folder / "first")
        prefix = (folder / "first").rename(folder / "moved")
        check_names(prefix, source)

        environment = dict(os.environ, PKG_CONFIG_PATH=f"{prefix}/lib/pkgconfig")
        environment.pop("CANDELA_SHADERS", None)
        ask = lambda *words: shlex.split(run("pkg-config", *words, "candela", env=environment))
        run(compiler, example, "-o", folder / "by_pkg_config", *ask("--cflags", "--libs"), "-lm")
        static = ["-l:libcandela.a" if word == "-lcandela" else word
                  for word in ask("--static", "--cflags", "--libs")]
        run(compiler, example, "-o", folder / "by_archive", *static, "-lm")
        (folder / "CMakeLists.txt").write_text(CONSUMER.format(source=example))
        run("cmake", "-S", folder, "-B", folder / "build", f"-DCMAKE_C_COMPILER={compiler}",
            f"-DCMAKE_PREFIX_PATH={prefix}")
        run("cmake", "--build", folder / "build")

        run(build / "bin/balls", cwd=folder)
        (folder / "balls.exr").rename(folder / "expected.exr")
        programs = [[folder / "by_pkg_config"], [folder / "build/by_cmake"]]
        # An archive's code lies in the program: it is where it looks for shaders.
        programs += [[(folder / "by_archive").rename(prefix / "bin/by_archive")]]
        environment["LD_LIBRARY_PATH"] = f"{prefix}/lib"
        for program in programs:
            run(*program, cwd=folder, env=environment)
            run(prefix / "bin/candela", "diff", "balls.exr", "expected.exr", cwd=folder)
            (folder / "balls.exr").unlink()
        (folder / "expected.exr").rename(folder / "balls.exr")
        (folder / "scene.rib").write_text(SCENE)
        run(prefix / "bin/candela", "--quiet", "scene.rib", cwd=folder, env=environment)
        assert (folder / "scene.exr").exists()
        check_strangers_are_not_loaded(prefix, environment, compiler)


if __name__ == "__main__":
    main()
