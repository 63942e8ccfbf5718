# SPDX-License-Identifier: Apache-2.0
"""What a running process has taken until now, as Linux tells it; nothing of one that has ended."""
import os
import re
from pathlib import Path

TICKS = os.sysconf("SC_CLK_TCK")
PEAK = re.compile(r"VmHWM:\s*(\d+) kB")


def peak_memory(process):
    """The most bytes of memory that it has had; what wait4() tells holds its parent's."""
    try:
        return int(PEAK.search(Path(f"/proc/{process}/status").read_text())[1]) * 1024
    except (OSError, TypeError):
        return 0


def fields(folder):
    """Its row of numbers, from the state on."""
    return (folder / "stat").read_text().rsplit(")", 1)[1].split()


def cpu_seconds(process):
    """The time that it has had of the processors."""
    try:
        row = fields(Path(f"/proc/{process}"))
        return (int(row[11]) + int(row[12])) / TICKS
    except (OSError, IndexError):
        return 0


def asleep(process):
    """Whether all of its threads wait for something that is no processor."""
    try:
        return all(fields(thread)[0] == "S" for thread in Path(f"/proc/{process}/task").iterdir())
    except (OSError, IndexError):
        return False
