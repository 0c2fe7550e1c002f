# SPDX-FileCopyrightText: 2026 The PEMesh developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the types of the wrapped classes, which editors and type checkers read.

    make-stubs.py FILE.pyi

They come from the signatures that VTK's wrapper puts first into every docstring.
"""

import os
import re
import sys

import pemesh._classes as classes

HEAD = '''"""The wrapped classes; made from their docstrings."""
from collections.abc import MutableSequence, Sequence
from typing import Any, overload

'''


def signatures(name, docstring):
    """The lines `name(self, x:float) -> int`, one an overload, joined where they are broken."""
    text = re.sub(r"\n {4,}", " ", docstring or "")
    for line in text.split("\n"):
        match = re.fullmatch(rf"{name}\((.*?)\)(?: -> (.*))?", line.strip())
        if match:
            yield match.group(1), match.group(2) or "Any"


def split(text):
    """Splits at the commas outside brackets."""
    parts, depth, part = [], 0, ""
    for character in text:
        depth += {"(": 1, "[": 1, ")": -1, "]": -1}.get(character, 0)
        if character == "," and depth == 0:
            parts.append(part.strip())
            part = ""
        else:
            part += character
    return [*parts, part.strip()] if part.strip() else parts


class Stubs:
    def __init__(self):
        self.imports = {}

    def type_of(self, text, answered):
        text = text.strip()
        if text.startswith(("(", "[")):
            items = [self.type_of(item, answered) for item in split(text[1:-1]) if item != "..."]
            if text.startswith("(") and answered:
                return f"tuple[{', '.join(items)}{', ...' if '...' in text else ''}]"
            kind = "Sequence" if text.startswith("(") else "MutableSequence"
            return f"{kind}[{' | '.join(dict.fromkeys(items)) or 'Any'}]"
        if text in ("int", "float", "str", "bool", "None", "bytes"):
            return text
        known = vars(classes).get(text)
        if known is None:
            known = next((vars(module)[text] for name, module in list(sys.modules.items())
                          if name.startswith("vtkmodules.vtk") and text in vars(module)), None)
        if not isinstance(known, type):
            return "Any"
        if not known.__module__.startswith("pemesh"):
            self.imports[text] = known.__module__
        return text

    def parameter(self, text):
        name, _, kind = text.partition(":")
        kind, has_default, _ = kind.partition("=")
        return f"{name}: {self.type_of(kind, False)}{' = ...' if has_default else ''}"

    def method(self, name, function):
        found = list(dict.fromkeys(signatures(name, function.__doc__)))
        for parameters, answer in found:
            parts = split(parameters)
            is_static = not parts or parts[0] != "self"
            names = [self.parameter(part) for part in parts[0 if is_static else 1:]]
            if is_static:
                yield "    @staticmethod"
            if len(found) > 1:
                yield "    @overload"
            yield (f"    def {name}({', '.join(names if is_static else ['self', *names])})"
                   f" -> {self.type_of(answer, True)}: ...")

    def one_class(self, name, kind):
        base = kind.__bases__[0]
        yield f"class {name}({self.type_of(base.__name__, False)}):"
        body = [line for method, function in vars(kind).items()
                if not method.startswith("_") and callable(function)
                for line in self.method(method, function)]
        yield from body or ["    ..."]
        yield ""


def main(path):
    stubs = Stubs()
    body = [line for name in sorted(classes.__all__)
            for line in stubs.one_class(name, getattr(classes, name))]
    imports = [f"from {module} import {name}" for name, module in sorted(stubs.imports.items())]
    temporary = path + ".part"
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(HEAD + "\n".join([*imports, "", *body]))
    os.replace(temporary, path)


main(sys.argv[1])
