"""The smallest disturbance that a program does not withstand."""

from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike

from . import _arguments as arguments
from . import _native
from ._sweep import _table, spec

#: The greatest tilt (deg), slip and lost travel (mm), and the least margin (mm), of a run that counts as good.
LIMITS = {"tilt": 30.0, "slip": 100.0, "lost_travel": 200.0, "least_margin": -50.0}


@dataclass(frozen=True)
class Falsified:
    """The end of a search: `value` is bad, and `good`, next to it, is not."""

    quantity: str
    value: float
    good: float
    reason: str
    row: dict
    spec: str

    def __str__(self):
        return f"{self.quantity} = {self.value:g}: {self.reason}; {self.quantity} = {self.good:g} is good"


def falsify(
    program: str | PathLike,
    quantity: str,
    *,
    good: float,
    bad: float,
    tolerance: float = 1.0,
    limits: Mapping[str, float] | None = None,
    **options,
) -> Falsified:
    """Bisects between a value of a quantity that a program withstands and one that it does not.

    A run is bad if the robot falls or stops in an emergency, or if it exceeds one of `limits`: "tilt" (deg), "slip" and
    "lost_travel" (mm, compared with the run at `good`), or falls below "least_margin" (mm). A robot with mass that rocks and stands
    again has not fallen. The given limits replace the defaults of `LIMITS`; None switches one off. Every run is deterministic, so the result is a case that anyone can repeat:
    `sweep` with `vary={quantity: [value]}`. Where good and bad values alternate, it is one of the borders.
    """
    limits = {**LIMITS, **(limits or {})}
    unknown = set(limits) - set(LIMITS)
    if unknown:
        raise ValueError(f"unknown limits: {', '.join(sorted(unknown))}; they are {', '.join(LIMITS)}")
    for name, value in (("good", good), ("bad", bad), ("tolerance", tolerance)):
        arguments.number(name, value)
    for name, value in limits.items():
        if value is not None:
            arguments.number(f"limits[{name!r}]", value)
    if tolerance <= 0:
        raise ValueError("the tolerance must be above 0")
    vary = dict(options.pop("vary", None) or {})

    def run(value):
        document = spec(program, vary={**vary, quantity: [value]}, **options)
        return document, _table(_native.run_chunk(document, 0, 1), document).to_pylist()[0]

    document, start = run(good)
    has_mass = _native.has_forces(document)
    why = _reason(start, start, limits, has_mass)
    if why:
        raise ValueError(f"{quantity} = {good:g} should be good, but is not: {why}")
    document, row = run(bad)
    why = _reason(row, start, limits, has_mass)
    if not why:
        raise ValueError(f"{quantity} = {bad:g} should be bad, but is good; widen the range or tighten the limits")
    while abs(bad - good) > tolerance:
        middle = (good + bad) / 2
        tried, result = run(middle)
        reason = _reason(result, start, limits, has_mass)
        if reason:
            bad, document, row, why = middle, tried, result, reason
        else:
            good = middle
    return Falsified(quantity, bad, good, why, row, document)


def _reason(row, start, limits, has_mass):
    # A robot with mass that came to stand again has not fallen; what it went through is up to the limits.
    stood = row.get("upright_falls", 0) if has_mass else 0
    if row.get("falls", 0) > stood:
        return f"the robot falls after {row['first_fall']:.3f} s"
    if row["end"] not in ("END", "EXIT", "limit"):
        return f"emergency stop: {row['end']}"
    lost = start.get("forward", 0.0) - row.get("forward", 0.0)
    for name, unit in (("tilt", "deg"), ("slip", "mm"), ("lost_travel", "mm"), ("least_margin", "mm")):
        limit = limits[name]
        value = lost if name == "lost_travel" else row.get(name)
        if limit is None or value is None:
            continue
        if value < limit if name == "least_margin" else value > limit:
            return f"{name} is {value:.1f} {unit}, the limit {limit:g}"
    return ""
