#!/usr/bin/env python3
"""shaders.py PROGRAM SOURCE [FOLDER]: compiles and links every shader in every dialect with glslangValidator.

PROGRAM writes the text of a stage (shader_source.c), from what the library was built with or from FOLDER. The shaders
are the .glsl files below SOURCE that no other one includes; those in optics/ are formulas, never a whole shader.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

DRAWING = {"vertex": "vert", "fragment": "frag"}
WITH_GEOMETRY = {**DRAWING, "geometry": "geom"}
COMPUTING = {"compute": "comp"}


def top_level(source: Path) -> list[str]:
    texts = {str(file.relative_to(source)): file.read_text() for file in sorted(source.rglob("*.glsl"))}
    included = {name for text in texts.values() for name in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE)}
    return [name for name in texts if name not in included and not name.startswith("optics/")]


def kinds(text: str) -> list[tuple[str, dict[str, str]]]:
    """Dialects and stages that a shader is for. What needs storage buffers is only for the newer dialects, what has a
    geometry stage only for OpenGL proper."""
    if "#ifdef GEOMETRY" in text:
        return [("gl33", WITH_GEOMETRY), ("gl43", WITH_GEOMETRY)]
    stages = COMPUTING if "local_size_x" in text else DRAWING
    older = [] if "std430" in text else ["gl33", "es30"]
    return [(dialect, stages) for dialect in [*older, "gl43", "es31"]]


def validate(program: str, shader: str, dialect: str, stages: dict[str, str], folder: list[str]) -> str:
    """What is wrong with the shader; empty where nothing is."""
    with tempfile.TemporaryDirectory() as scratch:
        names = []
        for stage, suffix in stages.items():
            made = subprocess.run([program, shader, dialect, stage, *folder], capture_output=True, text=True)
            if made.returncode:
                return made.stderr
            names.append(f"{stage}.{suffix}")
            Path(scratch, names[-1]).write_text(made.stdout)
        # -l also finds a missing main(), and a vertex stage whose outputs are not the fragment stage's inputs.
        said = subprocess.run(["glslangValidator", "-l", *names], cwd=scratch, capture_output=True, text=True)
        return said.stdout + said.stderr if said.returncode else ""


def main() -> None:
    program, source, *folder = sys.argv[1:]
    shaders = top_level(Path(source))
    failed = not shaders
    for shader in shaders:
        for dialect, stages in kinds(Path(source, shader).read_text()):
            wrong = validate(program, shader, dialect, stages, folder)
            print(f"{shader} {dialect}: {wrong or 'good'}")
            failed = failed or bool(wrong)
    sys.exit(1 if failed else 0)


main()
