"""Computes the figures of runs from their traces and tables alone, and compares them with those of the terminal, of `--format json` and
of the page. Usage: figures.py TIP FOLDER, in the root of the repository.
"""

import base64
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml
import zlib

tip, folder = sys.argv[1], pathlib.Path(sys.argv[2])
TIPS = "3.1\nTips over two feet\nSTAND_UP 60\nWAIT_INPOS ALL\nPTP F1 -391 201 -60\nPTP F3 -391 -201 -60\nWAIT_INPOS ALL\nSLEEP 2000\nEND\n"
(folder / "tips.prg").write_text(TIPS)
GRASP = ["examples/grasp/motions/grasp.prg", "--robot", "hand", "--scene", "examples/grasp/scene.toml"]
STIFF = ["site/lessons/09-walk.prg", "--events", "20:set SHARE.X=0, 20:set SHARE.Y=0"]
WALK = ["examples/walk/motions/walk.prg"]
MASS = ["--plant", "dynamic"]
# The arguments of each run, and the tolerance of its slip, mm. A plant with mass measures slip between cycles as well.
RUNS = {
    "walk": (WALK, 0.01),
    "walk with mass": (WALK + MASS, 0.5),
    "slip": (STIFF, 0.01),
    "slip with mass": (STIFF + MASS, 3.0),
    "fall": ([str(folder / "tips.prg")], 0.01),
    "fall with mass": ([str(folder / "tips.prg")] + MASS, 3.0),
    "grasp": (GRASP, None),
}
GRAVITY = 9.80665
# A foot with mass that bounces for less than this goes on slipping: s.
BOUNCE = 0.1


def run(*arguments):
    done = subprocess.run([tip, *arguments], capture_output=True, text=True)
    assert done.returncode in (0, 3), done.stderr
    return done.stdout, done.stderr


def numbers(text):
    return [float(part) for part in (text or "0 0 0").split()]


def matrix(axis, angle):
    """Returns the rotation about a unit vector (Rodrigues)."""
    (x, y, z), c, s = axis, math.cos(angle), math.sin(angle)
    t = 1 - c
    return [[t * x * x + c, t * x * y - s * z, t * x * z + s * y], [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c]]


def times(one, other):
    return [[sum(one[i][k] * other[k][j] for k in range(3)) for j in range(len(other[0]))] for i in range(3)]


def applied(rotation, vector):
    return [sum(rotation[i][k] * vector[k] for k in range(3)) for i in range(3)]


class Model:
    """The chains of legs in an exported URDF, whose axes are x forward, y left, z up, in m."""

    def __init__(self, path):
        robot = xml.parse(path).getroot()
        self.joints = {joint.get("name"): joint for joint in robot.iter("joint")}
        self.mass = sum(float(mass.get("value")) for mass in robot.iter("mass"))
        self.by_parent = {}
        for joint in self.joints.values():
            self.by_parent.setdefault(joint.find("parent").get("link"), []).append(joint)

    def foot(self, leg, angles):
        """Returns the place of a foot in the robot's frame, mm: x to the right, y forward."""
        turn, place = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0]
        joint = self.joints[f"J{leg}1"]
        rest = list(angles)
        while joint is not None:
            origin = joint.find("origin")
            assert numbers(origin.get("rpy")) == [0, 0, 0], "turned frames are not followed here"
            place = [a + b for a, b in zip(place, applied(turn, numbers(origin.get("xyz"))))]
            if joint.get("type") == "revolute":
                turn = times(turn, matrix(numbers(joint.find("axis").get("xyz")), math.radians(rest.pop(0))))
            joint = next(iter(self.by_parent.get(joint.find("child").get("link"), [])), None)
        x, y, z = place
        return [-1000 * y, 1000 * x, 1000 * z]


def in_world(point, pose):
    x, y, z, roll, pitch, yaw = pose
    turn = times(times(matrix([0, 0, 1], math.radians(yaw)), matrix([1, 0, 0], math.radians(pitch))), matrix([0, 1, 0], math.radians(roll)))
    return [a + b for a, b in zip(applied(turn, point), [x, y, z])]


