# SPDX-License-Identifier: Apache-2.0
"""One run of the program on one input, watched: what it took, and which limits it broke."""
import os
import resource
import shutil
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

from watch import asleep, cpu_seconds, peak_memory

SOURCE = Path(__file__).resolve().parent.parent.parent
WATCHED_EVERY = .02  # Seconds.
MILLION = 1_000_000
LARGEST_FILE = 1_000 * MILLION  # That the program may write.


@dataclass
class Limits:
    """What an input may cost."""
    seconds: float = 10 * max(1.0, float(os.environ.get("CANDELA_TIME_SCALE", "1")))
    memory: int = 2_000 * MILLION
    messages: int = MILLION


@dataclass
class Outcome:
    """What a run took. Its seconds are those that pass, without those in which it had to wait for a
    processor that others had: it worked or slept in them."""
    seconds: float
    cpu: float
    memory: int
    message_bytes: int
    status: int
    problems: list = field(default_factory=list)


class Watched:
    """A process whose output goes to a file."""

    def __init__(self, process, said):
        self.process, self.said = process, said
        self.start, self.slept, self.peak = time.monotonic(), 0, 0

    def outcome(self, cpu, status=0):
        seconds = min(time.monotonic() - self.start, cpu + self.slept)
        return Outcome(seconds, cpu, self.peak, os.fstat(self.said.fileno()).st_size, status)

    def wait(self, limits):
        """Waits for it, or ends it and all that it has started where it takes far more than it may."""
        while True:
            ended, status, usage = os.wait4(self.process, os.WNOHANG)
            if ended:
                return self.outcome(usage.ru_utime + usage.ru_stime, status)
            self.peak = max(self.peak, peak_memory(self.process))
            if exceeds(self.outcome(cpu_seconds(self.process)), limits, 1.5):
                os.killpg(self.process, signal.SIGKILL)
                _, status, usage = os.wait4(self.process, 0)
                return self.outcome(usage.ru_utime + usage.ru_stime, status)
            self.slept += WATCHED_EVERY * asleep(self.process)
            time.sleep(WATCHED_EVERY)


def exceeds(outcome, limits, times):
    return list(words for words, much in (
        ("TIME", outcome.seconds > limits.seconds * times),
        ("MEMORY", outcome.memory > limits.memory * times),
        ("MESSAGES", outcome.message_bytes > limits.messages * times)) if much)


def bad_ends(status):
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) != signal.SIGKILL:
        yield signal.Signals(os.WTERMSIG(status)).name
    if os.WIFEXITED(status) and os.WEXITSTATUS(status) not in (0, 1, 2):
        yield f"EXIT STATUS {os.WEXITSTATUS(status)}"


def run(attempt, program, limits, kept):
    """Tries an Attempt (attacks/attack.py); it is written to the folder `kept` if it breaks a limit."""
    launcher = os.environ.get("CANDELA_LAUNCHER", "").split()
    with tempfile.TemporaryDirectory(prefix="candela-costs-") as folder, \
            tempfile.TemporaryDirectory(prefix="candela-costs-") as cache, \
            tempfile.TemporaryFile() as said:
        attempt.write(Path(folder))
        environment = dict(os.environ, CANDELA_CACHE=cache, CANDELA_SHADERS=str(SOURCE / "shaders"))
        process = subprocess.Popen([*launcher, str(program), *attempt.words], cwd=folder,
                                   stdin=subprocess.DEVNULL, stdout=said, stderr=said,
                                   env=environment, start_new_session=True)
        resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (LARGEST_FILE, LARGEST_FILE))
        outcome = Watched(process.pid, said).wait(limits)
        process.returncode = outcome.status  # It has been waited for.
        outcome.problems = [*exceeds(outcome, limits, 1), *bad_ends(outcome.status)]
        if kept and outcome.problems:
            keep(attempt, said, kept)
    return outcome


def keep(attempt, said, kept):
    """Writes the plain files of an input, the command and the first of what was said."""
    shutil.rmtree(kept, ignore_errors=True)
    kept.mkdir(parents=True)
    attempt.write_files(kept)
    (kept / "COMMAND").write_text(" ".join(attempt.words) + "\n")
    said.seek(0)
    (kept / "SAID").write_bytes(said.read(MILLION))
