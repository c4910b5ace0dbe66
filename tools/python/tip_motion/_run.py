"""Runs that Python drives."""

from os import PathLike

import numpy as np

from . import _native
from ._arguments import count, number
from ._sweep import spec


class Snapshot:
    """The state of a run at a moment."""

    def __init__(self, native, arguments):
        self._native, self._arguments = native, arguments


class Run:
    """A run of a program on a simulated robot; the options are those of `spec`.

    A value in `vary` takes the place of the constants that the program assigns to the variable before its first use; so
    does `set` before the first cycle. With a random value in `vary`, `case` chooses the sample.
    """

    def __init__(self, program: str | PathLike, *, case: int = 0, trace: bool = True, **options):
        case = count("case", case)
        self._arguments = program, case, trace, options
        self._native = _native.Run(spec(program, **options), case, trace)

    def step(self, cycles: int = 1) -> bool:
        """Runs some control cycles. Returns true while the program goes on, and false from the longest time `until` on, or when
        the number `cycles` of `spec` is used up."""
        return self._native.step(count("cycles", cycles))

    def run_to_end(self) -> str:
        """Runs until the program ends or the time on the robot is `until`, and returns the end as in tables."""
        self._native.step(2**62)
        return self.end

    def set(self, name: str, value: float) -> None:
        """Sets a variable. Before the first cycle any quantity of a sweep can be set, such as friction."""
        if self._native.cycles > 0:
            return self._native.set(name, number(name, value))
        program, case, trace, options = self._arguments
        vary = {**(options.get("vary") or {}), name: [number(name, value)]}
        changed = {**options, "vary": vary}
        self._native = _native.Run(spec(program, **changed), case, trace)
        self._arguments = program, case, trace, changed

    def event(self, text: str) -> None:
        """Lets something happen before the next step, such as "key F", "VR1=8", "halt" or "push 80 0 0 for 5"; with a cycle,
        as in "300:halt", before the step of that cycle."""
        self._native.event(text)

    def read(self, name: str) -> float:
        """Returns a variable of the program, or one of x, y, z, roll, pitch, yaw, right, forward, up, turn, falls, slip,
        margin, time, J11…, load1…; NaN where the robot has no such number."""
        return self._native.read(name)

    def snapshot(self) -> Snapshot:
        """Marks the present state."""
        return Snapshot(self._native.snapshot(), self._arguments)

    def restore(self, mark: Snapshot) -> None:
        """Takes the run back to a mark; from there it repeats itself to the bit. The mark may be of another run of the same program
        on the same robot, in the same scene and simulation."""
        if not isinstance(mark, Snapshot):
            raise ValueError(f"restore: a snapshot is needed, not {mark!r:.60}")
        self._native.restore(mark._native)
        self._arguments = mark._arguments

    @property
    def joints(self) -> np.ndarray:
        """The measured joint angles, one row for each leg, deg."""
        data, of_leg = self._native.joints()
        return np.frombuffer(data, "<f8").reshape(-1, of_leg)

    @property
    def pose(self) -> np.ndarray | None:
        """x, y and z of the body, mm, and its roll, pitch and yaw, deg; None for a robot that stays where it is."""
        pose = self._native.pose()
        return None if pose is None else np.array(pose)

    @property
    def travel(self) -> float:
        """The travel forward, mm."""
        return self.read("forward")

    @property
    def falls(self) -> int:
        """The number of falls; 0 for a robot that cannot fall."""
        falls = self.read("falls")
        return 0 if falls != falls else int(falls)

    @property
    def end(self) -> str:
        """END, EXIT, limit, or the fault that stopped the robot."""
        return self._native.end or "limit"

    @property
    def cycles(self) -> int:
        """The number of control cycles."""
        return self._native.cycles

    @property
    def time(self) -> float:
        """The time on the robot, s."""
        return self.read("time")

    @property
    def line(self) -> int:
        """The line of the step that is next, or that stopped the robot."""
        return self._native.line

    def trace(self) -> str:
        """Returns the trace, one JSON object per line."""
        return self._native.trace()

    def __repr__(self):
        return f"<Run {self._arguments[0]!r:.60} at line {self.line} after {self.cycles} cycles>"
