"""Sweeps: specifications, tables, and executors.

A worker of an executor runs chunks of cases. With a folder it writes each chunk as a Parquet file under a temporary name,
renames it, and returns a receipt, so that results never pass through a scheduler and a killed worker loses one chunk.
"""

import hashlib
import json
import os
import uuid
from collections.abc import Iterable, Mapping
from concurrent.futures import Executor, ThreadPoolExecutor, as_completed
from os import PathLike
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.dataset
import pyarrow.parquet

from . import _native


def uniform(low: float, high: float) -> dict:
    """Samples that are equally likely between two bounds."""
    return {"uniform": {"low": float(low), "high": float(high)}}


def normal(mean: float, deviation: float) -> dict:
    """Normally distributed samples."""
    return {"normal": {"mean": float(mean), "deviation": float(deviation)}}


#: The sampling method that gives the repeats one sample in each of as many equally likely intervals.
latin_hypercube = "latin-hypercube"


def spec(
    program: str | PathLike,
    *,
    vary: Mapping[str, object] | None = None,
    robot: str | PathLike = "titan8",
    scene: str | PathLike | None = None,
    plant: str = "scene",
    sampling: str = "random",
    repeat: int = 1,
    seed: int = 0,
    events: str = "",
    until: float = 60.0,
    cycles: int | None = None,
    record: Iterable[str] = (),
) -> str:
    """Returns the specification of a sweep as a JSON document.

    `program`, `robot` and `scene` are paths, or texts if they have more than one line; a robot and a scene may be names. A robot
    is a description (TOML) or a URDF file, which is imported as `tip robot import` does.
    `vary` maps names of quantities to lists of numbers, one number, `uniform(…)` or `normal(…)`. `plant` is "scene",
    "quasi-static" or "dynamic". `until` is the longest time of a run on the robot, s. The last values of the variables
    in `record` become columns.
    """
    name, text = _file(program, "program.prg")
    document = {
        "program": {"name": name, "text": text},
        "robot": _robot(robot),
        "plant": plant,
        "vary": [{"name": name, "values": _values(values)} for name, values in (vary or {}).items()],
        "sampling": sampling,
        "repeat": int(repeat),
        "seed": int(seed),
        "events": events,
        "until": float(until),
        "record": list(record),
    }
    if scene is not None:
        document["scene"] = _file(scene, "scene.toml")[1] if _is_description(scene) else str(scene)
    if cycles is not None:
        document["cycles"] = int(cycles)
    return json.dumps(document)


def _robot(robot):
    if str(robot).endswith(".urdf") or _is_xml(robot):
        return {"urdf": _file(robot, "robot.urdf")[1]}
    return {"description": _file(robot, "robot.toml")[1]} if _is_description(robot) else {"name": str(robot)}


def _is_xml(text):
    return str(text).lstrip().startswith("<")


def _is_description(text):
    return "\n" in str(text) or str(text).endswith(".toml")


def _file(place, name, encoding="utf-8"):
    """Returns the name and the text of a file, or of a text: URDF, or more than one line."""
    if isinstance(place, str) and ("\n" in place or _is_xml(place)):
        return name, place if encoding else place.encode()
    data = Path(place).read_bytes()
    if not encoding:
        return str(place), data
    try:
        return str(place), data.decode("utf-8")
    except UnicodeDecodeError:
        return str(place), data.decode("cp932")


def _values(values):
    if isinstance(values, Mapping):
        return dict(values)
    numbers = [values] if isinstance(values, (int, float)) else values
    return {"list": [float(number) for number in numbers]}


def sweep(
    program: str | PathLike,
    *,
    executor: Executor | None = None,
    directory: str | PathLike | None = None,
    chunk: int = 100,
    **options,
):
    """Runs every case and returns a `pyarrow.Table`, in the order of cases; the options are those of `spec`.

    `executor` is any `concurrent.futures.Executor`, such as `ProcessPoolExecutor()` or `client.get_executor()` of Dask; by
    default threads on all cores. With `directory` the workers write Parquet files there and the result is a
    `pyarrow.dataset.Dataset`, which need not fit into memory. Chunks that are there already are skipped: after an error,
    a killed worker or a lost machine the same call goes on.
    """
    document = spec(program, **options)
    cases = _native.cases(document)
    if chunk < 1:
        raise ValueError("chunk must be 1 or more")
    chunks = [(first, min(chunk, cases - first)) for first in range(0, cases, chunk)]
    own = executor is None
    pool = ThreadPoolExecutor(os.cpu_count()) if own else executor
    try:
        if directory is None:
            futures = [pool.submit(_columns, document, *each) for each in chunks]
            return pa.concat_tables([_table(future.result(), document) for future in futures])
        return _to_directory(document, chunks, pool, Path(directory))
    finally:
        if own:
            pool.shutdown(cancel_futures=True)


