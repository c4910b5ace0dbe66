"""Judges the Python package in an empty folder with the example programs; packages that are missing are named."""

import concurrent.futures
import importlib.util
import json
import multiprocessing
import os
import pickle
import resource
import signal
import stat
import subprocess
import sys
import threading
import time
import types
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path

import numpy as np
import pyarrow.csv

import tip_motion as tip
from tip_motion import _native

LIFT = "3.1\nLifts a foot\nDEF_VAR Z\nZ = 20\nREL_PTP F1 0 0 Z\nWAIT_INPOS F1\nEND\n"
OPTIONS = {"vary": {"Z": [10, 20, 30], "friction": tip.uniform(0.4, 1.0)}, "repeat": 100, "seed": 7, "plant": "dynamic", "until": 0.4, "record": ["Z"]}


def has(*packages):
    missing = [name for name in packages if not importlib.util.find_spec(name)]
    if missing:
        print(f"not judged: {', '.join(missing)}: pip install {' '.join(missing)}")
    return not missing


def raises(kind, function, *arguments, says="", **options):
    try:
        function(*arguments, **options)
    except kind as error:
        assert says in str(error), error
    else:
        raise AssertionError(f"{kind.__name__} expected")


def kill_after_first(directory, pids):
    """Kills a process of `pids` as soon as a chunk is there."""

    def kill():
        while not list(Path(directory).glob("part-*")):
            time.sleep(0.01)
        os.kill(pids()[0], signal.SIGKILL)

    thread = threading.Thread(target=kill)
    thread.start()
    return thread


def sweeps():
    serial = tip.sweep(LIFT, executor=ThreadPoolExecutor(1), **OPTIONS)
    expected = tip.table_hash(serial)
    assert serial.num_rows == 300 and len(set(serial["hash"].to_pylist())) > 250
    assert serial.schema.field("forward").metadata == {b"unit": b"mm", b"meaning": b"travel of the body forward"}
    assert tip.table_hash(tip.sweep(LIFT, chunk=7, **OPTIONS)) == expected

    document = tip.spec(LIFT, **OPTIONS)
    alone = {name: values for name, _, _, _, values in _native.run_chunk(document, 117, 1)}
    assert alone["hash"] == [serial["hash"][117].as_py()]
    assert np.frombuffer(alone["energy"])[0] == serial["energy"][117].as_py()

    return expected


def processes(expected):
    pool = ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn"))
    killer = kill_after_first("processes", lambda: list(pool._processes))
    raises(BrokenProcessPool, tip.sweep, LIFT, executor=pool, directory="processes", chunk=10, **OPTIONS)
    killer.join()
    kept = {part: part.stat().st_mtime_ns for part in Path("processes").glob("part-*")}
    assert 0 < len(kept) < 30
    again = ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn"))
    runs = tip.sweep(LIFT, executor=again, directory="processes", chunk=10, **OPTIONS)
    assert tip.table_hash(runs) == expected
    assert all(part.stat().st_mtime_ns == then for part, then in kept.items()), "finished chunks are not run again"
    raises(ValueError, tip.sweep, LIFT, directory="processes", says="another sweep", **{**OPTIONS, "seed": 8})
    raises(ValueError, tip.sweep, LIFT, directory="processes", chunk=7, says="chunks of another size", **OPTIONS)
    print(f"2 processes, one killed after {len(kept)} of 30 chunks: equal")

    # A worker without the package says so.
    task = pickle.dumps(tip._sweep._write)
    worker = subprocess.run([sys.executable, "-I", "-S", "-c", "import pickle, sys; pickle.load(sys.stdin.buffer)"], input=task, capture_output=True)
    assert b"No module named 'tip_motion'" in worker.stderr, worker.stderr


def on_dask(expected):
    if not has("distributed"):
        return
    import dask
    from distributed import Client, LocalCluster

    dask.config.set({"distributed.scheduler.allowed-failures": 10})
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        killer = kill_after_first("dask", lambda: list(client.run(os.getpid).values()))
        runs = tip.sweep(LIFT, executor=client.get_executor(), directory="dask", chunk=10, **OPTIONS)
        killer.join()
        assert tip.table_hash(runs) == expected
    print("Dask, one of 2 workers killed: equal")


