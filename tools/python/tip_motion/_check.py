"""Diagnostics of programs as objects."""

import json
from dataclasses import dataclass
from os import PathLike

from . import _native
from ._sweep import _file, _robot


@dataclass(frozen=True)
class Diagnostic:
    """An error or warning. Lines and columns count from 1; `json` has everything that `tip check` writes."""

    level: str
    code: str
    line: int
    column: int
    reason: str
    help: str | None
    json: dict

    def __str__(self):
        return f"{self.line}:{self.column}: {self.level}[{self.code}]: {self.reason}"


def check(program: str | PathLike, *, robot: str | PathLike = "titan8", lang: str = "en") -> list[Diagnostic]:
    """Checks a program for a robot and returns its errors and warnings.

    `program` is a path, or the text of a program if it has more than one line; `robot` is that of `spec`; `lang` is "en" or "ja".
    """
    name, text = _file(program, "program.prg", encoding=None)
    found = _native.check(name, text, json.dumps(_robot(robot)), lang == "ja")
    return [_diagnostic(json.loads(line)) for line in found]


def _diagnostic(one):
    return Diagnostic(
        one["level"], one["code"], one.get("line", 0), one.get("column", 0), one.get("reason", one.get("message", "")), one.get("help"), one
    )
