"""Results of Google Benchmark: medians of repetitions with their range, and how they are made."""
import json
import os
import re
import statistics
import subprocess
import sys
from dataclasses import dataclass

RATES = ("particle-steps/s", "particles/s", "points/s", "GB/s", "GFLOP/s")
REPETITIONS = 5


class Missing(Exception):
    """Something cannot be done; one line."""


@dataclass
class Result:
    """The rate of a benchmark: the first of RATES that it counts, else runs a second."""
    unit: str
    rates: list
    bandwidths: list  # GB/s; empty where it is not counted

    @property
    def rate(self):
        return statistics.median(self.rates)

    @property
    def bandwidth(self):
        return statistics.median(self.bandwidths) if self.bandwidths else float("nan")

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
        if entry.get("run_type") == "aggregate" or entry.get("error_occurred"):
            continue
        unit, rate = _rate(entry)
        name = re.sub(r"/real_time$", "", entry["run_name"])
        result = found.setdefault(name, Result(unit, [], []))
        result.rates.append(rate)
        if "GB/s" in entry:
            result.bandwidths.append(entry["GB/s"])
    return found


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


def measure(program, pattern, threads, out, seconds):
    """Runs what the pattern names on so many threads; keeps the file; (context, results by name)."""
    words = [program, f"--benchmark_filter={pattern}", f"--benchmark_min_time={seconds}",
             f"--benchmark_repetitions={REPETITIONS}", f"--benchmark_out={out}", "--benchmark_out_format=json"]
    environment = dict(os.environ, OMP_NUM_THREADS=str(threads))
    environment.setdefault("OMP_PLACES", "threads")
    print(f"{threads} thread{'s' if threads > 1 else ''} ...", file=sys.stderr, flush=True)
    ran = subprocess.run(words, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                         check=False)
    if ran.returncode:
        said = ran.stderr.strip().splitlines()
        raise Missing(f"the benchmarks failed on {threads} threads: {said[-1] if said else ran.returncode}")
    context, results = read(out)
    if not results:
        raise Missing(f"no benchmark has a name like '{pattern}'")
    return context, results
