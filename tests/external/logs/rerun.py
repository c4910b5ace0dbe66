"""Judges what Rerun makes of a log, as `rerun rrd print -v` shows it: frames that move, shapes, messages; not raw bytes."""

import pathlib
import re
import sys

path = pathlib.Path(sys.argv[1])
rows, shapes, columns = {}, set(), {}
for line in path.read_text(errors="replace").splitlines():
    found = re.search(r"with (\d+) rows .* - (/\S*) - data columns: \[(.*)\]", line)
    if found and "McapChannel" not in found[3]:
        entity = found[2]
        rows[entity] = rows.get(entity, 0) + int(found[1])
        columns.setdefault(entity, "")
        columns[entity] += found[3]
        shapes |= set(re.findall(r"(Cylinders3D|Ellipsoids3D|Boxes3D):half_sizes|(Cylinders3D):lengths", found[3]))
for entity in ("/tf", "/tf_static"):
    for part in ("child_frame", "parent_frame", "quaternion", "translation"):
        assert f"Transform3D:{part}" in columns[entity], (entity, columns[entity])
assert "TextLog:text" in columns["/tip/messages"], columns["/tip/messages"]
assert "Scalars:scalars" in columns["/joint_states/position"]
assert "tip.State:message" in columns["/tip/state"], "decoded by its descriptor"
kinds = {kind for pair in shapes for kind in pair if kind}
assert {"Cylinders3D", "Ellipsoids3D", "Boxes3D"} <= kinds, kinds
print(f"{path.stem}: {rows['/tf']} transforms in Rerun, shapes {', '.join(sorted(kinds))}")
