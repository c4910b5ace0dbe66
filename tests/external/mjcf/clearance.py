"""Compares the clearance of robots with that of MuJoCo: `mj_geomDistance` of the capsules of an exported model, in 10,000 postures.

    clearance.py TIP ROBOT ...

The pairs that are compared are chosen here from the rules of docs/robots.md. Exit status: 0 if all robots agree.
"""

import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

import mujoco
import numpy

CYCLES = 10_000
LIMIT = 1e-6  # mm
FAR = 10.0  # m


def program(model, legs, random):
    """Returns a program that sends all legs to random angles, again and again, within 80 % of their limits."""
    lines = ["3.1", "random postures"]
    for _ in range(CYCLES // 30):
        for leg, joints in enumerate(legs, 1):
            angles = []
            for joint in joints:
                low, high = numpy.degrees(joint.user[:2] if model.nuser_jnt and joint.user.any() else model.jnt_range[joint.id])
                middle, half = (low + high) / 2, 0.4 * (high - low)
                angles.append(f"{random.uniform(middle - half, middle + half):.3f}")
            lines.append(f"PTP_ANGLE F{leg} {' '.join(angles)}")
        lines.append("SLEEP 600")
    return "\n".join([*lines, "END", ""])


class Bodies:
    """The parts of a robot and the pairs that are compared."""

    def __init__(self, model, data, legs):
        self.model, self.data = model, data
        self.halved = {}
        self.parts = {f"link{n}{j}": (n, j) for n, leg in enumerate(legs, 1) for j, _ in enumerate(leg, 1)}
        has_body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, "body") >= 0
        mujoco.mj_resetDataKeyframe(model, data, 0)
        mujoco.mj_kinematics(model, data)
        self.pairs = []
        for (one, (n, j)), (other, (m, i)) in itertools.combinations(self.parts.items(), 2):
            neighbours = n == m and abs(j - i) == 1
            hips = j == i == 1
            if not neighbours and not hips and self.distance(one, other) >= 0:
                self.pairs.append((one, other))
        for one, (_, j) in self.parts.items():
            if has_body and j > 1 and self.distance(one, "body") >= 0:
                self.pairs.append((one, "body"))

    def geom(self, part):
        return self.model.geom("body" if part == "body" else f"{part}_capsule").id

    def distance(self, one, other):
        """Returns the distance of two parts, mm."""
        model, data = self.model, self.data
        first, second = self.geom(one), self.geom(other)
        if other == "body" and self.parts[one][1] == 2:
            # Of a second link only the half away from its joint is compared with the body.
            size, at = model.geom_size[first].copy(), data.geom_xpos[first].copy()
            along = data.geom_xmat[first].reshape(3, 3)[:, 2] * size[1] / 2
            joint = data.xpos[model.geom_bodyid[first]]
            away = along if along @ (at - joint) > 0 else -along
            model.geom_size[first][1] /= 2
            data.geom_xpos[first] += away
            found = mujoco.mj_geomDistance(model, data, first, second, FAR, None)
            model.geom_size[first], data.geom_xpos[first] = size, at
        else:
            found = mujoco.mj_geomDistance(model, data, first, second, FAR, None)
        return found * 1000


def judge(tip, robot):
    folder = pathlib.Path(tempfile.mkdtemp())
    exported = folder / "robot.xml"
    subprocess.run([tip, "robot", "export", "--robot", robot, "--mjcf", "-o", exported], check=True, capture_output=True)
    model = mujoco.MjModel.from_xml_path(str(exported))
    data = mujoco.MjData(model)
    legs = []
    for n in range(1, 10):
        joints = [model.joint(index) for index in range(model.njnt) if model.joint(index).name.startswith(f"J{n}")]
        if joints:
            legs.append(joints)
    bodies = Bodies(model, data, legs)
    random, records, trace = numpy.random.default_rng(1), [], folder / "t.jsonl"
    run = [tip, "run", folder / "p.prg", "--robot", robot, "--cycles", str(CYCLES), "--trace", trace, "--trace-motion", "--quiet"]
    # The weight of the robot may turn a joint beyond its limit, which ends a run.
    for _ in range(CYCLES):
        (folder / "p.prg").write_text(program(model, legs, random))
        subprocess.run(run, capture_output=True)
        lines = [json.loads(line) for line in trace.read_text().splitlines()]
        records.extend(record for record in lines if "clearance" in record)
        if len(records) >= CYCLES:
            break
    del records[CYCLES:]
    apart, nearer, overlaps, chosen = 0.0, 0.0, 0, set()
    for record in records:
        for joints, angles in zip(legs, record["angles"]):
            for joint, angle in zip(joints, angles):
                data.qpos[joint.qposadr[0]] = numpy.radians(angle)
        mujoco.mj_kinematics(model, data)
        ours, nearest = record["clearance"], record["nearest"]
        pair = tuple(nearest) if tuple(nearest) in bodies.pairs else tuple(reversed(nearest))
        if pair not in bodies.pairs:
            return f"{robot}: {pair} are not to be compared", False
        theirs = {pair: bodies.distance(*pair) for pair in bodies.pairs}
        chosen.add(pair)
        overlaps += ours < 0
        radius = model.geom_size[bodies.geom(pair[0])][0] * 1000
        # We take a line inside the box as on its surface; MuJoCo reports its depth, so that the distances differ.
        inside = "body" in pair and ours <= LIMIT - radius
        if not inside:
            apart = max(apart, abs(theirs[pair] - ours))
        least = min(distance for other, distance in theirs.items() if not inside or "body" not in other)
        if not inside:
            nearer = max(nearer, ours - least)
    count = f"{len(records)} postures, {overlaps} with an overlap, {len(bodies.pairs)} pairs, {len(chosen)} of them nearest once"
    good = len(records) == CYCLES and apart <= LIMIT and nearer <= LIMIT
    return f"{robot}: {count}; apart by {apart:.1e} mm, others nearer by {nearer:.1e} mm", good


def main():
    tip, *robots = sys.argv[1:]
    all_good = True
    for robot in robots:
        line, good = judge(tip, robot)
        print(line, "" if good else "-- WRONG", flush=True)
        all_good &= good
    sys.exit(not all_good)


if __name__ == "__main__":
    main()