def on_ray(expected):
    if not has("ray"):
        return
    import ray

    class RayExecutor(concurrent.futures.Executor):
        def submit(self, function, *arguments, **options):
            return ray.remote(function).options(max_retries=5).remote(*arguments, **options).future()

    os.environ.setdefault("RAY_AUTH_MODE", "disabled")
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False, configure_logging=False)
    pid = ray.get(ray.remote(lambda: os.getpid()).remote())
    killer = kill_after_first("ray", lambda: [pid])
    runs = tip.sweep(LIFT, executor=RayExecutor(), directory="ray", chunk=10, **OPTIONS)
    killer.join()
    assert tip.table_hash(runs) == expected
    ray.shutdown()
    print("Ray, one worker killed: equal")


def command():
    """`tip sweep` writes the same rows; `tip view` takes a table of this package."""
    command = ["tip", "sweep", "walk.prg", "--vary", "STRIDE=160,200", "--vary", "friction=uniform(0.4,1)", "--repeat", "2", "--seed", "3", "-q", "-o", "-"]
    printed = subprocess.run(command, check=True, capture_output=True).stdout
    table = tip.sweep("walk.prg", vary={"STRIDE": [160, 200], "friction": tip.uniform(0.4, 1)}, repeat=2, seed=3)
    tip.save(table, "runs.csv")
    assert Path("runs.csv").read_bytes() == printed
    read = pyarrow.csv.read_csv("runs.csv")
    assert np.array_equal(read["forward [mm]"].to_numpy(), table["forward"].to_numpy())
    subprocess.run(["tip", "view", "runs.csv", "-q"], check=True)
    subprocess.run(["tip", "view", "runs.csv", "--case", "3", "-q"], check=True)
    saved = json.loads(Path("runs.sweep.json").read_text("utf-8"))
    assert [column["name"] for column in saved["columns"]] == table.column_names
    # Nothing but a file takes the table, and no table of another form is written.
    os.mkfifo("pipe.csv")
    Path("locked.csv").touch(0o444)
    for place, says in (("/dev/null", "must end in .csv"), ("pipe.csv", "pipe"), ("locked.csv", "read-only"), ("runs.tsv", "must end in .csv")):
        raises(ValueError, tip.save, table, place, says=says)
    assert stat.S_ISFIFO(os.stat("pipe.csv").st_mode) and stat.S_ISCHR(os.stat("/dev/null").st_mode)
    raises(ValueError, tip.save, table.drop_columns(["hash"]), "other.csv", says="other columns")
    raises(ValueError, tip.save, pyarrow.table({"a": [1]}), "other.csv", says="no specification")
    # No text is a number for pandas or Arrow.
    assert pyarrow.types.is_string(read["hash"].type) and pyarrow.types.is_string(read["check"].type)
    print("tip sweep: equal; tip view takes the table")


def robots():
    grasps = tip.sweep("grasp.prg", robot="hand", scene="scene.toml", vary={"scene.object.1.size.1": [96, 104], "scene.object.1.friction": [0.1, 0.8]}, until=9)
    lifted = grasps["object1_highest"].to_pylist()
    assert lifted[1] > 1 and lifted[3] > 1, lifted
    tripod = tip.sweep("tripod.prg", robot="hexapod.toml", vary={"robot.body.mass": [8, 16]}, plant="dynamic", until=1)
    torques = tripod["peak_torque"].to_pylist()
    assert torques[1] > torques[0]
    # A robot with numbers of its own takes memory only as long as it runs.
    document = tip.spec("tripod.prg", robot="hexapod.toml", vary={"robot.body.mass": tip.uniform(6, 10)}, repeat=20_000, cycles=1)
    peaks = []
    for first in range(0, 20_000, 1000):
        _native.run_chunk(document, first, 1000)
        peaks.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    assert peaks[-1] - peaks[1] < 8000, peaks
    print(f"20,000 different robots: {(peaks[-1] - peaks[1]) / 1000:.1f} MB more than 2,000")
    print(f"hand and described robot: lifted {np.round(lifted, 1)} mm, torques {np.round(torques, 2)} N·m")


