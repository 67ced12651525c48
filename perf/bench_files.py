"""Results of Google Benchmark: medians of repetitions with their range, and how they are made."""
import csv
import json
import os
import re
import statistics
import subprocess
import sys
from dataclasses import dataclass

RATES = ("particle-steps/s", "particles/s", "points/s", "GB/s", "GFLOP/s")
COUNTS = ("GB/s", "GFLOP/s", "particles", "peak bytes/particle")
REPETITIONS = 5


class Missing(Exception):
    """Something cannot be done; one line."""


@dataclass
class Result:
    """The rate of a benchmark: the first of RATES that it counts, else runs a second; and all that it counts."""
    unit: str
    rates: list
    counts: dict

    @property
    def rate(self):
        return statistics.median(self.rates)

    def count(self, name):
        """nan where it is not counted."""
        return statistics.median(self.counts[name]) if name in self.counts else float("nan")

    @property
    def noise(self):
        """How far the repetitions lie apart, over their median."""
        return (max(self.rates) - min(self.rates)) / self.rate


def _rate(entry):
    for unit in RATES:
        if unit in entry:
            return unit, entry[unit]
    return "runs/s", {"ns": 1e9, "us": 1e6, "ms": 1e3, "s": 1}[entry["time_unit"]] / entry["real_time"]


def results_of(document):
    found = {}
    for entry in document["benchmarks"]:
        name = re.sub(r"/real_time$", "", entry["run_name"])
        if entry.get("error_occurred"):
            print(f"brisance: {name}: {entry.get('error_message')}", file=sys.stderr)
            continue
        if entry.get("run_type") == "aggregate":
            continue
        unit, rate = _rate(entry)
        result = found.setdefault(name, Result(unit, [], {}))
        result.rates.append(rate)
        for key in COUNTS:
            if key in entry:
                result.counts.setdefault(key, []).append(entry[key])
    return found


def make_folder(path):
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as problem:
        raise Missing(f"cannot write {path}: {problem.strerror}") from None


def present(out, name, rows, context, draw):
    """Writes out/name.csv and, by draw(path), out/name.png; the exit status."""
    path = os.path.join(out, name + ".csv")
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]) + ["processor", "commit", "compiler"])
        writer.writeheader()
        for row in rows:
            writer.writerow({**row, **{key: context.get(key, "") for key in ("processor", "commit", "compiler")}})
    print(path)
    path = os.path.join(out, name + ".png")
    try:
        draw(path)
    except ImportError as missing:
        print(f"bench: no picture: {missing.name} is missing", file=sys.stderr)
        return 1
    print(path)
    return 0


def origin(context, threads=None):
    """What was measured with, for the head of a picture."""
    words = [context.get("processor", ""), f"commit {context.get('commit', '')}", context.get("compiler", "")]
    if threads:
        words.append(f"{threads} thread{'s' if threads > 1 else ''}")
    return ", ".join(words)


def read(path):
    """(context, results by name) of a file that --benchmark_out has written."""
    try:
        with open(path) as file:
            document = json.load(file)
        return document["context"], results_of(document)
    except OSError as problem:
        raise Missing(f"cannot read {path}: {problem.strerror}") from None
    except (ValueError, KeyError, TypeError):
        raise Missing(f"{path} is no result of 'bench --benchmark_out={path}'") from None


def measure(program, pattern, threads, out, seconds, repetitions=REPETITIONS, words=()):
    """Runs what the pattern names on so many threads; keeps the file; (context, results by name)."""
    command = [program, f"--benchmark_filter={pattern}", f"--benchmark_min_time={seconds}",
               f"--benchmark_repetitions={repetitions}", f"--benchmark_out={out}", "--benchmark_out_format=json",
               *words]
    environment = dict(os.environ, OMP_NUM_THREADS=str(threads))
    environment.setdefault("OMP_PLACES", "threads")
    print(f"{threads} thread{'s' if threads > 1 else ''} ...", file=sys.stderr, flush=True)
    ran = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                         check=False)
    if ran.returncode:
        said = ran.stderr.strip().splitlines()
        raise Missing(f"the benchmarks failed on {threads} threads: {said[-1] if said else ran.returncode}")
    context, results = read(out)
    if not results:
        raise Missing(f"no benchmark has a name like '{pattern}'")
    return context, results
