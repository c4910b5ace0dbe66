"""Checks of arguments: each error names the argument, its value, and what is needed."""

import math
import numbers
from collections.abc import Iterable
from os import PathLike


def number(name: str, value) -> float:
    """Returns a finite number as float."""
    if not isinstance(value, numbers.Real) or isinstance(value, bool) or not math.isfinite(value):
        raise wrong(name, "a finite number", value)
    return float(value)


def count(name: str, value, least: int = 0) -> int:
    """Returns a whole number of 64 bits."""
    whole = isinstance(value, numbers.Integral) and not isinstance(value, bool)
    if not whole or not least <= value < 2**64:
        raise wrong(name, f"a whole number, {least} or more", value)
    return int(value)


def one_of(name: str, value, words: tuple[str, ...]) -> str:
    """Returns a word, if it is one of those."""
    if value not in words:
        raise wrong(name, f"one of {', '.join(words)}", value)
    return value


def names(name: str, value) -> list[str]:
    """Returns a list of names; one name is not a list."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        raise wrong(name, "a list of names", value)
    found = list(value)
    for one in found:
        if not isinstance(one, str):
            raise wrong(name, "a list of names", value)
    return found


def place(name: str, value) -> str | PathLike:
    """Returns a path, a name or a text."""
    if not isinstance(value, (str, PathLike)):
        raise wrong(name, "a path, a name or a text", value)
    return value


def wrong(name: str, needed: str, value) -> ValueError:
    """Returns the error of an argument."""
    return ValueError(f"{name}: {needed} is needed, not {value!r:.60}")
