#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Renders mutated scenes and shaders: none may crash candela, hang it or flood the terminal.

An input is made of its seed alone: a file of corpus/ whose tokens are changed, dropped, doubled and
swapped; RIB is then put into its other forms, too, and their bytes changed (encodings_of_rib.py). What fails is kept with the command that repeats it. Exit status: 0 none failed, 1 some
did, 2 there is no program to try."""
import argparse
import concurrent.futures
import math
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

from encodings_of_rib import encode

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|\w+|\s+|.', re.S)
NUMBER = re.compile(r"[-+]?(?:\d|\.\d)")
NUMBERS = ["0", "-0", "1", "-1", "0.5", "2", "3", "7", "255", "1e38", "-1e38", "3.4e38", "1e39", "-1e39",
           "1e-38", "1e-44", "-1e-45", "1e400", "inf", "-inf", "nan", "1e9", "-1e9", "2147483647",
           "-2147483648", "4294967296", "1e18", "1e20", "16777217", "1e-7", "-1e-20", "180", "359.999"]
STRINGS = ['""', '"P"', '"nosuch"', '"uniform float x"', '"varying color Cs"', '"vertex point P"',
           '"constant string[3] s"', '"uniform float[0] x"', '"uniform float[-1] x"', '"matte"', '"../x"',
           '"%s%n"', '"' + "x" * 3000 + '"', '"\\377\\000"', '"bicubic"', '"periodic"', '"inside"']
LOOP = re.compile(r"\b(?:for|while)\b")
SANITIZER = re.compile(r"==\d+==ERROR|.*runtime error:")
TOO_LONG = "took too long"
INPUTS_A_PROCESS = 200
LOOP_ENDED = b"the loop here does not end"  # It has been compiled, and takes what turns it may.
LOOP_SECONDS = 2  # Many more than a shader without an endless loop needs.
FLOOD = 100_000  # Bytes of messages: an ordinary scene's few, said once each.
SHADER_KIND = re.compile(r"^(surface|displacement|transformation|volume|light|filter|imager)\b", re.M)
# A shader that is mutated, in the place of a request; (options, attributes).
SHADER_REQUESTS = {
    "surface": ("", 'Surface "{0}"'),
    "displacement": ("", 'Displacement "{0}"'),
    "transformation": ("", 'Deformation "{0}"'),
    "volume": ("", 'Atmosphere "{0}"\nInterior "{0}"'),
    "light": ("", 'LightSource "{0}" 3'),
    "filter": ('PushFilter "{0}"', ""),
    "imager": ('Imager "{0}"', ""),
}
SHADER_SCENE = """Format 8 8 1
Display "out.exr" "openexr" "rgba"
Projection "perspective" "fov" [50]
{options}
WorldBegin
LightSource "pointlight" 1 "point from" [2 3 -1]
LightSource "ambientlight" 2
AttributeBegin
{attributes}
Translate 0 0 4
Sphere 1.4 -1.4 1.4 360
AttributeEnd
WorldEnd
"""


def places(tokens, chosen):
    return [i for i, token in enumerate(tokens) if chosen(token)]


def is_number(token):
    return NUMBER.match(token) is not None


def is_word(token):
    return not token.isspace()


def mutate(tokens, chance):
    """Changes the list of tokens in one way."""
    kind = chance.choices(["number", "string", "drop", "double", "swap", "cut", "copy", "end"],
                          [8, 2, 2, 2, 2, 1, 1, 1])[0]
    if kind == "number" and (where := places(tokens, is_number)):
        first = chance.randrange(len(where))
        for i in where[first:first + chance.choice([1, 1, 1, 2, 3, 9])]:
            tokens[i] = chance.choice(NUMBERS)
    elif kind == "string" and (where := places(tokens, lambda token: token.startswith('"'))):
        tokens[chance.choice(where)] = chance.choice(STRINGS + [tokens[chance.choice(where)]])
    elif kind == "cut" and (where := places(tokens, lambda token: token == "[")):
        first = chance.choice(where)
        last = next((i for i in range(first, len(tokens)) if tokens[i] == "]"), len(tokens))
        del tokens[chance.randint(first + 1, max(first + 1, last)):last]
    elif kind == "copy":
        first = chance.randrange(len(tokens))
        piece = tokens[first:first + chance.randint(1, 40)]
        at = chance.randrange(len(tokens))
        tokens[at:at] = piece * chance.choice([1, 1, 2, 50])
    elif kind == "end":
        del tokens[chance.randrange(len(tokens)):]
    elif where := places(tokens, is_word):
        i, j = chance.choice(where), chance.choice(where)
        if kind == "drop":
            del tokens[i]
        elif kind == "double":
            tokens.insert(i, tokens[i] + " ")
        else:
            tokens[i], tokens[j] = tokens[j], tokens[i]


def scene_of(path):
    """A scene that uses a shader of the corpus."""
    options, attributes = SHADER_REQUESTS[SHADER_KIND.search(path.read_text())[1]]
    return SHADER_SCENE.format(options=options.format(path.stem),
                               attributes=attributes.format(path.stem))


def make_input(seed, corpus):
    """The file of the corpus that a seed changes, and its bytes then."""
    chance = random.Random(seed)
    origin = chance.choice(corpus)
    tokens = TOKEN.findall(origin.read_text())
    for _ in range(chance.choice([1, 1, 2, 3, 5])):
        if tokens:
            mutate(tokens, chance)
    if origin.suffix == ".sl":
        return origin, "".join(tokens).encode("utf-8", "replace")
    return origin, encode(tokens, chance)


class Renderer:
    """A process (render_each.cpp) that renders one scene after the other, until one ends it."""

    def __init__(self, options):
        launcher = os.environ.get("CANDELA_LAUNCHER", "").split()
        environment = dict(os.environ, CANDELA_SHADERS=str(SOURCE / "shaders"))
        environment["ASAN_OPTIONS"] = "detect_leaks=0:abort_on_error=1"
        environment["UBSAN_OPTIONS"] = "halt_on_error=1:print_stacktrace=1:abort_on_error=1"
        self.inputs = 0
        self.process = subprocess.Popen([*launcher, options.program, str(options.memory)], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        env=environment)

    def render(self, folder, seconds, cache):
        """The exit status for the scene.rib in a folder; below 0 the signal that ended it."""
        self.inputs += 1
        print(folder, math.ceil(seconds), cache, sep="\t", file=self.process.stdin, flush=True)
        answer = self.process.stdout.readline()
        return int(answer) if answer else self.end()

    def end(self):
        self.process.stdin.close()
        self.process.stdout.close()
        return self.process.wait()


class Trial:
    """How inputs are rendered, and what counts as a failure."""

    def __init__(self, options):
        self.options = options
        self.scale = max(1.0, float(os.environ.get("CANDELA_TIME_SCALE", "1")))
        self.corpus = sorted((HERE / "corpus").iterdir())
        self.renderers = threading.local()

    def run(self, seed):
        """What is wrong with a seed, or none. It is tried again in a new process, to tell whether
        it is wrong by itself."""
        problem = self.attempt(seed)
        if not problem:
            return None
        before = self.renderers.latest.inputs
        self.renew()
        again = self.attempt(seed)
        self.renew()
        return again or f"{problem}\n    but only after the {before - 1} before it"

    def renew(self):
        if latest := getattr(self.renderers, "latest", None):
            latest.end()
        self.renderers.latest = Renderer(self.options)

    def attempt(self, seed):
        """What is wrong with a seed in the latest process, or none."""
        origin, content = make_input(seed, self.corpus)
        of_shader = origin.suffix == ".sl"  # Found by its name, however it is changed.
        name = origin.name if of_shader else "scene.rib"
        with tempfile.TemporaryDirectory(prefix="candela-fuzz-") as folder:
            for shader in (HERE / "corpus").glob("*.sl"):
                shutil.copy(shader, folder)
            if of_shader:
                Path(folder, "scene.rib").write_text(scene_of(origin))
            Path(folder, name).write_bytes(content)
            if of_shader and LOOP.search(content.decode("utf-8", "replace")):
                problem = self.render_loop(folder, origin.stem)
            else:
                problem = self.render(folder)
        if problem:
            kept = Path(self.options.keep, f"{seed}-{name}")
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_bytes(content)
            return f"seed {seed} ({kept}): {problem}\n    again: {sys.argv[0]} --program " \
                   f"{self.options.program} --memory {self.options.memory} --first {seed} --count 1"
        return None

    def render_loop(self, folder, shader):
        """A loop may have no end, and runs as it says. Its compilation has to end all the same: what
        the scene compiles besides is in the cache before the second try, so one object more is its."""
        problem = self.render(folder, LOOP_SECONDS)
        if problem != TOO_LONG:
            return problem
        scene, cache = Path(folder, "scene.rib"), Path(folder, "cache")

        def objects():
            return sum(path.is_file() for path in cache.rglob("*"))

        dark = re.sub(r'LightSource ".*light".*\n', "", scene.read_text())
        scene.write_text(re.sub(rf'.*"{shader}".*\n', "", dark))
        self.render(folder, cache=str(cache))
        before = objects()
        scene.write_text(dark)
        for seconds in LOOP_SECONDS, self.options.seconds:
            problem = self.render(folder, seconds, str(cache))
            if problem != TOO_LONG:
                return problem
            if objects() > before:
                return None
        return problem

    def render(self, folder, seconds=None, cache=""):
        seconds = (seconds or self.options.seconds) * self.scale
        latest = getattr(self.renderers, "latest", None)
        if not latest or latest.process.stdin.closed or latest.inputs >= INPUTS_A_PROCESS:
            self.renew()
        status = self.renderers.latest.render(folder, seconds, cache)
        said = Path(folder, "said")
        messages = said.read_bytes() if said.is_file() else b""
        if status in (-signal.SIGPROF, -signal.SIGALRM):
            return None if LOOP_ENDED in messages else TOO_LONG
        if status not in (0, 1):
            how = f"signal {-status}" if status < 0 else f"exit status {status}"
            text = messages.decode(errors="replace")
            report = SANITIZER.search(text)
            return f"{how}: " + (text[report.start():][:3000] if report else text[-1500:])
        if len(messages) > FLOOD:
            return f"{len(messages)} bytes of messages"
        return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=str(SOURCE / "build/bin/render_each"))
    parser.add_argument("--first", type=int, default=1, help="the first seed")
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seconds", type=float, default=20, help="of the processor, for one input")
    parser.add_argument("--memory", type=int, default=4096, help="MiB for a process")
    parser.add_argument("--keep", default="fuzz-failures", help="folder for what fails")
    options = parser.parse_args()
    options.program = os.path.abspath(options.program)
    if not os.access(options.program, os.X_OK):
        print(f"{options.program} cannot be executed", file=sys.stderr)
        return 2
    trial = Trial(options)
    failures = 0
    seeds = range(options.first, options.first + options.count)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for problem in pool.map(trial.run, seeds):
            if problem:
                failures += 1
                print(problem, flush=True)
    print(f"{options.count} inputs from seed {options.first}, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