def runs():
    run = tip.Run("walk.prg")
    run.set("STRIDE", 160)
    assert run.step(1000) and run.cycles == 1000
    assert run.joints.shape == (4, 3) and run.pose.shape == (6,)
    assert run.read("stride") == 160 and run.read("J11") == run.joints[0, 0]
    mark = run.snapshot()
    assert run.run_to_end() == "EXIT" and run.falls == 0
    travel, trace = run.travel, run.trace()
    assert abs(travel - 960) < 2, "six strides of 160 mm"
    run.restore(mark)
    assert run.cycles == 1000
    run.run_to_end()
    assert (run.travel, run.trace()) == (travel, trace)
    assert json.loads(trace.splitlines()[1])["set"] == {"STRIDE": 160.0}
    other = tip.Run("walk.prg")
    other.restore(mark)
    other.run_to_end()
    assert other.travel == travel, "another run of the program goes on from the mark"
    raises(ValueError, tip.Run(LIFT).restore, mark, says="another program")
    raises(ValueError, tip.Run("walk.prg", plant="dynamic").restore, mark, says="another plant")
    raises(ValueError, other.restore, None, says="a snapshot is needed")
    endless = "3.1\nt\nDEF_VAR A\nA = 0\nAGAIN:\nA += 1\nGOTO AGAIN:\nEND\n"
    for options, cycles in (({"until": 1.0}, 50), ({"cycles": 70}, 70)):
        run, steps = tip.Run(endless, **options), 0
        while run.step(10):
            steps += 1
            assert steps < 100, "it ends"
        assert run.cycles == cycles and run.end == "limit" and not run.step()
    run = tip.Run("walk.prg", trace=False)
    run.event("300:halt")
    run.run_to_end()
    assert run.travel < travel
    raises(ValueError, run.set, "N0", 1)
    raises(ValueError, run.event, "jump")
    raises(KeyError, run.read, "N0")
    raises(FileNotFoundError, tip.Run, "none.prg")
    raises(ValueError, tip.Run, "3.1\nt\nPTPP F1\nEND\n", says="PTPP")
    raises(IndexError, tip.Run, "walk.prg", case=1)
    raises(ValueError, tip.sweep, "walk.prg", vary={"STRID": [1]}, says="did you mean STRIDE?")
    raises(ValueError, tip.sweep, "walk.prg", vary={"STRIDE": []}, says="empty")
    # Each wrong argument is named.
    for says, options in (
        ("vary['SPEED']: a list of numbers", {"vary": {"SPEED": "200"}}),
        ("vary['SPEED'][1]: a finite number", {"vary": {"SPEED": [1, "2"]}}),
        ("vary['SPEED'][0]: a finite number is needed, not nan", {"vary": {"SPEED": [float("nan")]}}),
        ("vary['SPEED']: a finite number is needed, not inf", {"vary": {"SPEED": float("inf")}}),
        ("vary['SPEED']: uniform(…) or normal(…)", {"vary": {"SPEED": {"low": 1}}}),
        ("vary: a mapping", {"vary": ["SPEED"]}),
        ("seed: a whole number, 0 or more is needed, not -1", {"seed": -1}),
        ("seed: a whole number", {"seed": 2**64}),
        ("repeat: a whole number, 1 or more", {"repeat": 0}),
        ("repeat: a whole number", {"repeat": 1.5}),
        ("until: a finite number", {"until": "60"}),
        ("cycles: a whole number", {"cycles": -3}),
        ("plant: one of scene, quasi-static, dynamic", {"plant": "mass"}),
        ("sampling: one of random", {"sampling": "sobol"}),
        ("events: a text", {"events": 3}),
        ("record: a list of names", {"record": "SPEED"}),
        ("robot: a path", {"robot": 8}),
        ("chunk: a whole number, 1 or more", {"chunk": 0}),
    ):
        raises(ValueError, tip.sweep, "walk.prg", says=says, **options)
    raises(ValueError, tip.sweep, 5, says="program: a path")
    raises(ValueError, tip.uniform, 0, float("nan"), says="high: a finite number")
    raises(ValueError, tip.Run, "walk.prg", case=-1, says="case: a whole number")
    raises(ValueError, tip.Run("walk.prg").step, -1, says="cycles: a whole number")
    raises(ValueError, tip.Run("walk.prg").set, "STRIDE", float("nan"), says="STRIDE: a finite number")
    found = tip.check("3.1\nt\nPTPP F1\nEND\n")
    assert [(one.level, one.line) for one in found] == [("error", 3)] and found[0].code.startswith("E2"), found
    assert not tip.check("walk.prg")
    assert tip.check("3.1\nt\nPTPP F1\nEND\n", lang="ja")[0].reason != found[0].reason
    print("runs, checks and exceptions: as documented")


