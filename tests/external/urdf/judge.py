"""Compares forward kinematics and Jacobians of pinocchio, yourdfpy and MuJoCo with the poses beside each URDF and MJCF file.

The poses are in the robot frame: mm, x to the right, y forward. URDF has m, x forward, y left.
"""

import math
import pathlib
import sys

import mujoco
import numpy
import pinocchio
import yourdfpy

LIMIT = 1e-9  # of the robot's size
# From the robot frame to URDF's.
TURN = numpy.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def poses(path):
    """Values of the joints by name, places and axes of the links and Jacobians of the feet by name, pose by pose."""
    for block in path.read_text().strip().split("\n\n"):
        joints, links, jacobians = {}, {}, {}
        for line in block.splitlines():
            kind, name, *numbers = line.split()
            numbers = [float(number) for number in numbers]
            if kind == "joint":
                joints[name] = math.radians(numbers[0])
            elif kind == "slider":
                joints[name] = numbers[0] / 1000
            elif kind == "jacobian":
                jacobians[name] = TURN @ numpy.array(numbers).reshape(-1, 3).T / 1000
            else:
                place = TURN @ numpy.array(numbers[:3]) / 1000
                axes = numpy.array(numbers[3:]).reshape(-1, 3).T
                # A column is an axis; both the axes and what they are given in are turned.
                links[name] = place, TURN @ axes @ TURN.T if axes.size else None
        yield joints, links, jacobians


class Pinocchio:
    def __init__(self, path):
        self.model = pinocchio.buildModelFromUrdf(str(path))
        self.data = self.model.createData()

    def jacobian(self, foot, joints):
        frame, base = self.model.getFrameId(foot), self.of("base_link").matrix[:3, :3]
        aligned = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
        jacobian = pinocchio.computeFrameJacobian(self.model, self.data, self.configuration, frame, aligned)
        columns = [self.model.joints[self.model.getJointId(name)].idx_v for name in joints]
        # Of a single joint it is no matrix.
        return base.T @ jacobian.reshape(6, -1)[:3, columns]

    def place(self, joints):
        configuration = pinocchio.neutral(self.model)
        for name, value in joints.items():
            joint = self.model.joints[self.model.getJointId(name)]
            configuration[joint.idx_q] = value
        self.configuration = configuration
        pinocchio.framesForwardKinematics(self.model, self.data, configuration)
        base = self.of("base_link")
        return lambda link: base.inverse() @ self.of(link)

    def of(self, link):
        return Rigid(self.data.oMf[self.model.getFrameId(link)].homogeneous)


class Mujoco:
    """Its robot frame is that of the poses: x to the right, y forward."""

    def __init__(self, path):
        self.model = mujoco.MjModel.from_xml_path(str(path.with_suffix(".xml")))
        self.data = mujoco.MjData(self.model)

    def place(self, joints):
        for name, value in joints.items():
            self.data.qpos[self.model.joint(name).qposadr[0]] = value
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        base = self.of(self.data.body("base_link"))
        return lambda link: turned(base.inverse() @ self.of(self.named(link)))

    def named(self, link):
        return self.data.site(link) if link.startswith("F") else self.data.body(link)

    def of(self, thing):
        matrix = numpy.eye(4)
        matrix[:3, :3] = thing.xmat.reshape(3, 3)
        matrix[:3, 3] = thing.xpos
        return Rigid(matrix)

    def jacobian(self, foot, joints):
        moved = numpy.zeros((3, self.model.nv))
        mujoco.mj_jacSite(self.model, self.data, moved, None, self.model.site(foot).id)
        columns = [self.model.joint(name).dofadr[0] for name in joints]
        base = self.of(self.data.body("base_link")).matrix[:3, :3]
        return TURN @ base.T @ moved[:, columns]


class Yourdfpy:
    jacobian = None

    def __init__(self, path):
        self.robot = yourdfpy.URDF.load(str(path))

    def place(self, joints):
        self.robot.update_cfg(joints)
        return lambda link: Rigid(self.robot.get_transform(link, "base_link"))


class Rigid:
    def __init__(self, matrix):
        self.matrix = matrix

    def inverse(self):
        return Rigid(numpy.linalg.inv(self.matrix))

    def __matmul__(self, other):
        return Rigid(self.matrix @ other.matrix)


def turned(rigid):
    """A frame of the robot frame as URDF has it."""
    turn = numpy.eye(4)
    turn[:3, :3] = TURN
    return Rigid(turn @ rigid.matrix @ turn.T)


def judge(kind, path):
    """The greatest difference: of places and Jacobians in the robot's size, of axes as they are."""
    judged = kind(path)
    count, size, apart, axes_apart, moved = 0, 0.0, 0.0, 0.0, 0.0
    for joints, links, jacobians in poses(path.with_suffix(".poses")):
        offset = slider_offset(path, joints)
        place = judged.place({**joints, **offset})
        for link, (at, axes) in links.items():
            matrix = place(link).matrix
            size = max(size, float(numpy.linalg.norm(at)))
            apart = max(apart, float(numpy.linalg.norm(matrix[:3, 3] - at)))
            if axes is not None:
                axes_apart = max(axes_apart, float(numpy.abs(matrix[:3, :3] - axes).max()))
        for foot, wanted in jacobians.items() if judged.jacobian else ():
            names = [f"J{foot[1]}{joint}" for joint in range(1, wanted.shape[1] + 1)]
            moved = max(moved, float(numpy.abs(judged.jacobian(foot, names) - wanted).max()))
        count += 1
    return count, size, apart / size, axes_apart, moved / size


def slider_offset(path, joints):
    """The slider's joints are at 0 where it is at first; the poses say where it is in the robot frame."""
    named = {name: value for name, value in joints.items() if name.startswith("floor_")}
    if not named:
        return {}
    robot = Yourdfpy(path).robot
    at = robot.get_transform("floor", "base_link", collision_geometry=False)[:3, 3]
    at = TURN.T @ at
    return {name: value - at["xyz".index(name[-1])] for name, value in named.items()}


def main():
    failed = False
    for path in sorted(pathlib.Path(sys.argv[1]).glob("*.urdf")):
        for kind in (Pinocchio, Yourdfpy, Mujoco):
            count, size, apart, axes, moved = judge(kind, path)
            failed |= not (count == 1000 and max(apart, axes, moved) <= LIMIT)
            jacobians = f", Jacobians {moved:.1e} of it" if kind.jacobian else ""
            print(
                f"{path.stem}: {kind.__name__}: {count} poses, size {size:.3f} m, places {apart:.1e} of it, "
                f"axes {axes:.1e}{jacobians}"
            )
    sys.exit(failed)


if __name__ == "__main__":
    main()
