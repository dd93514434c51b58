#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare runs bit by bit: what a change of the program that is meant to change no result is judged by.

    same_bits.py BEFORE AFTER

Two directories of runs, or two directories that hold directories of runs under the same names. Compared are summary.json (but for
times, memory and the program's version), statistics.csv and all other tables, every dataset of the fields, and what the newest
checkpoint says of its datasets. Numbers in text must be the same text. Runs on different numbers of ranks order the cells of
their fields differently and add works and losses up differently: of such pairs the fields, and all columns of
statistics.csv from the ninth on, are left out.

Needs python3-h5py. Exit status: 0 the same, 1 not (a line for each difference), 2 there is nothing to compare.
"""
import json
import os
import sys

NOT_OF_THE_RESULT = {"program", "performance", "wall_s", "cpu_s", "cell_steps_per_s_per_rank"}
COLUMNS_ON_ANY_RANKS = 9


def load(path):
    with open(path, encoding="utf8") as file:
        return json.load(file)


def json_differences(before, after, path):
    if isinstance(before, dict) and isinstance(after, dict):
        for key in sorted((set(before) | set(after)) - NOT_OF_THE_RESULT):
            if key in before and key in after:
                yield from json_differences(before[key], after[key], f"{path}/{key}")
            else:
                yield f"{path}/{key}: only {'before' if key in before else 'after'}"
    elif isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
        for number, (a, b) in enumerate(zip(before, after)):
            yield from json_differences(a, b, f"{path}/{number}")
    elif repr(before) != repr(after):  # 0.0 is not -0.0, and nan is itself
        yield f"{path}: {before} -> {after}"


def table_differences(before, after, name, columns):
    with open(before, encoding="utf8") as first, open(after, encoding="utf8") as second:
        rows = [[line.rstrip("\n").split(",")[:columns] for line in file] for file in (first, second)]
    for number, (a, b) in enumerate(zip(*rows), 1):
        if a != b:
            column = next((i for i, (x, y) in enumerate(zip(a, b)) if x != y), min(len(a), len(b)))
            title = rows[0][0][column] if column < len(rows[0][0]) else f"column {column + 1}"
            yield f"{name}:{number}: {title}: {','.join(a[column:column + 1])} -> {','.join(b[column:column + 1])}"
            return
    if len(rows[0]) != len(rows[1]):
        yield f"{name}: {len(rows[0])} -> {len(rows[1])} lines"


def field_differences(before, after, name):
    import h5py

    with h5py.File(before) as first, h5py.File(after) as second:
        for dataset in sorted(set(first) | set(second)):
            if dataset not in first or dataset not in second:
                yield f"{name}: {dataset}: only {'before' if dataset in first else 'after'}"
                continue
            a, b = first[dataset][...], second[dataset][...]
            if a.shape != b.shape or a.dtype != b.dtype:
                yield f"{name}: {dataset}: {a.dtype}{a.shape} -> {b.dtype}{b.shape}"
            elif a.tobytes() != b.tobytes():
                # by bytes, so that nan is itself
                width = a.dtype.itemsize
                number = sum(a.tobytes()[i:i + width] != b.tobytes()[i:i + width] for i in range(0, a.nbytes, width)) if a.nbytes < 1e6 else "some"
                yield f"{name}: {dataset}: {number} of {a.size} numbers"


def newest_checkpoint(run):
    folder = os.path.join(run, "checkpoints")
    names = [name for name in os.listdir(folder) if name.isdigit()] if os.path.isdir(folder) else []
    return load(os.path.join(folder, max(names), "contents.json"))["datasets"] if names else {}


def files_of(run, ending):
    """Names of all such files below a run, checkpoints not."""
    found = set()
    for folder, folders, names in os.walk(run):
        folders[:] = [name for name in folders if name != "checkpoints"]
        found |= {os.path.relpath(os.path.join(folder, name), run) for name in names if name.endswith(ending)}
    return found


def run_differences(before, after):
    summaries = [load(os.path.join(run, "summary.json")) for run in (before, after)]
    same_ranks = summaries[0]["performance"]["ranks"] == summaries[1]["performance"]["ranks"]
    if not same_ranks:  # round-off of what each rank adds up
        for summary in summaries:
            del summary["ledger"]
    yield from json_differences(*summaries, "summary.json")
    yield from json_differences(newest_checkpoint(before), newest_checkpoint(after), "newest checkpoint")
    for ending in (".csv", ".h5") if same_ranks else (".csv",):
        names = [files_of(run, ending) for run in (before, after)]
        for name in sorted(names[0] | names[1]):
            paths = [os.path.join(run, name) for run in (before, after)]
            if not all(os.path.exists(path) for path in paths):
                yield f"{name}: only {'before' if name in names[0] else 'after'}"
            elif ending == ".h5":
                yield from field_differences(*paths, name)
            else:
                columns = COLUMNS_ON_ANY_RANKS if name == "statistics.csv" and not same_ranks else None
                yield from table_differences(*paths, name, columns)


def is_run(directory):
    return os.path.exists(os.path.join(directory, "summary.json"))


def main():
    if len(sys.argv) != 3:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    before, after = sys.argv[1:]
    names = [""] if is_run(before) else sorted(name for name in (os.listdir(before) if os.path.isdir(before) else []) if is_run(os.path.join(before, name)))
    if not names:
        print(f"same_bits.py: {before}: no run, and holds none", file=sys.stderr)
        return 2
    differ = 0
    for name in names:
        pair = os.path.join(before, name), os.path.join(after, name)
        found = list(run_differences(*pair)) if is_run(pair[1]) else ["no such run after"]
        print(f"{name or before}: {'same' if not found else f'{len(found)} differences'}")
        for line in found:
            print(f"  {line}")
        differ += bool(found)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
