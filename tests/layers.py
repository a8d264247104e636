#!/usr/bin/env python3
"""layers.py ROOT: fails on an #include that points up the list of layers in src/meson.build.

src/LAYER/   its own folder, the layers before it in the list, and dapple/; reference/ not gpu/
include/     dapple/
apps/NAME/   its own folder, dapple/, and headers without a folder (beside the file, or a library's); cli/ also viewer/
examples/    dapple/, and headers without a folder
"""
import ast
import re
import sys
from pathlib import Path
from typing import Iterator

NEVER = {"reference": {"gpu"}}  # the ground truth must not share code with what it judges
APPS = {"cli": ["cli", "viewer"]}  # the one program opens the window too
SUFFIXES = {".c", ".h", ".cpp", ".glsl"}
INCLUDE = re.compile(r'\s*#\s*include\s*(?:"([^"]+)"|<(dapple/[^>]+)>)')


def read_layers(root: Path) -> list[str]:
    text = (root / "src/meson.build").read_text()
    found = re.search(r"^layers = (\[.*?\])", text, re.MULTILINE | re.DOTALL)
    if not found:
        sys.exit("src/meson.build: no `layers = [...]`")
    return ast.literal_eval(found.group(1))


def allowed_folders(path: Path, layers: list[str]) -> list[str]:
    """The folders that a file may include from; `path` is relative to the root."""
    if path.parts[0] == "apps":
        return ["dapple"] + APPS.get(path.parts[1], [path.parts[1]])
    if path.parts[0] != "src":
        return ["dapple"]
    layer = path.parts[1]
    if layer not in layers:
        return []
    below = layers[:layers.index(layer) + 1]
    return ["dapple"] + [name for name in below if name not in NEVER.get(layer, ())]


def includes(file: Path) -> Iterator[tuple[int, str]]:
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1) or match.group(2)


def check(root: Path) -> list[str]:
    layers = read_layers(root)
    wrong = []
    files = [file for top in ("src", "include", "apps", "examples") for file in sorted((root / top).rglob("*"))
             if file.suffix in SUFFIXES]
    for file in files:
        path = file.relative_to(root)
        if path.parts[0] == "src" and path.parts[1] not in layers:
            wrong.append(f"{path}: no such layer in src/meson.build: {path.parts[1]} (layers: {' '.join(layers)})")
            continue
        folders = allowed_folders(path, layers)
        plain_names = path.parts[0] in ("apps", "examples")
        for number, name in includes(file):
            if name.split("/")[0] not in folders and not (plain_names and "/" not in name):
                accepted = " ".join(folder + "/" for folder in folders)
                wrong.append(f'{path}:{number}: must not include "{name}" (accepted: {accepted})')
    if not files:
        wrong.append(f"{root}: no source files")
    return wrong


def main() -> None:
    wrong = check(Path(sys.argv[1]))
    print("\n".join(wrong) or "every include points down")
    sys.exit(1 if wrong else 0)


main()