def largest_slip(cycles, model, period, has_mass):
    """Returns the largest distance of a foot from where it touched down: mm, foot, cycle. Without mass it is measured along the floor."""
    most = (0.0, None, None)
    for leg in range(len(cycles[0]["loads"])):
        touchdown, up = None, math.inf
        for cycle in cycles:
            if cycle["loads"][leg] <= 0:
                up += period
                if not has_mass or up >= BOUNCE:
                    touchdown = None
                continue
            up = 0.0
            place = in_world(model.foot(leg + 1, cycle["angles"][leg]), cycle["pose"])
            if touchdown is None:
                touchdown = place
            slip = math.dist(place[: 3 if has_mass else 2], touchdown[: 3 if has_mass else 2])
            if slip > most[0]:
                most = (slip, f"F{leg + 1}", cycle["cycle"])
    return most


def page_of(arguments):
    path = folder / "page.html"
    run("view", "--quiet", *arguments, "-o", str(path))
    packed = re.search(r'id="recording">([^<]*)<', path.read_text())[1]
    updates = zlib.decompress(base64.b64decode(packed), wbits=-15).decode().split("\n")
    return [json.loads(update) for update in updates]


def near(name, figure, expected, within):
    assert abs(figure - expected) <= within, f"{name}: {figure}, but {expected} from the trace"