def falsifier():
    stand = "3.1\nStands\nSTAND_UP 60\nWAIT_INPOS ALL\nSLEEP 3000\nEND\n"
    off = dict.fromkeys(["tilt", "slip", "lost_travel", "least_margin"])

    def smallest(column, limit, quantity, bad, friction):
        # The smallest bad push and the next smaller good one are on both sides of the limit.
        vary = {"push.at": 3, "friction": friction}
        options = {"vary": vary, "plant": "dynamic", "until": 8}
        found = tip.falsify(stand, quantity, good=0, bad=bad, tolerance=10, limits={**off, column: limit}, **options)
        assert 0 < abs(found.value - found.good) <= 10 and abs(found.good) < abs(found.value), found
        rows = tip.sweep(stand, vary={**vary, quantity: [0, found.good, found.value]}, plant="dynamic", until=8)
        assert rows["hash"][2].as_py() == found.row["hash"], "the case can be repeated"
        start, good, bad = (rows["forward"] if column == "lost_travel" else rows[column]).to_pylist()
        if column == "lost_travel":
            good, bad = start - good, start - bad
        assert good >= limit > bad if column == "least_margin" else good <= limit < bad, (column, good, bad)
        return found

    # A floor that holds the feet, and one on which they slide. The robot falls on its side, rocks, or does not lift a foot.
    found = smallest("tilt", 60, "push.x", 1000, 3)
    assert found.row["falls"] > found.row["upright_falls"]
    rocks = smallest("tilt", 5, "push.x", 1000, 3)
    stays = smallest("least_margin", 50, "push.x", 1000, 3)
    assert stays.value < rocks.value < found.value
    smallest("slip", 100, "push.x", 1500, 0.3)
    smallest("lost_travel", 100, "push.y", -1500, 0.3)
    raises(ValueError, tip.falsify, stand, "push.x", good=0, bad=1, plant="dynamic", vary={"push.at": 3}, until=4, says="should be bad, but is good")
    raises(ValueError, tip.falsify, stand, "push.x", good=0, bad=1, limits={"tip": 1}, says="unknown limits")
    print(f"falsifier: {found}")


def environments():
    if not has("gymnasium"):
        return
    options = {"actions": {"SPEED": (20, 400)}, "observations": ["J11", "J12", "J13", "z"], "reward": "z", "cycles": 5, "until": 1.0}
    env = tip.VecEnv("steers.prg", 8, **options)
    observations, _ = env.reset(seed=1)
    assert observations.shape == env.observation_space.shape == (8, 4)
    ends = 0
    for _ in range(25):
        observations, rewards, terminated, truncated, infos = env.step(env.action_space.sample())
        ends += truncated.sum()
        assert observations.dtype == np.float32 and rewards.shape == (8,) and not terminated.any()
    assert ends == 16, "an episode is 50 cycles, which are 10 steps"
    final_observations(options)
    began, count = time.process_time(), 0
    env = tip.VecEnv("steers.prg", 64, **options)
    env.reset()
    while time.process_time() - began < 1:
        env.step(np.full((64, 1), 100.0))
        count += 64 * 5
    print(f"environments: {count} control cycles a CPU-second")
    if has("stable_baselines3"):
        sb3_environments(options)


