"""Simulates in MuJoCo a walking robot that `tip robot export --mjcf` wrote, under a program of `tip run --plant exec:`.

Argument: the file. The JSON lines are those of docs/external-plant.md. Inside everything is in m, rad, N, N·m and s.
"""

import json
import math
import sys

import mujoco
import numpy as np

# The set point of a motor follows what is commanded as with `--plant dynamic`: with this lag (s), at this speed (rad/s) at most.
LAG, SPEED = 0.015, math.radians(360)

model = mujoco.MjModel.from_xml_path(sys.argv[1])
data = mujoco.MjData(model)
step = model.opt.timestep
joints = model.actuator_trnid[:, 0]
angles, rates = model.jnt_qposadr[joints], model.jnt_dofadr[joints]
stiffness, damping = model.actuator_gainprm[:, 0], -model.actuator_biasprm[:, 2]


def measured():
    """What the sensors read, in deg, N·m, N and mm."""
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, data.qpos[3:7])
    _, y_x, _, _, y_y, _, x_z, y_z, z_z = turn
    roll, pitch, yaw = math.atan2(-x_z, z_z), math.asin(max(-1, min(1, y_z))), math.atan2(-y_x, y_y)
    return {
        "angles": list(np.degrees(data.qpos[angles])),
        "torques": list(data.actuator_force),
        "loads": list(data.sensordata),
        "pose": [*(1000 * data.qpos[:3]), *np.degrees([roll, pitch, yaw])],
    }


for line in sys.stdin:
    request = json.loads(line)
    if request["type"] == "hello":
        mujoco.mj_resetDataKeyframe(model, data, model.key("initial").id)
        mujoco.mj_forward(model, data)
        target = setpoint = data.qpos[angles]
        print(json.dumps({"version": 2, **measured()}), flush=True)
    elif request["type"] == "cycle":
        is_torque = np.array(request["modes"]) == "torque"
        commanded = np.array(request["targets"])
        goal = np.where(is_torque, target, np.radians(commanded))
        for left in range(round(request["period"] / 1000 / step), 0, -1):
            target = target + (goal - target) / left
            turn = np.clip((target - setpoint) * (1 - math.exp(-step / LAG)), -SPEED * step, SPEED * step)
            setpoint = setpoint + turn
            # A motor gives stiffness · (control − angle) − damping · rate.
            servo = setpoint + damping / stiffness * turn / step
            torque = data.qpos[angles] + (commanded + damping * data.qvel[rates]) / stiffness
            data.ctrl[:] = np.where(is_torque, torque, servo)
            mujoco.mj_step(model, data)
        print(json.dumps({"n": request["n"], **measured()}), flush=True)