def judge(name, arguments, slips_within):
    trace = folder / "trace.jsonl"
    said = json.loads(run("run", "--quiet", *arguments, "--format", "json", "--trace", str(trace), "--trace-motion")[0].splitlines()[-1])
    text = run("run", *arguments)[1]
    script, _, over = page_of(arguments)
    figures = {key: value for key, value in said.items() if key not in ("file", "end", "error", "line")}
    assert over["summary"] == figures, "the page and the JSON"
    cycles = [json.loads(line) for line in trace.read_text().splitlines()]
    cycles = [cycle for cycle in cycles if "cycle" in cycle]
    table = folder / "table.csv"
    run("log", *arguments, "-o", str(table))
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    period = (float(rows[1]["time_ms"]) - float(rows[0]["time_ms"])) / 1000
    checked = []

    def terminal(label, *parts):
        lines = [line for line in text.splitlines() if line.startswith(f"  {label} ")]
        assert any(all(part in line for part in parts) for line in lines), f"{label}: {parts} is not in {lines}"
        checked.append(label)

    def moment(figure, cycle):
        line = script["script"]["lines"][cycles[cycle]["step"]]
        assert (figure["cycle"], figure["line"]) == (cycle, line), f"{figure}: cycle {cycle}, line {line} from the trace"
        near("time", figure["time_s"], cycle * period, 1e-6)
        return f"{cycle * period:.3f} s (cycle {cycle}, line {line})"

    near("cycles", figures["cycles"], len(cycles), 0)
    near("time", figures["time_s"], len(cycles) * period, 1e-6)
    walks = "pose" in cycles[0]
    assert walks == (figures["travel"] is not None)
    if walks:
        first, last, travel = cycles[0]["pose"], cycles[-1]["pose"], figures["travel"]
        for key, value in [("forward_mm", last[1]), ("right_mm", last[0])]:
            near(key, travel[key], value, 1e-6)
        # A trace begins at the end of the first cycle, in which the body may have settled.
        near("up_mm", travel["up_mm"], last[2] - first[2], 0.1)
        near("speed_mm_s", travel["speed_mm_s"], last[1] / (len(cycles) * period), 1e-6)
        turns = [(after["pose"][5] - before["pose"][5] + 180) % 360 - 180 for before, after in zip(cycles, cycles[1:])]
        near("turn_deg", travel["turn_deg"], sum(turns) + first[5], 1e-6)
        terminal("travel", f"{abs(last[1]):.1f} mm", f"{abs(last[0]):.1f} mm")
        if round(abs(travel["speed_mm_s"]), 1):
            terminal("speed", f"{abs(last[1]) / (len(cycles) * period):.1f} mm/s")
        assert figures["falls"]["count"] == cycles[-1]["falls"] and (not name.startswith("fall") or cycles[-1]["falls"] > 0)
        fallen = next((cycle["cycle"] for cycle in cycles if cycle["falls"]), None)
        assert (figures["falls"]["first"] or {}).get("cycle") == fallen, (figures["falls"], fallen)
        if fallen is None:
            terminal("falls", "none")
        else:
            moment(figures["falls"]["first"], fallen)
            terminal("falls", str(cycles[-1]["falls"]), f"{fallen * period:.3f} s")
        least = min(cycle["margin"] for cycle in cycles)
        near("margin", figures["margin"]["value"], least, 1e-6)
        when = moment(figures["margin"], next(cycle["cycle"] for cycle in cycles if cycle["margin"] == least))
        terminal("margin", f"{least:.1f} mm", when)
        urdf = folder / "robot.urdf"
        run("robot", "export", "--robot", "titan8", "--urdf", "-o", str(urdf))
        model = Model(urdf)
        slip, foot, cycle = largest_slip(cycles, model, period, "dynamic" in arguments)
        near("slip", figures["slip"]["value"], slip, slips_within)
        # With mass another foot may slip as far within this tolerance; a slip of 0 has no moment.
        if slips_within < 0.1 and slip > 1:
            assert (figures["slip"]["of"], figures["slip"]["cycle"]) == (foot, cycle), (figures["slip"], foot, cycle)
        terminal("slip", f"{figures['slip']['value']:.1f} mm")
    fastest = (0.0, None, None)
    for before, after in zip(cycles, cycles[1:]):
        for leg, (one, other) in enumerate(zip(before["angles"], after["angles"])):
            for joint, (a, b) in enumerate(zip(one, other)):
                rate = abs(b - a) / period
                if rate > fastest[0]:
                    fastest = (rate, f"J{leg + 1}{joint + 1}", after["cycle"])
    near("rate", figures["rate"]["value"], fastest[0], 1e-6)
    assert figures["rate"]["of"] == fastest[1], (figures["rate"], fastest)
    terminal("rate", f"{fastest[0]:.1f} ", f"{fastest[1]} after {moment(figures['rate'], fastest[2])}")
    # A trace has no torques; the table has them in each cycle.
    unit = "Nm" if walks else "mNm"
    columns = [column for column in rows[0] if re.fullmatch(rf"J\d\d_{unit}", column)]
    if figures["energy"]:
        work = 0.0
        for before, after in zip(rows, rows[1:]):
            for column in columns:
                angle = column.replace(unit, "deg")
                work += abs(float(after[column])) * math.radians(abs(float(after[angle]) - float(before[angle])))
        work /= 1 if walks else 1000
        near("energy", figures["energy"]["work_j"], work, 1e-6)
        terminal("energy", f"{work:.1f} J")
        if figures["energy"]["cost_of_transport"] is not None:
            way = math.hypot(figures["travel"]["forward_mm"], figures["travel"]["right_mm"]) / 1000
            near("cost", figures["energy"]["cost_of_transport"], work / (model.mass * GRAVITY * way), 1e-6)
    if figures["torque"]:
        value, row, column = max((abs(float(row[column])), -int(row["cycle"]), column) for row in rows for column in columns)
        near("torque", figures["torque"]["value"], value, 1e-6)
        terminal("torque", f"{value:.1f} ", f"{figures['torque']['of']} after {moment(figures['torque'], -row)}")
    for finger, force in enumerate(figures["forces"], 1):
        value, row = max((float(row[f"F{finger}_N"]), -int(row["cycle"])) for row in rows)
        # The greatest force may be between two cycles.
        assert force["value"] >= value - 1e-9, (force, value)
        terminal("force", f"F{finger}:", f"{force['value']:.2f} N at most")
    print(f"{name}: {len(cycles)} cycles; equal in trace, terminal, JSON and page: {', '.join(dict.fromkeys(checked))}")


for name, (arguments, slips_within) in RUNS.items():
    judge(name, arguments, slips_within)
