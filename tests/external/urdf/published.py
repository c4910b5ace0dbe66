"""Imports each published URDF file, exports what comes of it, and compares both in pinocchio: places of feet, their Jacobians, the
mass matrix of the legs where the file's inertias are kept, and collision shapes other than meshes."""

import pathlib
import re
import subprocess
import sys
import tempfile

import numpy
import pinocchio

import shapes

LIMIT = 1e-9  # of the robot's size; of a mass matrix's greatest element
POSES = 1000
# A PhantomX's tibias end 133 mm below their joints; a fingertip of Barrett's hand is the last of its boxes.
PHANTOMX = ",".join(f"tibia_{leg}=0.133,0,0" for leg in ("LF", "RF", "LM", "RM", "LR", "RR"))
BARRETT = "finger_1_dist_link=-0.038,0.034,0,finger_2_dist_link=-0.038,0.034,0"
# Each file: the options of its import, and what a refusal says.
FILES = {
    "a1": ([], None),
    "go1": ([], None),
    "go2": (["--foot", "FL_foot,FR_foot,RL_foot,RR_foot"], None),
    "anymal_c": (["--order", "LF,RF,LH,RH"], None),
    "solo12": ([], None),
    "spotmicro": ([], None),
    "trifinger_edu": (["--order", "0,120,240"], None),
    "trifinger_pro": (["--order", "0,120,240"], None),
    "dclaw": ([], None),
    "leap": ([], None),
    "allegro": ([], None),
    "phantomx": (["--skip", "head_pan", "--foot", PHANTOMX, "--order", "LF,RF,LM,RM,LR,RR"], None),
    "barrett": (["--skip", "finger_3_med_joint", "--foot", BARRETT], None),
}


class Robot:
    def __init__(self, path):
        self.model = pinocchio.buildModelFromUrdf(str(path))
        self.data = self.model.createData()
        self.shapes = shapes.Shapes(path, self.model)

    def base(self, name):
        return self.data.oMf[self.model.getFrameId(name)]

    def joint(self, name):
        joint = self.model.joints[self.model.getJointId(name)]
        return joint.idx_q, joint.nq, joint.idx_v

    def pose(self, angles):
        """Angles by name; a joint that turns without limit has cosine and sine."""
        configuration = pinocchio.neutral(self.model)
        for name, angle in angles.items():
            at, size, _ = self.joint(name)
            configuration[at : at + size] = [angle] if size == 1 else [numpy.cos(angle), numpy.sin(angle)]
        self.configuration = configuration
        pinocchio.computeJointJacobians(self.model, self.data, configuration)
        pinocchio.updateFramePlacements(self.model, self.data)

    def mass(self, joints):
        """How hard joints are to turn, one by the other; the base does not move."""
        matrix = pinocchio.crba(self.model, self.data, self.configuration)
        matrix = numpy.triu(matrix) + numpy.triu(matrix, 1).T
        rows = [self.joint(name)[2] for name in joints]
        return matrix[numpy.ix_(rows, rows)]

    def foot(self, end, base, joints):
        """Where a link or a place on it is, and how it moves with each joint, in the frame of the base."""
        link, _, place = end.partition("=")
        frame = self.model.getFrameId(link)
        at = [float(part) for part in place.split(",")] if place else [0, 0, 0]
        base = self.base(base)
        columns = [self.joint(name)[2] for name in joints]
        aligned = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
        jacobian = pinocchio.getFrameJacobian(self.model, self.data, frame, aligned)[:, columns]
        # What turns with the link goes round its frame.
        arm = self.data.oMf[frame].rotation @ at
        moves = jacobian[:3] + numpy.cross(jacobian[3:], arm, axis=0)
        place = base.actInv(self.data.oMf[frame]).act(numpy.array(at, dtype=float))
        return place, base.rotation.T @ moves


def legs(toml):
    """Of each leg its joints' names and the link at its end, from the comments of a description."""
    for part in toml.split("[[leg]] # ")[1:]:
        end = re.match(r"F\d: joint .+ to link (.+)", part)[1]
        yield re.findall(r"^    \{ axis = .*\}, # (.+)$", part, re.M), end


def bases(path):
    """The link that is the robot frame: the first one, or the one that is fixed to `world`."""
    model = pinocchio.buildModelFromUrdf(str(path))
    frames = [frame.name for frame in model.frames if frame.type == pinocchio.FrameType.BODY]
    return frames[1] if frames[0] == "world" else frames[0]


