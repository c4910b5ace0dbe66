"""Has MuJoCo run the joint commands of walking robots, and prints what it and both plants make of them.

Argument: a folder with NAME.prg, and NAME.PLANT.csv and NAME.PLANT.toml for each plant: the rows that the example `joints`
of tip-sim writes, and the scene. Names that begin with `tripod` are the hexapod's, all others TITAN VIII's.
"""

import math
import pathlib
import re
import sys
import tomllib

import mujoco
import numpy as np

from robots import DAMPING, HEXAPOD, LAG, SPEED, STEP, STIFFNESS, TITAN, model, normal

# A foot that leaves the ground for less has bounced, not stepped: s.
BOUNCE = 0.02
# Dynamic and MuJoCo may differ by so much, wherever MuJoCo differs from itself by less when its servos are twice as stiff.
LIMITS = "travel 5 %, lean 1 deg, slip 5 mm or 20 %, loads 5 % RMS"


def pushes(program):
    """Cycles, and the force (N) on the body in each."""
    found = {}
    for first, force, cycles in re.findall(r"^// events: *(\d+):push ([-\d. ]+) for (\d+)", program, re.M):
        for cycle in range(int(first), int(first) + int(cycles)):
            found[cycle] = [float(part) for part in force.split()]
    return found


def simulate(robot, scene, commands, pushed, stiffer=1.0):
    """What MuJoCo makes of joint commands: poses, loads and slip, a row for each cycle."""
    own = model(robot, scene, stiffer)
    data = mujoco.MjData(own)
    count = len(robot.hips)
    feet = [own.geom(f"f{number}").id for number in range(count)]
    trunk = own.body("trunk").id
    mujoco.mju_quatZ2Vec(data.qpos[3:7], normal(scene))
    data.qpos[7:] = np.radians([0, 0, 90] * count)
    target = data.qpos[7:].copy()
    setpoint = target.copy()
    steps = round(robot.period / STEP)
    share = 1 - math.exp(-STEP / LAG)
    touchdown, left_for, slip, rows = [None] * count, [1.0] * count, 0.0, []
    force = np.zeros(6)
    for cycle, command in enumerate(np.radians(commands)):
        data.xfrc_applied[trunk, :3] = pushed.get(cycle, [0, 0, 0])
        for left in range(steps, 0, -1):
            target = target + (command - target) / left
            turn = np.clip((target - setpoint) * share, -SPEED * STEP, SPEED * STEP)
            setpoint = setpoint + turn
            # A servo that knows the rate of its set point: kp (s − q) + kv (ṡ − q̇).
            data.ctrl[:] = setpoint + DAMPING / STIFFNESS * turn / STEP
            mujoco.mj_step(own, data)
            loads = np.zeros(count)
            for number, contact in enumerate(data.contact[: data.ncon]):
                for place, foot in enumerate(feet):
                    if foot in (contact.geom1, contact.geom2):
                        mujoco.mj_contactForce(own, data, number, force)
                        loads[place] += force[0]
            for place, foot in enumerate(feet):
                if loads[place] > 0:
                    at = data.geom_xpos[foot].copy()
                    if touchdown[place] is None:
                        touchdown[place] = at
                    left_for[place] = 0.0
                    slip = max(slip, 1000 * np.linalg.norm(at - touchdown[place]))
                else:
                    left_for[place] += STEP
                    if left_for[place] > BOUNCE:
                        touchdown[place] = None
        matrix = np.zeros(9)
        mujoco.mju_quat2Mat(matrix, data.qpos[3:7])
        matrix = matrix.reshape(3, 3)
        roll = math.degrees(math.atan2(-matrix[2, 0], matrix[2, 2]))
        pitch = math.degrees(math.asin(max(-1, min(1, matrix[2, 1]))))
        yaw = math.degrees(math.atan2(-matrix[0, 1], matrix[1, 1]))
        rows.append([*(1000 * data.qpos[:3]), roll, pitch, yaw, *loads, slip])
    return np.array(rows)


def apart(robot, rows, others):
    """The loads of feet: RMS of the difference in parts of the weight, in means over 0.1 s."""
    count, span = len(robot.hips), round(0.1 / robot.period)
    mean = lambda loads: loads[: len(loads) // span * span].reshape(-1, span, count).mean(axis=1)
    # What waits for feet may take a cycle more on one plant than on the other.
    length = min(len(rows), len(others))
    difference = mean(rows[:length, 6:-1]) - mean(others[:length, 6:-1])
    return math.sqrt((difference**2).mean()) / robot.weight()


def figures(robot, rows, judge):
    """Travel (mm), greatest lean from the first (deg), slip (mm), and how far loads are from the judge's (%)."""
    travel = np.linalg.norm(rows[-1, :2] - rows[0, :2])
    lean = np.abs(rows[:, 3:5] - rows[0, 3:5]).max()
    return np.array([travel, lean, rows[-1, -1], 100 * apart(robot, rows, judge)])


def verdict(ours, judge, stiff):
    """What misses its limit although MuJoCo knows its own answer better than that."""
    limits = np.array([0.05 * judge[0], 1, max(5, 0.2 * judge[2]), 5])
    off, own = np.abs(ours - judge), np.abs(stiff - judge)
    names = ("travel", "lean", "slip", "loads")
    missed = [name for name, off, own, limit in zip(names, off, own, limits) if off > limit >= own]
    open_ = [name for name, off, own, limit in zip(names, off, own, limits) if off > limit < own]
    words = [f"**{', '.join(missed)}**"] * bool(missed) + [f"MuJoCo is not sure: {', '.join(open_)}"] * bool(open_)
    return "; ".join(words) or "all"


def main():
    folder = pathlib.Path(sys.argv[1])
    missed = []
    print(f"Within the limits: {LIMITS}; where MuJoCo's own answer moves by less when its servos are twice as stiff.\n")
    print("| run | what | travel, mm | lean, deg | slip, mm | loads apart, RMS | within |")
    print("|---|---|---:|---:|---:|---:|---|")
    for program in sorted(folder.glob("*.prg")):
        name = program.stem
        robot = HEXAPOD if name.startswith("tripod") else TITAN
        pushed = pushes(program.read_text())
        joints = 3 * len(robot.hips)
        ours = {}
        for plant in ("quasi-static", "dynamic"):
            path = folder / f"{name}.{plant}.csv"
            if path.exists():
                ours[plant] = np.loadtxt(path, delimiter=",")
        scene = tomllib.loads((folder / f"{name}.dynamic.toml").read_text())
        commands = ours["dynamic"][:, :joints]
        judge = simulate(robot, scene, commands, pushed)
        stiff = simulate(robot, scene, commands, pushed, 2.0)
        known, moved = figures(robot, judge, judge), figures(robot, stiff, judge)
        rows = [("MuJoCo", known, ""), ("MuJoCo, servos twice as stiff", moved, "")]
        for plant, row in ours.items():
            own = figures(robot, row[:, joints:], judge)
            rows.append((plant, own, verdict(own, known, moved) if plant == "dynamic" else ""))
        for who, (travel, lean, slip, loads), word in rows:
            missed += [name] * word.startswith("**")
            print(f"| {name} | {who} | {travel:.0f} | {lean:.2f} | {slip:.1f} | {loads:.1f} % | {word} |")
        sys.stdout.flush()
    if missed:
        sys.exit(f"beyond a limit: {', '.join(missed)}")


main()
