"""Walking robots and their surroundings as MuJoCo models."""

import math
from dataclasses import dataclass

import mujoco
import numpy as np

STEP = 0.0005
GRAVITY = 9.80665
# For each N·m of a motor: stiffness, damping, rotor, friction; and the lag (s) and speed (rad/s) of its set point.
STIFFNESS, DAMPING, ROTOR, RUB = 200, 3, 7.5e-4, 2.5e-3
LAG, SPEED = 0.015, math.radians(360)


@dataclass
class Robot:
    """In m, kg, N·m, s: hips, links of (axis, length, mass), and a body whose box has these lower and upper corners."""

    hips: list
    links: list
    torque: float
    low: tuple
    high: tuple
    mass: float
    period: float
    height: float

    def weight(self):
        return GRAVITY * (self.mass + len(self.hips) * sum(mass for _, _, mass in self.links))


AXES = [(0, 0, 1), (0, -1, 0), (0, 1, 0)]
TITAN = Robot(
    [(-0.101, 0.201), (0.101, 0.201), (-0.101, -0.201), (0.101, -0.201)],
    list(zip(AXES, (0.05, 0.24, 0.2), (0.8, 0.8, 0.4))),
    40, (-0.12, -0.23, -0.2), (0.12, 0.23, 0.05), 12, 0.02, 0.2,
)
HEXAPOD = Robot(
    [(-0.12, 0.26), (0.12, 0.26), (-0.16, 0), (0.16, 0), (-0.12, -0.26), (0.12, -0.26)],
    list(zip(AXES, (0.05, 0.12, 0.14), (0.3, 0.3, 0.2))),
    15, (-0.12, -0.29, -0.14), (0.12, 0.29, 0.04), 8, 0.01, 0.14,
)


def leg(robot, number, hip):
    """A chain of rods; what is mirrored is turned about the other way."""
    text, close = "", ""
    side = math.copysign(1, hip[0])
    at = f"{hip[0]} {hip[1]} 0"
    for joint, (axis, length, mass) in enumerate(robot.links):
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


def box(low, high, more):
    size = " ".join(str((b - a) / 2) for a, b in zip(low, high))
    middle = " ".join(str((a + b) / 2) for a, b in zip(low, high))
    return f'<geom type="box" size="{size}" pos="{middle}" {more}/>'


def normal(scene):
    """Up from the floor."""
    x, y = scene.get("floor", {}).get("slope", (0, 0))
    return np.array([-x, -y, 1]) / math.hypot(x, y, 1)


def model(robot, scene, stiffer=1.0):
    floor = scene.get("floor", {})
    up = normal(scene)
    x, y, z = (b - a for a, b in zip(robot.low, robot.high))
    inertia = " ".join(str(robot.mass / 12 * sum(pair)) for pair in ((y * y, z * z), (x * x, z * z), (x * x, y * y)))
    blocks = "".join(
        box([b["x"][0] / 1e3, b["y"][0] / 1e3, -1], [b["x"][1] / 1e3, b["y"][1] / 1e3, b["height"] / 1e3],
            'contype="2" conaffinity="1"')
        for b in scene.get("block", [])
    )
    torque = robot.torque
    servos = "".join(
        f'<position joint="j{leg}{joint}" kp="{STIFFNESS * torque * stiffer}" kv="{DAMPING * torque * stiffer}" '
        f'forcerange="{-torque} {torque}"/>'
        for leg in range(len(robot.hips))
        for joint in range(len(robot.links))
    )
    start = " ".join(map(str, up * robot.height))
    return mujoco.MjModel.from_xml_string(f"""
<mujoco>
  <compiler angle="radian"/>
  <option timestep="{STEP}" integrator="implicitfast" cone="elliptic" gravity="0 0 {-GRAVITY}" impratio="10"/>
  <default><joint armature="{ROTOR * torque}" damping="{RUB * torque}"/>
    <geom friction="{floor.get('friction', 0.5)} 0 0" condim="3" solref="0.004 1" contype="1" conaffinity="2"/></default>
  <worldbody>
    <geom type="plane" size="9 9 1" contype="2" conaffinity="1" zaxis="{up[0]} {up[1]} {up[2]}"/>
    {blocks}
    <body name="trunk" pos="{start}"><freejoint/>
      <inertial pos="0 0 0" mass="{robot.mass}" diaginertia="{inertia}"/>
      {box(robot.low, robot.high, 'mass="0"')}
      {"".join(leg(robot, number, hip) for number, hip in enumerate(robot.hips))}
    </body>
  </worldbody>
  <actuator>{servos}</actuator>
</mujoco>""")