def counterparts(ours, theirs, base, joints):
    """Shapes that stand for each other, by the joints that carry them; a link of which the file gives none is drawn as we like."""
    found = []
    for our_joint, their_joint in joints.items():
        given = theirs.shapes.of.get(their_joint)
        if given:
            kept = ours.shapes.of.get(our_joint, [])
            place = lambda shape: shape.place(ours.data, ours.base("base_link"))
            at = lambda shape: shape.place(theirs.data, theirs.base(base))
            pairs = shapes.pairs(kept, given, place, at)
            if pairs is None:
                sys.exit(f"{their_joint} has {len(given)} shapes, {our_joint} has {len(kept)}, or others")
            found += pairs
    return found


def compare(source, exported, described):
    theirs, ours = Robot(source), Robot(exported)
    base = bases(source)
    random = numpy.random.default_rng(1)
    size, apart, moved, most, heavier = 0.0, 0.0, 0.0, 0.0, 0.0
    legs_of = list(legs(described))
    carried = {f"J{n}{i}": name for n, (joints, _) in enumerate(legs_of, 1) for i, name in enumerate(joints, 1)}
    if "\n[body]\n" in described:
        carried["universe"] = "universe"
    kept, shifted, turned = None, 0.0, 0.0
    for _ in range(POSES):
        here, there = {}, {}
        for number, (joints, _) in enumerate(legs_of, 1):
            for index, name in enumerate(joints, 1):
                here[f"J{number}{index}"] = there[name] = random.uniform(-3, 3)
        ours.pose(here)
        theirs.pose(there)
        if kept is None:
            kept = counterparts(ours, theirs, base, carried)
            sizes = max((numpy.abs(our.sizes - their.sizes).max() for our, their in kept), default=0.0)
        for our, their in kept:
            place, at = our.place(ours.data, ours.base("base_link")), their.place(theirs.data, theirs.base(base))
            shift, turn = shapes.apart(place, at)
            shifted, turned = max(shifted, shift), max(turned, turn)
        for number, (joints, end) in enumerate(legs_of, 1):
            names = [f"J{number}{index}" for index in range(1, len(joints) + 1)]
            place, columns = ours.foot(f"F{number}", "base_link", names)
            at, wanted = theirs.foot(end, base, joints)
            size = max(size, numpy.linalg.norm(at))
            apart = max(apart, numpy.linalg.norm(place - at))
            moved = max(moved, numpy.abs(columns - wanted).max())
            mass = theirs.mass(joints)
            most = max(most, mass.max())
            heavier = max(heavier, numpy.abs(ours.mass(names) - mass).max())
    shaped = len(kept), max(shifted, sizes) / size, turned
    return len(legs_of), size, apart / size, moved / size, heavier / most, shaped


def main():
    tip, files = sys.argv[1], pathlib.Path(sys.argv[2])
    folder = pathlib.Path(tempfile.mkdtemp())
    failed = False
    for name, (options, refusal) in FILES.items():
        source = files / f"{name}.urdf"
        if not source.exists():
            print(f"{name}: no such file")
            continue
        described, exported = folder / f"{name}.toml", folder / f"{name}.urdf"
        imported = subprocess.run(
            [tip, "robot", "import", source, "-o", described, *options], capture_output=True, text=True
        )
        if refusal or imported.returncode:
            holds = bool(refusal) and refusal in imported.stderr and imported.returncode == 1
            print(f"{name}: refused: {imported.stderr.strip()}")
        else:
            subprocess.run([tip, "robot", "export", "--urdf", "--robot", described, "-o", exported], check=True)
            count, size, apart, moved, heavier, (kept, shifted, turned) = compare(source, exported, described.read_text())
            doubts = imported.stderr.count(" doubtful: ")
            # Without inertias that can be, uniform rods have taken their place.
            is_kept = not re.search(r"that of a uniform rod or box|carry 0 kg", imported.stderr)
            holds = max(apart, moved, shifted, turned) <= LIMIT and (heavier <= LIMIT or not is_kept)
            masses = f"{heavier:.1e} of it" if is_kept else "not kept"
            print(
                f"{name}: {count} legs, {POSES} poses, size {size:.3f} m, places {apart:.1e} of it, "
                f"Jacobians {moved:.1e} of it, mass matrix {masses}, {kept} shapes, their places and sizes {shifted:.1e} of it, turns {turned:.1e}, "
                f"{doubts} doubts"
            )
        failed |= not holds
    sys.exit(failed)


if __name__ == "__main__":
    main()
