#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What pages show of the program's output is what it prints today; their listings render.

A fenced block that begins with "$ candela ..." shows a run from the source folder: its lines stand
in what is printed, in this order; "..." stands for any lines, all others follow one another.

usage: docs_test.py CANDELA SOURCE_FOLDER
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

LISTING = re.compile(r"^```(?:rib|sl)\n(?:#|//) (\S+\.(?:rib|sl))\n(.*?)^```",
                     re.MULTILINE | re.DOTALL)
BLOCK = re.compile(r"^```\w*\n(\$ candela .*?)^```", re.MULTILINE | re.DOTALL)


def pieces_of(lines):
    """The runs of lines between the lines "..."."""
    pieces = [[]]
    for line in lines:
        if line.strip() == "...":
            pieces.append([])
        else:
            pieces[-1].append(line)
    return [piece for piece in pieces if piece]


def missing_piece(shown, printed):
    """The first piece that does not follow those before it; None if all do."""
    start = 0
    for piece in pieces_of(shown):
        for at in range(start, len(printed) - len(piece) + 1):
            if printed[at:at + len(piece)] == piece:
                start = at + len(piece)
                break
        else:
            return piece
    return None


def test_the_test():
    printed = ["a", "b", "c", "d"]
    assert missing_piece(["a", "b"], printed) is None
    assert missing_piece(["...", "b", "...", "d"], printed) is None
    assert missing_piece(["a", "c"], printed) == ["a", "c"]
    assert missing_piece(["b", "...", "a"], printed) == ["a"]


def complaints_of_listings(page, program):
    """The files of a page, rendered as they stand: in silence, unless the page says "black"."""
    listings = LISTING.findall(page.read_text())
    with tempfile.TemporaryDirectory() as folder:
        for name, text in listings:
            pathlib.Path(folder, name).write_text(text)
        for name, text in listings:
            if "WorldBegin" not in text:
                continue # An archive or a shader.
            run = subprocess.run([program, name, "--spp", "1", "--format", "32x24", "--quiet"],
                                 cwd=folder, capture_output=True, text=True)
            silent = not run.stderr or run.stderr.startswith("warning: the picture is black")
            if run.returncode != 0 or not silent:
                yield f"{page}: {name}\n  exit status {run.returncode} {run.stderr}"
            for picture in re.findall(r'Display "\+?(\S+)"', text):
                if not pathlib.Path(folder, picture).is_file():
                    yield f"{page}: {name} makes no {picture}"


def complaints_of_links(page):
    """Links to files that are not there."""
    for link in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text()):
        if not (page.parent / link).exists():
            yield f"{page}: there is no {link}"


LIMIT = re.compile(r"^\|[^|]*\| ([0-9,.]+) \|.*\| `(\S+): (\w+)` \|$", re.MULTILINE)
NUMBER = re.compile(r"[0-9.e']+u?( *(<<|\*) *[0-9]+)?")


def complaints_of_limits(page, root):
    """Numbers of limits that are not those of the source."""
    limits = LIMIT.findall(page.read_text())
    assert limits, page
    for number, path, name in limits:
        found = re.search(rf"\b{name} *= *(0x[0-9a-f]+|{NUMBER.pattern})", (root / path).read_text())
        value = found and eval(re.sub(r"['u]", "", found[1]))
        if value != float(number.replace(",", "")):
            yield f"{page}: {path} has {name} = {value}, not {number}"


def complaints_of_shaders(page, program):
    """The page of the library shows every shader, and its captions name what the sheets show."""
    text = page.read_text()
    told = subprocess.run([program, "help", "shaders"], capture_output=True, text=True).stdout
    shown = re.findall(r"^```\n\$ candela help \w+\n(?:\.\.\.\n)?(.*?)^```", text, re.MULTILINE | re.DOTALL)
    if "\n".join(shown) != told:
        yield f"{page}: it does not show all that candela help shaders does"
    captions = re.findall(r"!\[.*\]\((\w+)s\.png\)\n\n(.*): from the left", text)
    for kind, names in captions:
        if re.findall(rf"^{kind} (\w+)\(", told, re.MULTILINE) != re.findall(r"`(\w+)`", names):
            yield f"{page}: the caption of {kind}s names others; tools/shader-swatches makes the sheet"
    if len(captions) != len(shown):
        yield f"{page}: {len(shown)} kinds have {len(captions)} sheets"


def complaints_of(page, program, root):
    for block in BLOCK.findall(page.read_text()):
        command, *shown = block.rstrip("\n").split("\n")
        words = shlex.split(command)[2:]
        run = subprocess.run([program, *words], cwd=root, capture_output=True, text=True)
        printed = [line.rstrip() for line in run.stdout.split("\n")]
        missing = missing_piece([line.rstrip() for line in shown], printed)
        if run.returncode != 0 or missing:
            yield f"{page}: {command}\n  exit status {run.returncode} {run.stderr}\n  not there: " + \
                "\n             ".join(missing or [])


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    test_the_test()
    program, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    pages = sorted(root.glob("docs/**/*.md")) + [root / "README.md"]
    blocks = sum(len(BLOCK.findall(page.read_text())) for page in pages)
    complaints = [text for page in pages for text in complaints_of(page, program, root)]
    complaints += [text for page in pages for text in complaints_of_listings(page, program)]
    complaints += [text for page in pages for text in complaints_of_links(page)]
    complaints += complaints_of_limits(root / "docs" / "limits.md", root)
    complaints += complaints_of_shaders(root / "docs" / "reference" / "shaders.md", program)
    print("\n".join(complaints))
    print(f"{len(pages)} pages, {blocks} blocks, {len(complaints)} complaints")
    sys.exit(1 if complaints or not blocks else 0)


if __name__ == "__main__":
    main()
