"""Compares the same run on two plants: the distance of the body, and its height and pitch while the robot walks.

Arguments: names for the table, the trace of MuJoCo and that of the dynamic plant, both of `tip run --trace-motion`, and the cycles
between which the robot walks. Prints a row of a table; ends with status 1 if the plants are apart by more than the limits.
"""

import json
import sys

# Limits of the differences: the distance as a share, the mean height in mm, the mean pitch and the pitch at any time in deg.
DISTANCE, HEIGHT, PITCH, PEAK = 0.05, 2, 0.3, 1


def poses(path):
    """Returns the poses by cycle: x, y, z in mm, roll, pitch, yaw in deg."""
    with open(path) as lines:
        records = map(json.loads, lines)
        return {record["cycle"]: record["pose"] for record in records if "pose" in record}


def mean(values):
    return sum(values) / len(values)


names, theirs, ours, first, last = sys.argv[1:]
theirs, ours = poses(theirs), poses(ours)
distance, other = theirs[max(theirs)][1], ours[max(ours)][1]
walking = range(int(first), int(last))
heights, pitches = ([[run[cycle][axis] for cycle in walking] for run in (theirs, ours)] for axis in (2, 4))
apart = [max(abs(one - two) for one, two in zip(*both)) for both in (heights, pitches)]
part = (distance - other) / other
print(
    f"| {names} | {distance:.1f} | {other:.1f} | {100 * part:+.2f} % | "
    f"{mean(heights[0]):.1f} | {mean(heights[1]):.1f} | {apart[0]:.1f} | "
    f"{min(pitches[0]):+.1f} to {max(pitches[0]):+.1f} | {min(pitches[1]):+.1f} to {max(pitches[1]):+.1f} | {apart[1]:.1f} |"
)
means = [abs(mean(both[0]) - mean(both[1])) for both in (heights, pitches)]
sys.exit(not (distance > 0 and abs(part) < DISTANCE and means[0] < HEIGHT and means[1] < PITCH and apart[1] < PEAK))
