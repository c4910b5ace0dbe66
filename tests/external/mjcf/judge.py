"""Imports MJCF files with `tip robot import`, and compares feet and total mass with MuJoCo in random postures.

    judge.py TIP FILE [OPTION ...] [-- FILE [OPTION ...]] ...

Feet are calculated here from the numbers of the description. Exit status: 0 if all files agree or are refused with a reason.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

import mujoco
import numpy

POSTURES = 200
LIMIT = 1e-9  # m


def load(path):
    """The model without meshes, which need not be there, and with little mass where only meshes had some; and True if so."""
    spec = mujoco.MjSpec.from_file(str(path))
    lost = False
    for geom in list(spec.geoms):
        if geom.type in (mujoco.mjtGeom.mjGEOM_MESH, mujoco.mjtGeom.mjGEOM_HFIELD, mujoco.mjtGeom.mjGEOM_SDF) or geom.meshname:
            body = geom.parent
            spec.delete(geom)
            if not body.explicitinertial and all(rest.mass == 0 for rest in body.geoms):
                lost = True
                body.explicitinertial, body.mass, body.inertia = True, 1e-3, [1e-6, 1e-6, 1e-6]
    for assets in (spec.meshes, spec.hfields, spec.textures, spec.materials, spec.skins):
        for asset in list(assets):
            spec.delete(asset)
    for geom in spec.geoms:
        geom.material = ""
    for site in spec.sites:
        site.material = ""
    return spec.compile(), lost


def turn(axis, angle):
    """The matrix of a turn by Rodrigues' formula."""
    x, y, z = axis
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross


def foot(leg, angles):
    """The place of a foot of a description, mm."""
    at, frame = numpy.array(leg["base"], dtype=float), numpy.eye(3)
    for joint, angle in zip(leg["joint"], angles):
        frame = frame @ turn(joint["axis"], angle)
        at = at + frame @ joint["link"]
    return at


def names(text):
    """Of each leg its joints' names, the link at its end, and the place of the foot on that link, m."""
    for part in text.split("[[leg]] # ")[1:]:
        link, _, place = re.match(r"F\d: joint .+ to link (.+)", part)[1].partition("=")
        at = [float(word) for word in place.split(",")] if place else [0, 0, 0]
        yield re.findall(r"^    \{ axis = .*\}, # (.+)$", part, re.M), link, numpy.array(at)


def judge(tip, path, options):
    folder = pathlib.Path(tempfile.mkdtemp())
    described = folder / "robot.toml"
    imported = subprocess.run([tip, "robot", "import", path, "-o", described, *options], capture_output=True, text=True)
    if imported.returncode:
        return None, imported.stderr.strip().replace("\n", " ")
    text = described.read_text()
    robot = tomllib.loads(text)
    model, lost = load(path)
    data = mujoco.MjData(model)
    random = numpy.random.default_rng(1)
    legs = list(zip(robot["leg"], names(text)))
    base = model.body(int(model.jnt_bodyid[model.joint(legs[0][1][0][0]).id])).parentid[0]
    while model.body_jntnum[base] == 0 and model.body_parentid[base] != 0:
        base = model.body_parentid[base]
    apart = 0.0
    for posture in range(POSTURES):
        places = []
        for leg, (joints, link, at) in legs:
            angles = random.uniform(-3, 3, len(joints))
            for name, angle in zip(joints, angles):
                data.qpos[model.joint(name).qposadr[0]] = angle
            places.append(foot(leg, angles))
        mujoco.mj_kinematics(model, data)
        frame, origin = data.xmat[base].reshape(3, 3), data.xpos[base]
        theirs = []
        for _, (joints, link, at) in legs:
            body = data.body(body_of(model, link, joints))
            theirs.append(frame.T @ (body.xpos + body.xmat.reshape(3, 3) @ at - origin) * 1000)
        if posture == 0:
            # The turn of the robot frame is one of the 24 that keep the axes.
            axes = best_axes(places, theirs)
        apart = max(apart, max(numpy.linalg.norm(axes @ there - here) for here, there in zip(places, theirs)) / 1000)
    mass = sum(joint["mass"] for leg in robot["leg"] for joint in leg["joint"]) + robot.get("body", {}).get("mass", 0.0)
    # The base of a robot that is bolted down is no part of its description.
    first = (model.jnt_bodyid[model.joint(joints[0]).id] for _, (joints, _, _) in legs)
    total = model.body_subtreemass[base] if "body" in robot else sum(model.body_subtreemass[body] for body in first)
    falls = "the robot falls in its initial posture" in imported.stderr
    line = f"{len(legs)} legs of {len(legs[0][1][0])}, {POSTURES} postures, feet within {apart:.1e} m, {mass:.6g} kg of {total:.6g}"
    if "body" in robot:
        line += ", falls" if falls else ", stands"
    if lost:
        line += " (masses of meshes are not known)"
    return apart <= LIMIT, line


def body_of(model, link, joints):
    """The body at the end of a leg; one without a name is that of the last joint."""
    known = {model.body(index).name for index in range(model.nbody)}
    return link if link in known else int(model.jnt_bodyid[model.joint(joints[-1]).id])


def best_axes(ours, theirs):
    """The matrix of 0 and ±1 with determinant 1 that brings the second places to the first."""
    found = None
    for order in ([0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]):
        for signs in range(8):
            matrix = numpy.zeros((3, 3))
            for row, column in enumerate(order):
                matrix[row, column] = -1 if signs >> row & 1 else 1
            if numpy.linalg.det(matrix) > 0:
                apart = max(numpy.linalg.norm(matrix @ there - here) for here, there in zip(ours, theirs))
                if found is None or apart < found[0]:
                    found = apart, matrix
    return found[1]


def main():
    tip, *words = sys.argv[1:]
    failed = False
    cases, case = [], []
    for word in [*words, "--"]:
        if word == "--":
            cases.append(case)
            case = []
        else:
            case.append(word)
    for path, *options in filter(None, cases):
        agrees, line = judge(tip, path, options)
        failed |= agrees is False
        print(f"{path}: {'refused: ' if agrees is None else ''}{line}", flush=True)
    sys.exit(failed)


if __name__ == "__main__":
    main()
