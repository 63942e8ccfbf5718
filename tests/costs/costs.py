#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What small files cost: inputs of 100 kB, made to be dear, each under 10 s, 2 GB, 1 MB of messages.

An input is made of its generator's name, a size and a seed (attacks/). The program runs on each in
a folder and a shader cache of its own (trial.py), and a line of the table says what it took.
Exit status: 0 all stay within the limits, 1 some do not, 2 there is nothing to try."""
import argparse
import concurrent.futures
import os
import random
import re
import sys
from pathlib import Path

from attacks import ATTACKS
from attacks.known import KNOWN
from trial import Limits, run

SOURCE = Path(__file__).resolve().parent.parent.parent
HEADING = f"{'input':44}{'s':>7}{'cpu s':>8}{'MB':>7}{'messages':>10}  verdict"


def chosen(options):
    """The generators that the command line asks for, by name."""
    pattern = re.compile(options.only)
    return {name: attack for name, attack in ATTACKS.items()
            if pattern.search(name) and (attack.quick or not options.quick) and
            (name in KNOWN) == options.known}


def measure(name, options):
    """The outcome of one generator's input, which is kept where it fails."""
    chance = random.Random(f"{name} {options.seed}")
    attempt = ATTACKS[name].make(options.size, chance)
    kept = Path(options.keep, name) if options.keep else None
    return run(attempt, Path(options.program).resolve(), Limits(), kept)


def line(name, outcome):
    verdict = "; ".join(outcome.problems) or "ok"
    return f"{name:44}{outcome.seconds:7.2f}{outcome.cpu:8.2f}{outcome.memory / 1e6:7.0f}" \
           f"{outcome.message_bytes:10}  {verdict}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=str(SOURCE / "build/bin/candela"))
    parser.add_argument("--size", type=int, default=100_000, help="bytes of an input")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", metavar="PATTERN", help="generators whose names hold this")
    parser.add_argument("--quick", action="store_true", help="those of the everyday tests")
    parser.add_argument("--known", action="store_true", help="those that are known to fail, alone")
    parser.add_argument("--jobs", type=int, default=1, help="inputs tried at a time")
    parser.add_argument("--keep", help="folder for the inputs that fail")
    parser.add_argument("--list", action="store_true", help="names the generators")
    options = parser.parse_args()
    names = chosen(options)
    if options.list:
        print("\n".join(names))
        return 0
    if not names or not os.access(options.program, os.X_OK):
        print(f"nothing to try: {len(names)} generators, {options.program}", file=sys.stderr)
        return 2
    print(HEADING)
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for name, outcome in zip(names, pool.map(lambda name: measure(name, options), names)):
            failed += bool(outcome.problems)
            print(line(name, outcome), flush=True)
    print(f"{len(names)} inputs of {options.size} bytes from seed {options.seed}, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
