"""Results of a study as a table in memory and in a Parquet file."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ancf import _ancf
from ancf.studies.execution.row import Row

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import pyarrow as pa

    from ancf.studies.definition.design import ParameterAxis


def table(
    axes: Sequence[ParameterAxis], names: Sequence[str], rows: Mapping[int, Row], keys: Mapping[int, str]
) -> pa.Table:
    """Return cases as an Arrow table. Missing values are null."""
    import pyarrow as pa

    cases = sorted(rows)
    ordered = [rows[case] for case in cases]
    columns = {"case": pa.array(cases, pa.int64())}
    for axis in axes:
        columns[axis.path] = parameter_column(axis, cases)
    for name in names:
        columns[name] = pa.array([row.objectives.get(name) for row in ordered], pa.float64())
    types = {"outcome": pa.string(), "message": pa.string(), "steps": pa.int64(), "iterations": pa.int64()}
    for name, kind in {**types, "seconds": pa.float64()}.items():
        columns[name] = pa.array([getattr(row, name) for row in ordered], kind)
    columns["key"] = pa.array([keys[case] for case in cases], pa.string())
    about = {"program": f"ancf {_ancf.VERSION}", "objectives": json.dumps(list(names))}
    return pa.table(columns).replace_schema_metadata(about)


def parameter_column(axis: ParameterAxis, cases: Sequence[int]) -> pa.Array:
    """Return the values of a parameter in a column of their common type, or as text."""
    import pyarrow as pa

    values = [axis.value(case) for case in cases]
    if axis.column_type == "bool":
        return pa.array(values, pa.bool_())
    if axis.column_type == "int64":
        return pa.array(values, pa.int64())
    if axis.column_type == "double":
        return pa.array(map(float, values), pa.float64())
    return pa.array(map(text, values), pa.string())


def text(value: Any) -> str:
    """Return a value as JSON. Texts are unchanged, functions are represented by their names."""
    if isinstance(value, str):
        return value
    return json.dumps(value, default=lambda item: getattr(item, "__qualname__", repr(item)))


def write(data: pa.Table, path: Path) -> None:
    """Write a table atomically."""
    import pyarrow.parquet as pq

    part = path.with_suffix(".parquet.part")
    with part.open("wb") as file:
        pq.write_table(data, file)
        file.flush()
        os.fsync(file.fileno())
    part.replace(path)


def rows_in(folder: Path) -> dict[str, Row]:
    """Return the rows of all tables in a folder by key. Rows of finished cases replace others."""
    rows: dict[str, Row] = {}
    for path in sorted(folder.glob("cases*.parquet")):
        for key, row in read(path):
            if row.outcome == "finished" or key not in rows:
                rows[key] = row
    return rows


def read(path: Path) -> list[tuple[str, Row]]:
    """Return keys and rows of a table. A table of `ancf study` has other keys and no rows here."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        data = pq.read_table(path)
    except (OSError, pa.ArrowInvalid) as error:
        msg = f"{path} cannot be read; remove it or take another folder for the results"
        raise OSError(msg) from error
    names = json.loads((data.schema.metadata or {}).get(b"objectives", "null"))
    if names is None:
        return []
    return [(fields["key"], from_fields(fields, names)) for fields in data.to_pylist()]


def from_fields(fields: Mapping[str, Any], names: Sequence[str]) -> Row:
    """Return a row from the columns of a table."""
    values = {name: fields[name] for name in names if fields[name] is not None}
    kept = ("outcome", "message", "steps", "iterations", "seconds")
    return Row(objectives=values, **{name: fields[name] for name in kept})
