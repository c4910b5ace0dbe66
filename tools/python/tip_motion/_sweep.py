"""Sweeps: specifications, tables, and executors.

A worker of an executor runs chunks of cases. With a folder it writes each chunk as a Parquet file under a temporary name,
renames it, and returns a receipt, so that results never pass through a scheduler and a killed worker loses one chunk.
"""

import csv
import hashlib
import json
import numbers
import os
import stat
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
from . import _arguments as arguments


def uniform(low: float, high: float) -> dict:
    """Samples that are equally likely between two bounds."""
    return {"uniform": {"low": arguments.number("low", low), "high": arguments.number("high", high)}}


def normal(mean: float, deviation: float) -> dict:
    """Normally distributed samples."""
    return {"normal": {"mean": arguments.number("mean", mean), "deviation": arguments.number("deviation", deviation)}}


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
    is a description (TOML), or a URDF or MJCF file, which is imported as `tip robot import` does.
    `vary` maps names of quantities to lists of numbers, one number, `uniform(…)` or `normal(…)`. `plant` is "scene",
    "quasi-static" or "dynamic". `until` is the longest time of a run on the robot, s. The last values of the variables
    in `record` become columns.
    """
    name, text = _file(arguments.place("program", program), "program.prg")
    if vary is not None and not isinstance(vary, Mapping):
        raise arguments.wrong("vary", "a mapping of names to values", vary)
    if not isinstance(events, str):
        raise arguments.wrong("events", "a text", events)
    document = {
        "program": {"name": name, "text": text},
        "robot": _robot(robot),
        "plant": arguments.one_of("plant", plant, ("scene", "quasi-static", "dynamic")),
        "vary": [{"name": str(name), "values": _values(name, values)} for name, values in (vary or {}).items()],
        "sampling": arguments.one_of("sampling", sampling, ("random", latin_hypercube)),
        "repeat": arguments.count("repeat", repeat, 1),
        "seed": arguments.count("seed", seed),
        "events": events,
        "until": arguments.number("until", until),
        "record": arguments.names("record", record),
    }
    if scene is not None:
        arguments.place("scene", scene)
        document["scene"] = _file(scene, "scene.toml")[1] if _is_description(scene) else str(scene)
    if cycles is not None:
        document["cycles"] = arguments.count("cycles", cycles)
    return json.dumps(document)


def _robot(robot):
    arguments.place("robot", robot)
    if str(robot).endswith((".urdf", ".xml")) or _is_xml(robot):
        return {"urdf": _file(robot, "robot.urdf")[1]}
    return {"description": _file(robot, "robot.toml")[1]} if _is_description(robot) else {"name": str(robot)}


def _is_xml(text):
    return str(text).lstrip().startswith("<")


def _is_description(text):
    return "\n" in str(text) or str(text).endswith(".toml")


def _file(place, name, encoding="utf-8"):
    """Returns the name and the text of a file, or of a text: XML, or more than one line."""
    if isinstance(place, str) and ("\n" in place or _is_xml(place)):
        return name, place if encoding else place.encode()
    data = Path(place).read_bytes()
    if not encoding:
        return str(place), data
    try:
        return str(place), data.decode("utf-8")
    except UnicodeDecodeError:
        return str(place), data.decode("cp932")


def _values(name, values):
    name = f"vary[{name!r}]"
    if isinstance(values, Mapping):
        if set(values) not in ({"uniform"}, {"normal"}):
            raise arguments.wrong(name, "uniform(…) or normal(…)", values)
        return dict(values)
    if isinstance(values, numbers.Real):
        return {"list": [arguments.number(name, values)]}
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise arguments.wrong(name, "a list of numbers, a number, uniform(…) or normal(…)", values)
    return {"list": [arguments.number(f"{name}[{place}]", value) for place, value in enumerate(values)]}


def sweep(
    program: str | PathLike,
    *,
    executor: Executor | None = None,
    directory: str | PathLike | None = None,
    chunk: int | None = None,
    **options,
):
    """Runs every case and returns a `pyarrow.Table`, in the order of cases; the options are those of `spec`.

    `executor` is any `concurrent.futures.Executor`, such as `ProcessPoolExecutor()` or `client.get_executor()` of Dask; by
    default threads on all cores. With `directory` the workers write Parquet files there and the result is a
    `pyarrow.dataset.Dataset`, which need not fit into memory. Chunks that are there already are skipped: after an error,
    a killed worker or a lost machine the same call goes on. `chunk` is the number of cases that a worker runs at a time: 100 with
    a directory, else such that all cores have work.
    """
    document = spec(program, **options)
    cases = _native.cases(document)
    if chunk is not None:
        chunk = arguments.count("chunk", chunk, 1)
    else:
        chunk = 100 if directory is not None else min(max(cases // (4 * (os.cpu_count() or 1)), 1), 100)
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
    expected = {_part(directory, *each) for each in chunks}
    if not expected.issuperset(directory.glob("part-*.parquet")):
        raise ValueError(f"{directory} holds chunks of another size: use the same chunk, or choose another directory")
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
    """Makes a table, with unit and meaning in the metadata of its columns and the specification in that of the table."""
    fields, arrays = [], []
    for name, unit, meaning, kind, values in columns:
        array = pa.array(values, pa.string()) if kind == "str" else pa.array(np.frombuffer(values, kind))
        fields.append(pa.field(name, array.type, metadata={"unit": unit, "meaning": meaning}))
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
    """Writes a table as `tip sweep` does: `tip view PATH` shows it, `tip view PATH --case N` replays a run. The specification goes to
    a file next to it, whose name ends in .sweep.json; the name of the table ends in .csv."""
    table = table.to_table() if isinstance(table, pyarrow.dataset.Dataset) else table
    document = (table.schema.metadata or {}).get(b"tip.spec", b"").decode()
    if not document:
        raise ValueError("the table is not one of tip_motion.sweep: it has no specification in its metadata")
    known = [name for name, *_ in _native.run_chunk(document, 0, 0)]
    if table.column_names != known:
        raise ValueError(f"the table has other columns than its sweep, which are {', '.join(known)}")
    # A table takes the place of a file, not of a link to it.
    path = Path(os.path.realpath(arguments.place("path", path)))
    if path.suffix != ".csv":
        raise ValueError(f"{path} is not the name of a table: it must end in .csv")
    specification = path.with_suffix(".sweep.json")
    for file in (path, specification):
        if file.exists() and not (stat.S_ISREG(file.stat().st_mode) and file.stat().st_mode & stat.S_IWUSR):
            raise ValueError(f"{file} is not a file that can be replaced: it is read-only, a folder, a device or a pipe")
    titles = []
    for field in table.schema:
        unit = (field.metadata or {}).get(b"unit", b"").decode()
        titles.append(f"{field.name} [{unit}]" if unit else field.name)
    temporary = [file.with_name(f".{file.name}-{uuid.uuid4().hex}") for file in (specification, path)]
    try:
        temporary[0].write_text(_native.saved(document), "utf-8")
        with temporary[1].open("w", encoding="utf-8", newline="") as file:
            rows = csv.writer(file, lineterminator="\n")
            rows.writerow(titles)
            for batch in table.to_batches():
                rows.writerows([_cell(cell) for cell in row] for row in zip(*(column.to_pylist() for column in batch.columns)))
        os.replace(temporary[0], specification)
        os.replace(temporary[1], path)
    finally:
        for file in temporary:
            file.unlink(missing_ok=True)


def _cell(cell):
    """Returns a cell as text. A number reads back to the same bits; a missing one is empty."""
    if isinstance(cell, float):
        return "" if cell != cell else np.format_float_positional(cell, trim="-")
    return cell