def _to_directory(document, chunks, pool, directory):
    directory.mkdir(parents=True, exist_ok=True)
    known = directory / "spec.json"
    if known.exists() and json.loads(known.read_text("utf-8")) != json.loads(document):
        raise ValueError(f"{directory} holds the chunks of another sweep: choose another directory")
    temporary = directory / f".{uuid.uuid4().hex}.json"
    temporary.write_text(document, "utf-8")
    os.replace(temporary, known)
    missing = [each for each in chunks if not _part(directory, *each).exists()]
    futures = [pool.submit(_write, document, *each, str(directory)) for each in missing]
    for future in as_completed(futures):
        future.result()
    # A scheduler may have forgotten the receipts of a worker that died; the files tell.
    lost = [each for each in missing if not _part(directory, *each).exists()]
    if lost:
        raise RuntimeError(f"{len(lost)} chunks are not in {directory}: do all workers see this folder? The same call goes on")
    return load(directory)


def load(directory: str | PathLike):
    """Returns the dataset of a directory that `sweep` has written, in the order of cases."""
    parts = sorted(Path(directory).glob("part-*.parquet"))
    if not parts:
        raise FileNotFoundError(f"there are no chunks in {directory}")
    return pyarrow.dataset.dataset([str(part) for part in parts], format="parquet")


def _part(directory, first, count):
    return Path(directory) / f"part-{first:012}-{count}.parquet"


def _columns(document, first, count):
    return _native.run_chunk(document, first, count)


def _write(document, first, count, directory):
    """Runs a chunk in a worker and writes it; returns its receipt."""
    part = _part(directory, first, count)
    if not part.exists():
        table = _table(_columns(document, first, count), document)
        temporary = part.with_name(f".{part.stem}-{uuid.uuid4().hex}")
        pyarrow.parquet.write_table(table, temporary)
        os.replace(temporary, part)
    return first, count, part.name


def _table(columns, document):
    """Makes a table, with units in the metadata of its columns and the specification in that of the table."""
    fields, arrays = [], []
    for name, unit, kind, values in columns:
        array = pa.array(values, pa.string()) if kind == "str" else pa.array(np.frombuffer(values, kind))
        fields.append(pa.field(name, array.type, metadata={"unit": unit}))
        arrays.append(array)
    return pa.Table.from_arrays(arrays, schema=pa.schema(fields, metadata={"tip.spec": document}))


def table_hash(table) -> str:
    """Returns a hash of the names and values of all columns. Parquet files of equal tables differ with the version of
    pyarrow; their hashes do not."""
    table = table.to_table() if isinstance(table, pyarrow.dataset.Dataset) else table
    digest = hashlib.sha256()
    for name, column in zip(table.column_names, table.columns):
        digest.update(name.encode())
        if pa.types.is_string(column.type):
            digest.update("\n".join(column.to_pylist()).encode())
        else:
            digest.update(np.ascontiguousarray(column.to_numpy()).tobytes())
    return digest.hexdigest()


def save(table, path: str | PathLike) -> None:
    """Writes a table as `tip sweep` does: `tip view PATH` shows it, `tip view PATH --case N` replays a run."""
    path = Path(path)
    table = table.to_table() if isinstance(table, pyarrow.dataset.Dataset) else table
    names = []
    for field in table.schema:
        unit = (field.metadata or {}).get(b"unit", b"").decode()
        names.append(_quoted(f"{field.name} [{unit}]" if unit else field.name))
    temporary = path.with_name(f".{path.name}-{uuid.uuid4().hex}")
    with temporary.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(names) + "\n")
        for batch in table.to_batches():
            for row in zip(*(column.to_pylist() for column in batch.columns)):
                file.write(",".join(map(_quoted, row)) + "\n")
    document = json.loads(table.schema.metadata[b"tip.spec"])
    saved = {"tip": _native.__version__, "spec": document}
    path.with_suffix(".sweep.json").write_text(json.dumps(saved, indent=2), "utf-8")
    os.replace(temporary, path)


def _quoted(cell):
    if isinstance(cell, float):
        return "" if cell != cell else np.format_float_positional(cell, trim="-")
    text = str(cell)
    return f'"{text.replace(chr(34), chr(34) * 2)}"' if any(mark in text for mark in ',"\n\r') else text
