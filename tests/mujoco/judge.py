"""Has MuJoCo run the joint commands of TITAN VIII's runs, and prints what it and both plants make of them.

Argument: a folder with NAME.quasi-static.csv and NAME.dynamic.csv, as the example `joints` of tip-sim writes them.
"""

import math
import pathlib
import sys

import mujoco
import numpy as np

FRICTION = 0.9
STEP = 0.0005
LAG, SPEED = 0.015, math.radians(360)
PERIOD = 0.02
WEIGHT = 20 * 9.80665
JOINTS = [((0, 0, 1), 0.05, 0.8), ((0, -1, 0), 0.24, 0.8), ((0, 1, 0), 0.2, 0.4)]


def leg(number, side, end):
    """A chain of rods; what is mirrored is turned about the other way."""
    text, close = "", ""
    at = f"{0.101 * side} {0.201 * end} 0"
    for joint, (axis, length, mass) in enumerate(JOINTS):
        axis = " ".join(str(side * part) for part in axis)
        own = mass * length**2 / 12
        text += (
            f'<body pos="{at}"><joint name="j{number}{joint}" axis="{axis}"/>'
            f'<inertial pos="{side * length / 2} 0 0" mass="{mass}" diaginertia="1e-7 {own} {own}"/>'
        )
        close += "</body>"
        at = f"{side * length} 0 0"
    foot = f'<geom name="f{number}" type="sphere" size="0.001" pos="{at}" mass="0"/>'
    return text + foot + close


def model(stiffer=1.0):
    legs = [(-1, 1), (1, 1), (-1, -1), (1, -1)]
    servos = "".join(
        f'<position joint="j{leg}{joint}" kp="{8000 * stiffer}" kv="{120 * stiffer}" forcerange="-40 40"/>'
        for leg in range(4)
        for joint in range(3)
    )
    box = [12 / 12 * (a * a + b * b) for a, b in ((0.46, 0.25), (0.24, 0.25), (0.24, 0.46))]
    return mujoco.MjModel.from_xml_string(f"""
<mujoco>
  <compiler angle="radian"/>
  <option timestep="{STEP}" integrator="implicitfast" cone="elliptic" gravity="0 0 -9.80665" impratio="10"/>
  <default><joint armature="0.03" damping="0.1"/>
    <geom friction="{FRICTION} 0 0" condim="3" solref="0.004 1" contype="1" conaffinity="2"/></default>
  <worldbody>
    <geom type="plane" size="9 9 1" contype="2" conaffinity="1"/>
    <body pos="0 0 0.2"><freejoint/>
      <inertial pos="0 0 0" mass="12" diaginertia="{box[0]} {box[1]} {box[2]}"/>
      <geom type="box" size="0.12 0.23 0.125" pos="0 0 -0.075" mass="0"/>
      {"".join(leg(number, *corner) for number, corner in enumerate(legs))}
    </body>
  </worldbody>
  <actuator>{servos}</actuator>
</mujoco>""")


def simulate(commands, stiffer=1.0):
    """What MuJoCo makes of joint commands: poses, loads and slip, a row for each cycle."""
    own = model(stiffer)
    data = mujoco.MjData(own)
    feet = [own.geom(f"f{number}").id for number in range(4)]
    data.qpos[7:] = np.radians([0, 0, 90] * 4)
    target = data.qpos[7:].copy()
    setpoint = target.copy()
    steps = round(PERIOD / STEP)
    share = 1 - math.exp(-STEP / LAG)
    touchdown, slip, rows = [None] * 4, 0.0, []
    force = np.zeros(6)
    for command in np.radians(commands):
        for left in range(steps, 0, -1):
            target = target + (command - target) / left
            turn = np.clip((target - setpoint) * share, -SPEED * STEP, SPEED * STEP)
            setpoint = setpoint + turn
            # A servo that knows the rate of its set point: kp (s − q) + kv (ṡ − q̇).
            data.ctrl[:] = setpoint + 120 / 8000 * turn / STEP
            mujoco.mj_step(own, data)
            loads = np.zeros(4)
            for number, contact in enumerate(data.contact[: data.ncon]):
                for place, foot in enumerate(feet):
                    if foot in (contact.geom1, contact.geom2):
                        mujoco.mj_contactForce(own, data, number, force)
                        loads[place] += force[0]
            for place, foot in enumerate(feet):
                if loads[place] > 0:
                    at = data.geom_xpos[foot][:2].copy()
                    if touchdown[place] is None:
                        touchdown[place] = at
                    slip = max(slip, 1000 * np.linalg.norm(at - touchdown[place]))
                else:
                    touchdown[place] = None
        matrix = np.zeros(9)
        mujoco.mju_quat2Mat(matrix, data.qpos[3:7])
        matrix = matrix.reshape(3, 3)
        roll = math.degrees(math.atan2(-matrix[2, 0], matrix[2, 2]))
        pitch = math.degrees(math.asin(max(-1, min(1, matrix[2, 1]))))
        yaw = math.degrees(math.atan2(-matrix[0, 1], matrix[1, 1]))
        rows.append([*(1000 * data.qpos[:3]), roll, pitch, yaw, *loads, slip])
    return np.array(rows)


def figures(rows):
    """Travel (mm), greatest lean (deg) and slip (mm)."""
    travel = np.linalg.norm(rows[-1, :2] - rows[0, :2])
    return travel, np.abs(rows[:, 3:5]).max(), rows[-1, 10]


def apart(rows, others):
    """The loads of feet: RMS of the difference in parts of the weight, in means over 0.1 s."""
    mean = lambda loads: loads[: len(loads) // 5 * 5].reshape(-1, 5, 4).mean(axis=1)
    difference = mean(rows[:, 6:10]) - mean(others[:, 6:10])
    return math.sqrt((difference**2).mean()) / WEIGHT


def main():
    print("| run | what | travel, mm | lean, deg | slip, mm | loads apart, RMS |")
    print("|---|---|---:|---:|---:|---:|")
    for path in sorted(pathlib.Path(sys.argv[1]).glob("*.dynamic.csv")):
        name = path.name.split(".")[0]
        for plant in ("quasi-static", "dynamic"):
            ours = np.loadtxt(path.with_name(f"{name}.{plant}.csv"), delimiter=",")
            commands, rows = ours[:, :12], ours[:, 12:]
            judge = simulate(commands)
            stiff = simulate(commands, 2.0)
            for who, what in ((plant, rows), ("MuJoCo", judge), ("MuJoCo, servos twice as stiff", stiff)):
                travel, lean, slip = figures(what)
                print(f"| {name} | {who} | {travel:.0f} | {lean:.2f} | {slip:.1f} | {100 * apart(what, judge):.1f} % |")
            sys.stdout.flush()


main()
