"""Tunes walk.prg with Optuna for speed without a fall: `python tune.py [TRIALS]`, 200 by default. Needs tip-motion, optuna and plotly.

The study is in walk.db of the current folder. A killed study goes on with the same command.
"""

import sys
from pathlib import Path

import optuna
import tip_motion as tip
from optuna.distributions import FloatDistribution
from optuna.trial import TrialState

trials = int(sys.argv[1]) if len(sys.argv) > 1 else 200
program = Path(__file__).parent / "motions" / "walk.prg"
ranges = {"STRIDE": (120, 300), "SWAY": (0, 60), "LIFT": (20, 60), "SPEED": (200, 400)}
pruner = optuna.pruners.MedianPruner(n_startup_trials=20, n_warmup_steps=2)
study = optuna.create_study(
    study_name="walk", storage="sqlite:///walk.db", load_if_exists=True, direction="maximize", pruner=pruner
)
for killed in study.get_trials(deepcopy=False, states=[TrialState.RUNNING]):
    study.tell(killed.number, state=TrialState.FAIL)

for _ in range(trials - len(study.get_trials(deepcopy=False, states=[TrialState.COMPLETE, TrialState.PRUNED]))):
    trial = study.ask({name: FloatDistribution(*bounds) for name, bounds in ranges.items()})
    run = tip.Run(program, vary=trial.params, until=120, trace=False)
    part = 0
    # A run that falls, or is slower than others were after as many cycles, is stopped early. Pruned trials guide the sampler.
    while run.step(500) and run.falls == 0 and not trial.should_prune():
        trial.report(run.travel / run.time, part)
        part += 1
    if run.falls == 0 and run.end in ("END", "EXIT"):
        study.tell(trial, run.travel / run.time)
    else:
        study.tell(trial, state=TrialState.PRUNED)

finished = [len(study.get_trials(deepcopy=False, states=[state])) for state in (TrialState.COMPLETE, TrialState.PRUNED)]
print(f"{finished[0]} trials complete, {finished[1]} pruned; best: {study.best_value:.2f} mm/s with {study.best_params}")
for plot in ("optimization_history", "slice", "intermediate_values"):
    getattr(optuna.visualization, f"plot_{plot}")(study).write_html(f"walk-{plot}.html")
