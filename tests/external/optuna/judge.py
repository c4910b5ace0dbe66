"""Judges examples/walk/tune.py: `judge.py EXAMPLE FOLDER TRIALS`. The studies are read with Optuna and with SQLite alone."""

import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import optuna
import tip_motion as tip
from optuna.trial import TrialState

example, folder, trials = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3])
script = [sys.executable, str(example / "tune.py"), str(trials)]
optuna.logging.set_verbosity(optuna.logging.WARNING)


def study_of(place):
    return optuna.load_study(study_name="walk", storage=f"sqlite:///{place}/walk.db")


def finished(place):
    """Returns the number of trials that are complete or pruned, without Optuna."""
    try:
        with sqlite3.connect(f"file:{place}/walk.db?mode=ro", uri=True) as database:
            return database.execute("SELECT COUNT(*) FROM trials WHERE state IN ('COMPLETE', 'PRUNED')").fetchone()[0]
    except sqlite3.OperationalError:
        return 0


# A study from its beginning to its end.
whole = folder / "whole"
whole.mkdir()
began = time.monotonic()
subprocess.run(script, cwd=whole, check=True, stderr=subprocess.DEVNULL)
elapsed = time.monotonic() - began
assert finished(whole) == trials, finished(whole)
plots = sorted(path.name for path in whole.glob("*.html"))
assert plots == ["walk-intermediate_values.html", "walk-optimization_history.html", "walk-slice.html"], plots

# Its best value is that of a sweep with the same numbers, and pruned runs were shorter than complete ones.
study = study_of(whole)
[best] = tip.sweep(example / "motions/walk.prg", vary=study.best_params, until=120).to_pylist()
assert (best["speed"], best["falls"]) == (study.best_value, 0), (best, study.best_value)
states = [trial.state for trial in study.trials]
assert states.count(TrialState.PRUNED) > 0 and states.count(TrialState.COMPLETE) > 0, states

# A study that is killed goes on: nothing is lost, and nothing is done twice.
killed = folder / "killed"
killed.mkdir()
process = subprocess.Popen(script, cwd=killed, stderr=subprocess.DEVNULL)
while finished(killed) < trials // 3:
    assert process.poll() is None, "the study has ended before it was killed"
    time.sleep(0.005)
process.kill()
assert process.wait() == -signal.SIGKILL
left = finished(killed)
assert left < trials, left
values = [trial.value for trial in study_of(killed).trials if trial.state.is_finished()]
subprocess.run(script, cwd=killed, check=True, stderr=subprocess.DEVNULL)
assert finished(killed) == trials, finished(killed)
study = study_of(killed)
again = [trial.value for trial in study.trials][: len(values)]
assert again == values
assert all(trial.state.is_finished() for trial in study.trials)

# The same by a grid of about as many cases.
steps = max(round((trials / 2) ** (1 / 3)), 2)
between = lambda low, high, count: [low + (high - low) * step / (count - 1) for step in range(count)]
vary = {"STRIDE": between(120, 300, steps), "SWAY": between(0, 60, steps), "LIFT": [20, 60], "SPEED": between(200, 400, steps)}
began = time.monotonic()
rows = tip.sweep(example / "motions/walk.prg", vary=vary, until=120).to_pylist()
took = time.monotonic() - began
grid = max(row["speed"] for row in rows if row["falls"] == 0 and row["end"] in ("END", "EXIT"))
print(f"study: {trials} trials in {elapsed:.1f} s, best {study_of(whole).best_value:.2f} mm/s")
print(f"killed after {left} trials and resumed: best {study.best_value:.2f} mm/s")
print(f"grid: {len(rows)} cases in {took:.1f} s, best {grid:.2f} mm/s")
