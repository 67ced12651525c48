"""Runs every problem of Hu & Chen (2006) and writes one page of its tables and figures beside ours.

Started by `brisance reproduce`, which says where the program and the scenes are. The status is 0 if all
limits hold, 1 if one is missed or a run is missing, 2 for bad words on the command line, 130 if stopped."""
import argparse
import os
import subprocess
import sys

from plot_run import STYLE, plt
from reproduce_bomb import BOMB
from reproduce_gas import RIEMANN, SEDOV
from reproduce_impact import IMPACT
from reproduce_model import ABSENT, MISSED, REACHED, Results
from reproduce_page import outcome, plain, write_page
from reproduce_paper import INTRODUCTION, OTHER_EXHIBITS, TITLE, misprints_part
from reproduce_pistons import CONTAINER, GAS
from reproduce_runs import Interrupted, Runner

SECTIONS = (RIEMANN, SEDOV, IMPACT, CONTAINER, GAS, BOMB)


def show_list():
    for section in SECTIONS:
        print(f"{section.key}: {plain(section.title)}")
        for exhibit in section.exhibits:
            print(f"    {exhibit.label}: {plain(exhibit.title)}")
        print("    runs: " + ", ".join(case.name for case in section.cases))
    print(OTHER_EXHIBITS)


def chosen(names):
    known = [section.key for section in SECTIONS]
    for name in names or ():
        if name not in known:
            print(f"reproduce: there is no problem '{name}'; known are {', '.join(known)}", file=sys.stderr)
            sys.exit(2)
    return [section for section in SECTIONS if not names or section.key in names]


def main():
    parser = argparse.ArgumentParser(prog="brisance reproduce")
    parser.add_argument("--program", required=True)
    parser.add_argument("--inputs", required=True, help="the folder of the scenes")
    parser.add_argument("--out", default="reproduce")
    parser.add_argument("--only", nargs="+")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--list", action="store_true")
    given = parser.parse_args()
    if given.list:
        show_list()
        return 0
    sections = chosen(given.only)
    plt.rcParams.update(STYLE)
    try:
        os.makedirs(given.out, exist_ok=True)
    except OSError as problem:
        print(f"reproduce: cannot make {given.out}: {problem.strerror}", file=sys.stderr)
        return 2
    runner = Runner(given.program, given.inputs, given.out, given.quick)
    cases = [case for section in sections for case in section.cases]
    results = Results()
    for k, case in enumerate(cases):
        results[case.name] = runner.result(case, f"[{k + 1}/{len(cases)}]")

    version = subprocess.run([given.program, "--version"], capture_output=True, text=True).stdout
    path = os.path.join(given.out, "reproduce.html")
    write_page(path, TITLE, INTRODUCTION, sections, results, (OTHER_EXHIBITS, misprints_part()),
        version.strip())
    count = outcome(sections, results)
    print(f"{count[REACHED]} tables and figures reproduced, {count[MISSED]} missed, {count[ABSENT]} missing: "
          f"see {path}")
    return 0 if count[MISSED] + count[ABSENT] == 0 else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (KeyboardInterrupt, Interrupted):
        print("reproduce: stopped", file=sys.stderr)
        sys.exit(130)
