"""Counts ten-second runs per CPU-second: through Python, with and without mass, of the hand, and of MuJoCo's `rollout` on the
exported model of the same quadruped, driven by the angles of the same walk, at its default step and at that of the exported model.
Prints ratios, which a busy machine changes little.

Needs the package and `tip` as `run` builds them, and mujoco; run it in a folder with walk.prg, grasp.prg and scene.toml.
"""

import subprocess
import time

import mujoco
import numpy as np
from mujoco import rollout

import tip_motion as tip
from tip_motion import _native

SECONDS = 10
ROUNDS = 3


def cpu(function):
    began = time.process_time()
    count = function()
    return count / (time.process_time() - began)


def ours(count, program, **options):
    document = tip.spec(program, repeat=count, until=SECONDS, **options)
    _native.cases(document)

    def run():
        _native.run_chunk(document, 0, count)
        return count

    return run


def theirs(count, step):
    subprocess.run(["tip", "robot", "export", "--mjcf", "-o", "titan8.xml"], check=True)
    model = mujoco.MjModel.from_xml_path("titan8.xml")
    model.opt.timestep = step
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    state = np.empty(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
    mujoco.mj_getState(model, data, state, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    run, angles = tip.Run("walk.prg", plant="dynamic", trace=False), []
    while run.time < SECONDS:
        run.step()
        angles.append(np.radians(run.joints.ravel()))
    steps = round(0.02 / model.opt.timestep)
    control = np.repeat(np.array(angles), steps, axis=0)[None]

    def simulate():
        rollout.rollout(model, data, np.tile(state, (count, 1)), control)
        return count

    return simulate


def main():
    began = time.process_time()
    starts = 2000
    sweep = tip.spec("walk.prg", repeat=starts, cycles=1)
    _native.cases(sweep)
    _native.run_chunk(sweep, 0, starts)
    print(f"start of a run, with one cycle: {(time.process_time() - began) / starts * 1e6:.0f} µs")
    kinds = {
        "MuJoCo, 2 ms": theirs(4, 0.002),
        "MuJoCo, 0.5 ms": theirs(2, 0.0005),
        "without mass": ours(40, "walk.prg"),
        "with mass": ours(4, "walk.prg", plant="dynamic"),
        "hand": ours(8, "grasp.prg", robot="hand", scene="scene.toml"),
    }
    rates = {name: [] for name in kinds}
    for _ in range(ROUNDS):
        for name, function in kinds.items():
            rates[name].append(cpu(function))
    best = {name: max(each) for name, each in rates.items()}
    for name, rate in best.items():
        print(f"{name:15} {rate:7.1f} runs a CPU-second, {rate / best['MuJoCo, 2 ms']:6.2f} x MuJoCo, 2 ms")
    serial = ours(200, "walk.prg")
    began = time.perf_counter()
    serial()
    one = time.perf_counter() - began
    began = time.perf_counter()
    tip.sweep("walk.prg", repeat=200, until=SECONDS, chunk=10)
    print(f"200 runs on all cores: {one / (time.perf_counter() - began):.2f} x one thread (wall clock)")


if __name__ == "__main__":
    main()
