"""Thousands of deterministic runs of T.I.P. robot programs.

A case of a sweep depends on the arguments of `sweep` and its own number alone, so that threads, processes and
machines give the same table. Lengths are mm, angles deg, times s, forces N, torques N·m, energies J.
"""

from ._check import Diagnostic, check
from ._falsify import Falsified, falsify
from ._native import __version__
from ._run import Run, Snapshot
from ._sweep import latin_hypercube, load, normal, save, spec, sweep, table_hash, uniform

__all__ = [
    "Diagnostic", "Falsified", "Run", "Snapshot", "VecEnv", "__version__", "check", "falsify", "latin_hypercube", "load", "normal",
    "save", "spec", "sb3_vec_env", "sweep", "table_hash", "uniform",
]


def __getattr__(name):
    # gymnasium and stable-baselines3 are optional.
    if name in ("VecEnv", "sb3_vec_env"):
        from . import _vec_env

        return getattr(_vec_env, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
