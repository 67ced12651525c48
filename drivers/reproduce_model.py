"""What the page of the paper is made of: sections hold exhibits (a table or a figure of the paper), an
exhibit holds rows that set our number beside the paper's, and pictures."""
import json
import os
import xml.etree.ElementTree as xml
from dataclasses import dataclass
from typing import Callable, NamedTuple, Optional

from plot_run import Missing, Run, np, read_csv

# How numbers are shown: the size of a unit in SI.
SCALES = {"": 1, "%": 0.01, "Pa": 1, "MPa": 1e6, "GPa": 1e9, "s": 1, "ms": 1e-3, "µs": 1e-6, "m": 1,
    "mm": 1e-3,
          "m/s": 1, "km/s": 1e3, "rad/s": 1, "1/s": 1, "cells": 1, "°": 1, "kg/m": 1, "kg/m³": 1, "J/kg": 1}

REACHED, MISSED, ABSENT, SHOWN = "reached", "missed", "missing", "shown"


@dataclass(frozen=True)
class Case:
    """One run: a scene of inputs/ and what its command line changes."""
    name: str
    scene: str
    arguments: tuple = ()
    judged: bool = True  # by the limits that the scene carries; not where it is run to be compared
    about: str = ""  # in a few words, for the page


class Result:
    """What became of a case. Whatever needs it while it failed raises Missing."""

    def __init__(self, case, folder, problem="", reused=""):
        self.case, self.folder, self.problem, self.reused = case, folder, problem, reused
        self.summary, self.frames = {}, []
        if problem:
            return
        try:
            with open(os.path.join(folder, "summary.json")) as file:
                self.summary = json.load(file)
            sets = xml.parse(os.path.join(folder, "particles.pvd")).getroot().iter("DataSet")
            self.frames = [float(one.get("timestep")) for one in sets]
        except (OSError, ValueError, xml.ParseError) as error:
            self.problem = f"results cannot be read: {error}"

    def measure(self, name):
        value = self.summary.get("measures", {}).get(name, {}).get("value")
        if value is None:
            raise Missing(f"{self.case.name} does not measure '{name}'")
        return value

    def measures(self):
        return self.summary.get("measures", {})

    def checks(self):
        return self.summary.get("checks", []) if self.case.judged else []

    def frame(self, number=None):
        """The particles of an output; the last one without a number."""
        run = Run(self.folder, number)
        run.load()
        return run

    def table(self, name, needed=("time",)):
        return read_csv(os.path.join(self.folder, name), needed)

    def materials(self):
        """(name, law) of each material, in the order of the particles' column "material"."""
        root = xml.parse(os.path.join(self.folder, "input.xml")).getroot()
        return [(one.get("name"), one.find("./Parameter[@name='law']").get("value"))
                for one in root.findall("./ParameterList[@name='materials']/ParameterList")]

    def parameter(self, where, name, otherwise):
        """The text of a parameter of the complete input, where a list of the scene has it."""
        root = xml.parse(os.path.join(self.folder, "input.xml")).getroot()
        found = root.find(f"./ParameterList[@name='{where}']/Parameter[@name='{name}']")
        return otherwise if found is None else found.get("value")

    def of_law(self, particles, *laws):
        """Which particles obey one of the laws."""
        numbers = [k for k, (_, law) in enumerate(self.materials()) if law in laws]
        return np.isin(particles["material"], numbers)


class Results(dict):
    """Results by the name of their case; asking for a failed one raises Missing."""

    def __init__(self):
        super().__init__()
        self.rows = {}

    def judge(self, row):
        if row not in self.rows:
            self.rows[row] = row.judged(self)
        return self.rows[row]

    def __getitem__(self, name):
        result = super().__getitem__(name)
        if result.problem:
            raise Missing(result.problem)
        return result


class Judged(NamedTuple):
    ours: str
    limit: str
    verdict: str


def number(value, form=".4g"):
    return f"{value:{form}}".rstrip(".").replace("e+0", "e").replace("e-0", "e-").replace("e+", "e")


class Row(NamedTuple):
    """A quantity of the paper beside ours. Limits are in the unit shown; without any it is shown only."""
    what: str
    paper: str
    reference: str
    ours: Callable  # of the Results
    unit: str = ""
    low: Optional[float] = None
    high: Optional[float] = None

    def judged(self, results):
        """Ask the Results instead, which do this once."""
        unit = (" " if self.unit not in ("", "°") else "") + self.unit
        limit = ""
        if self.low is not None and self.high is not None:
            limit = f"{number(self.low)} to {number(self.high)}{unit}"
        elif self.low is not None:
            limit = f"at least {number(self.low)}{unit}"
        elif self.high is not None:
            limit = f"at most {number(self.high)}{unit}"
        try:
            value = self.ours(results) / SCALES[self.unit]
        except Missing as missing:
            return Judged(str(missing), limit, ABSENT)
        except (KeyError, IndexError, ValueError,
            OSError) as error:  # results of another shape: no reason to lose the page
            return Judged(f"cannot be measured: {error!r}", limit, ABSENT)
        inside = (self.low is None or value >= self.low) and (self.high is None or value <= self.high)
        form = ".4g" if value == round(value) else "#.4g"  # all four digits, but of whole numbers
        return Judged(number(value, form) + unit, limit, (REACHED if inside else MISSED) if limit else SHOWN)


def measured(case, name, factor=1):
    """A row's number, taken from the measures of a run."""
    return lambda results: factor * results[case].measure(name)


class Picture(NamedTuple):
    draw: Callable  # of the Results; returns a figure
    caption: str


@dataclass(frozen=True)
class Exhibit:
    """A table or a figure of the paper; the first row is its line in the index."""
    label: str
    title: str
    rows: tuple
    pictures: tuple = ()
    cases: Optional[tuple] = None  # names of the cases that it stands on; all of the section's without


@dataclass(frozen=True)
class Section:
    key: str
    title: str
    text: str  # what was computed, in HTML
    cases: tuple
    exhibits: tuple
    notes: tuple = ()  # misprints and gaps that matter here

    def standing(self, exhibit):
        return tuple(case.name for case in self.cases) if exhibit.cases is None else exhibit.cases


def verdict_of(results, section, exhibit):
    """missing before missed before reached; checks of the runs count with the rows."""
    verdicts = [results.judge(row).verdict for row in exhibit.rows]
    for name in section.standing(exhibit):
        result = results.get(name)
        if result.problem:
            verdicts.append(ABSENT)
        verdicts += [check["verdict"] for check in result.checks()]
    return ABSENT if ABSENT in verdicts else MISSED if MISSED in verdicts else REACHED