def final_observations(options):
    """The last observations of episodes have the form of gymnasium's own environments, in whichever of them an episode ends."""
    ends = "3.1\nEnds when it is told to\nDEF_VAR GO\nGO = 0\nAGAIN:\nIF GO < 1 GOTO AGAIN:\nEND\n"
    for ended in ([], [1], [0, 1, 2]):
        env = tip.VecEnv(ends, 3, actions={"GO": (0, 1)}, observations=["J11", "z"], reward="z", cycles=5)
        env.reset()
        actions = np.zeros((3, 1))
        # The program assigns the variable in its first step.
        env.step(actions)
        actions[ended] = 1
        _, _, terminated, _, infos = env.step(actions)
        assert list(np.flatnonzero(terminated)) == ended
        if ended:
            final = infos["final_obs"]
            assert final.shape == (3,) and final.dtype == object
            assert all((final[one] is not None) == (one in ended) for one in range(3))
            assert all(final[one].shape == (2,) and final[one].dtype == np.float32 for one in ended)
    raises(ValueError, env.step, np.full((3, 1), np.nan), says="actions[0]: GO")
    raises(ValueError, env.reset, seed=-1, says="seed: a whole number")
    for says, changed in (
        ("num_envs: a whole number, 1 or more", {"num_envs": 0}),
        ("actions: a mapping", {"actions": {}}),
        ("actions['GO']: a pair", {"actions": {"GO": 1}}),
        ("actions['GO']: a lower bound", {"actions": {"GO": (1, 1)}}),
        ("observations: a list of names", {"observations": "z"}),
        ("reward: a name", {"reward": None}),
    ):
        right = {"num_envs": 2, "actions": {"GO": (0, 1)}, "observations": ["z"]}
        raises(ValueError, tip.VecEnv, ends, says=says, **{**right, **changed})
    # Any number of threads gives the same steps.
    few, many = (tip.VecEnv("steers.prg", count, **options) for count in (3, 40))
    few.reset(seed=2), many.reset(seed=2)
    for _ in range(3):
        one, two = few.step(np.full((3, 1), 90.0))[0], many.step(np.full((40, 1), 90.0))[0]
        assert np.array_equal(one, two[:3])


def sb3_environments(options):
    if not importlib.util.find_spec("torch"):
        # The package imports torch; the module of its VecEnv does not.
        folder = Path(importlib.util.find_spec("stable_baselines3").origin).parent
        names = ["stable_baselines3", "stable_baselines3.common", "stable_baselines3.common.vec_env"]
        found = importlib.util.spec_from_file_location(names[-1], folder / "common/vec_env/base_vec_env.py")
        sys.modules |= {name: types.ModuleType(name) for name in names[:-1]}
        sys.modules[names[-1]] = importlib.util.module_from_spec(found)
        found.loader.exec_module(sys.modules[names[-1]])
    from stable_baselines3.common.vec_env import VecEnv

    # A class that lacks one of the abstract methods cannot be instantiated.
    env = tip.sb3_vec_env("steers.prg", 4, **options)
    assert isinstance(env, VecEnv) and env.get_attr("num_envs") == [4] * 4 and env.env_is_wrapped(object) == [False] * 4
    env.seed(3)
    first = env.reset()
    assert first.shape == (4, 4) and first.dtype == np.float32
    for step in range(10):
        observations, rewards, dones, infos = env.step(np.full((4, 1), 100.0))
        assert observations.shape == (4, 4) and rewards.shape == dones.shape == (4,) and len(infos) == 4
        assert dones.all() == dones.any() == (step == 9), "an episode is 50 cycles, which are 10 steps"
    assert all(info["TimeLimit.truncated"] and info["terminal_observation"].shape == (4,) for info in infos)
    assert np.array_equal(observations, first), "the next episode begins in the same step"
    env.close()
    print("stable-baselines3: its VecEnv is complete")


def notebook():
    if not has("nbclient", "ipykernel", "optuna", "pandas"):
        return
    import nbformat
    from nbclient import NotebookClient

    book = nbformat.read("tune.ipynb", 4)
    NotebookClient(book, timeout=600).execute()
    assert any("text/html" in output.get("data", {}) for cell in book.cells for output in cell.get("outputs", []))
    print("notebook: runs, and shows the replay page")


if __name__ == "__main__":
    runs()
    expected = sweeps()
    for part in (processes, on_dask, on_ray):
        part(expected)
    for part in (command, robots, falsifier, environments, notebook):
        part()
