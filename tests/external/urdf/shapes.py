"""Where pinocchio has the collision shapes of a URDF file, without meshes."""

import pathlib
import tempfile
import xml.etree.ElementTree

import numpy
import pinocchio


class Shapes:
    """Boxes, cylinders and spheres by the joint that carries them; those of the base by `universe`."""

    def __init__(self, path, model):
        self.of = {}
        geometry = pinocchio.buildGeomFromUrdf(model, str(without_meshes(path)), pinocchio.GeometryType.COLLISION)
        for shape in geometry.geometryObjects:
            self.of.setdefault(model.names[shape.parentJoint], []).append(Shape(shape))


class Shape:
    def __init__(self, shape):
        self.joint, self.placement = shape.parentJoint, shape.placement
        self.kind = type(shape.geometry).__name__
        sizes = {"Box": ["halfSide"], "Cylinder": ["radius", "halfLength"], "Sphere": ["radius"]}[self.kind]
        self.sizes = numpy.hstack([numpy.ravel(getattr(shape.geometry, size)) for size in sizes]) * 2

    def place(self, data, base):
        """In the frame of the base, at the pose of the data."""
        return base.actInv(data.oMi[self.joint].act(self.placement))


def without_meshes(path):
    """A copy of a file whose meshes are left out, since they are not here."""
    tree = xml.etree.ElementTree.parse(path)
    for link in tree.getroot().iter("link"):
        for collision in link.findall("collision"):
            if collision.find("geometry/mesh") is not None:
                link.remove(collision)
    copy = pathlib.Path(tempfile.mkdtemp()) / "shapes.urdf"
    tree.write(copy)
    return copy


def apart(ours, theirs):
    """How far two placements are from each other: m, and elements of their turns."""
    place = numpy.linalg.norm(ours.translation - theirs.translation)
    return place, numpy.abs(ours.rotation - theirs.rotation).max()


def pairs(ours, theirs, place, at):
    """Each shape with its counterpart: the nearest of its kind. `place` and `at` give their placements now; `None` if there are
    more of ours, or fewer."""
    left, found = list(ours), []
    if len(ours) != len(theirs):
        return None
    for other in theirs:
        alike = [shape for shape in left if shape.kind == other.kind]
        if not alike:
            return None

        def far(shape):
            return sum(apart(place(shape), at(other))) + numpy.abs(shape.sizes - other.sizes).max()

        nearest = min(alike, key=far)
        left.remove(nearest)
        found.append((nearest, other))
    return found
