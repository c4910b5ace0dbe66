"""Compares forward kinematics of pinocchio and yourdfpy with the poses beside each URDF file.

The poses are in the robot frame: mm, x to the right, y forward. URDF has m, x forward, y left.
"""

import math
import pathlib
import sys

import numpy
import pinocchio
import yourdfpy

LIMIT = 1e-9  # of the robot's size
# From the robot frame to URDF's.
TURN = numpy.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def poses(path):
    """Values of the joints by name, and places and axes of the links by name, pose by pose."""
    for block in path.read_text().strip().split("\n\n"):
        joints, links = {}, {}
        for line in block.splitlines():
            kind, name, *numbers = line.split()
            numbers = [float(number) for number in numbers]
            if kind == "joint":
                joints[name] = math.radians(numbers[0])
            elif kind == "slider":
                joints[name] = numbers[0] / 1000
            else:
                place = TURN @ numpy.array(numbers[:3]) / 1000
                axes = numpy.array(numbers[3:]).reshape(-1, 3).T
                # A column is an axis; both the axes and what they are given in are turned.
                links[name] = place, TURN @ axes @ TURN.T if axes.size else None
        yield joints, links


class Pinocchio:
    def __init__(self, path):
        self.model = pinocchio.buildModelFromUrdf(str(path))
        self.data = self.model.createData()

    def place(self, joints):
        configuration = pinocchio.neutral(self.model)
        for name, value in joints.items():
            joint = self.model.joints[self.model.getJointId(name)]
            configuration[joint.idx_q] = value
        pinocchio.framesForwardKinematics(self.model, self.data, configuration)
        base = self.of("base_link")
        return lambda link: base.inverse() @ self.of(link)

    def of(self, link):
        return Rigid(self.data.oMf[self.model.getFrameId(link)].homogeneous)


class Yourdfpy:
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


def judge(kind, path):
    """The greatest difference, against the robot's size: of places in the robot's size, of axes as they are."""
    judged = kind(path)
    count, size, apart, turned = 0, 0.0, 0.0, 0.0
    for joints, links in poses(path.with_suffix(".poses")):
        offset = slider_offset(path, joints)
        place = judged.place({**joints, **offset})
        for link, (at, axes) in links.items():
            matrix = place(link).matrix
            size = max(size, float(numpy.linalg.norm(at)))
            apart = max(apart, float(numpy.linalg.norm(matrix[:3, 3] - at)))
            if axes is not None:
                turned = max(turned, float(numpy.abs(matrix[:3, :3] - axes).max()))
        count += 1
    return count, size, apart / size, turned


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
        for kind in (Pinocchio, Yourdfpy):
            count, size, apart, turned = judge(kind, path)
            worst = max(apart, turned)
            failed |= not (count == 1000 and worst <= LIMIT)
            print(f"{path.stem}: {kind.__name__}: {count} poses, size {size:.3f} m, places {apart:.1e} of it, axes {turned:.1e}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
