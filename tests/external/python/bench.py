"""Counts ten-second runs per CPU-second: through Python, with and without mass, of the hand, and of MuJoCo's `rollout` on the
exported model of the same quadruped, driven by the angles of the same walk, at its default step and at that of the exported model.
Then compares two threads with one, and Python with the command. Prints ratios, which a busy machine changes little.

Needs the package and a release build of `tip`, as `run figures` makes them, and mujoco; runs in a folder with walk.prg, grasp.prg and
scene.toml.
"""

import resource
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor

import mujoco
import numpy as np
from mujoco import rollout

import tip_motion as tip
from tip_motion import _native

SECONDS = 10
ROUNDS = 5


def cpu(function):
    """Returns the CPU time of a call, s."""
    began = time.process_time()
    function()
    return time.process_time() - began


def wall(function):
    """Returns the time of a call on the wall clock, s."""
    began = time.perf_counter()
    function()
    return time.perf_counter() - began


def least(measure, *functions):
    """Measures functions in turn, and returns the least figure of each."""
    rounds = [[measure(function) for function in functions] for _ in range(ROUNDS)]
    return [min(figures) for figures in zip(*rounds)]


def ours(count, program, **options):
    document = tip.spec(program, repeat=count, until=SECONDS, **options)
    _native.cases(document)
    return lambda: _native.run_chunk(document, 0, count)


def theirs(count, step):
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
    return lambda: rollout.rollout(model, data, np.tile(state, (count, 1)), control)


def rates():
    subprocess.run(["tip", "robot", "export", "--mjcf", "-o", "titan8.xml"], check=True)
    kinds = {
        "MuJoCo, 2 ms": (4, theirs(4, 0.002)),
        "MuJoCo, 0.5 ms": (2, theirs(2, 0.0005)),
        "without mass": (200, ours(200, "walk.prg")),
        "with mass": (6, ours(6, "walk.prg", plant="dynamic")),
        "hand": (24, ours(24, "grasp.prg", robot="hand", scene="scene.toml")),
    }
    times = least(cpu, *(function for _, function in kinds.values()))
    best = {name: count / seconds for (name, (count, _)), seconds in zip(kinds.items(), times)}
    for name, rate in best.items():
        print(f"{name:15} {rate:7.1f} runs a CPU-second, {rate / best['MuJoCo, 2 ms']:6.2f} x MuJoCo, 2 ms")


def threads():
    def on(count, **options):
        pool = ThreadPoolExecutor(count)
        return lambda: tip.sweep("walk.prg", until=SECONDS, executor=pool, **options)

    def command(count, repeat):
        arguments = ["tip", "sweep", "walk.prg", "--until", f"{SECONDS}s", "--repeat", f"{repeat}", "-q", "-o", "-", "--jobs", f"{count}"]
        return lambda: subprocess.run(arguments, check=True, stdout=subprocess.DEVNULL)

    for name, one, two in [
        ("Python, without mass", on(1, repeat=800, chunk=20), on(2, repeat=800, chunk=20)),
        ("Python, with mass", on(1, repeat=24, chunk=2, plant="dynamic"), on(2, repeat=24, chunk=2, plant="dynamic")),
        ("tip sweep", command(1, 800), command(2, 800)),
    ]:
        one, two = least(wall, one, two)
        print(f"two threads: {one / two:.2f} x one, {name} (wall clock)")


def overhead():
    """The share of a chunk of 200 runs that Python adds: to the native chunk, and to the command, whose start is subtracted."""
    pool = ThreadPoolExecutor(1)
    chunk = ours(200, "walk.prg")

    def python():
        tip.sweep("walk.prg", repeat=200, until=SECONDS, executor=pool, chunk=200)

    def command(repeat):
        return lambda: subprocess.run(
            ["tip", "sweep", "walk.prg", "--until", f"{SECONDS}s", "--repeat", f"{repeat}", "-q", "-o", "-", "--jobs", "1"],
            check=True,
            stdout=subprocess.DEVNULL,
        )

    def children(function):
        def total():
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            return usage.ru_utime + usage.ru_stime

        began = total()
        function()
        return total() - began

    native, whole = least(cpu, chunk, python)
    one, many = least(children, command(1), command(201))
    print(f"Python adds {100 * (whole / native - 1):.1f} % to a native chunk of 200 runs; to `tip sweep` {100 * (whole / (many - one) - 1):.1f} %")


def start():
    starts = 2000
    chunk = tip.spec("walk.prg", repeat=starts, cycles=1)
    (seconds,) = least(cpu, lambda: _native.run_chunk(chunk, 0, starts))
    print(f"start of a run, with one cycle and its row: {seconds / starts * 1e6:.0f} µs")


if __name__ == "__main__":
    for part in (rates, threads, overhead, start):
        part()
