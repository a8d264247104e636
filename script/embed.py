#!/usr/bin/env python3
"""Turns files of the repository into C at build time.

embed.py shaders OUT ROOT FILE...   base_resources[]: paths relative to ROOT, and texts
embed.py scenes  OUT FILE...        dpl_builtin_scenes(): names, the comments of their first lines, and texts
"""
import sys
from pathlib import Path


def c_string(text: str) -> str:
    lines = []
    for line in text.splitlines(keepends=True):
        escaped = line.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
        lines.append(f'     "{escaped}"')
    return "\n".join(lines) or '     ""'


def shaders(root: Path, files: list[Path]) -> str:
    rows = [f'    {{"{file.relative_to(root)}",\n{c_string(file.read_text())}}},\n' for file in sorted(files)]
    return ('#include "base/resource.h"\n\nconst struct base_resource base_resources[] = {\n'
            + "".join(rows) + "    {NULL, NULL},\n};\n")


def scenes(files: list[Path]) -> str:
    rows = []
    for file in sorted(files):
        text = file.read_text()
        summary = text.splitlines()[0].lstrip("; ")
        rows.append(f'    {{"{file.stem}",\n{c_string(summary)},\n{c_string(text)}}},\n')
    return ('#include "dapple/scene.h"\n\nstatic const struct dpl_builtin_scene scenes[] = {\n' + "".join(rows)
            + "    {NULL, NULL, NULL},\n};\n\n"
            "const struct dpl_builtin_scene *dpl_builtin_scenes(void)\n{\n    return scenes;\n}\n")


def main() -> None:
    kind, out, *rest = sys.argv[1:]
    paths = [Path(name).resolve() for name in rest]
    Path(out).write_text(shaders(paths[0], paths[1:]) if kind == "shaders" else scenes(paths))


main()
