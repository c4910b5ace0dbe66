"""Compares the mass matrix of TITAN VIII with mass to pinocchio's: energies and momenta of states that move in all ways.

Argument: what the example `energies` of tip-sim writes. Prints the greatest differences, in parts of the greatest value.
"""

import math
import sys

import numpy as np
import pinocchio as pin

from robots import GRAVITY, ROTOR, TITAN


def titan():
    """A free body, and three joints for each leg."""
    model = pin.Model()
    model.gravity = pin.Motion(np.array([0, 0, -GRAVITY]), np.zeros(3))
    trunk = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "trunk")
    size = [b - a for a, b in zip(TITAN.low, TITAN.high)]
    model.appendBodyToJoint(trunk, pin.Inertia.FromBox(TITAN.mass, *size), pin.SE3.Identity())
    for number, hip in enumerate(TITAN.hips):
        side = math.copysign(1, hip[0])
        parent, at = trunk, np.array([*hip, 0.0])
        for place, (axis, length, mass) in enumerate(TITAN.links):
            joint = pin.JointModelRevoluteUnaligned(side * np.array(axis, float))
            parent = model.addJoint(parent, joint, pin.SE3(np.eye(3), at), f"j{number}{place}")
            own = mass * length**2 / 12
            rod = pin.Inertia(mass, np.array([side * length / 2, 0, 0]), np.diag([0, own, own]))
            model.appendBodyToJoint(parent, rod, pin.SE3.Identity())
            at = np.array([side * length, 0, 0])
    model.armature = np.array([0] * 6 + [ROTOR * TITAN.torque] * 12)
    return model


def rotation(roll, pitch, yaw):
    turn = lambda angle, axis: pin.AngleAxis(math.radians(angle), np.array(axis, float)).toRotationMatrix()
    return turn(yaw, (0, 0, 1)) @ turn(pitch, (1, 0, 0)) @ turn(roll, (0, 1, 0))


def main():
    model = titan()
    data = model.createData()
    ours, theirs = [], []
    for row in np.loadtxt(sys.argv[1], delimiter=","):
        turned = rotation(*row[3:6])
        q = np.concatenate([row[:3] / 1000, pin.Quaternion(turned).coeffs(), np.radians(row[12:24])])
        v = np.concatenate([turned.T @ row[6:9] / 1000, turned.T @ np.radians(row[9:12]), np.radians(row[24:36])])
        mass = np.triu(pin.crba(model, data, q))
        mass = mass + np.triu(mass, 1).T
        potential = pin.computePotentialEnergy(model, data, q)
        momentum = pin.computeCentroidalMomentum(model, data, q, v)
        ours.append(row[36:])
        theirs.append([v @ mass @ v / 2, potential, *momentum.linear, *momentum.angular])
    ours, theirs = np.array(ours), np.array(theirs)
    off = np.abs(ours - theirs).max(axis=0) / np.abs(theirs).max(axis=0)
    print("\n| of 100 states | greatest difference from pinocchio's |\n|---|---:|")
    names = ("kinetic energy", "potential energy", "linear momentum", "angular momentum")
    for name, part in zip(names, (off[:1], off[1:2], off[2:5], off[5:])):
        print(f"| {name} | {part.max():.1e} |")
    sys.exit(0 if off.max() < 1e-9 else 1)


main()
