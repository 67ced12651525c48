"""Results of a sweep against a parameter that was varied: a panel for each result, a line for each combination
of the others."""
import argparse
import csv
import sys

from plot_run import BLUE, GREY, INK, NAVY, RED, STYLE, TEAL, VIOLET, Missing, np, plt, prefixed


def read_table(path):
    """The runs that are finished, each as a dictionary by the names at the table's head."""
    try:
        with open(path, newline="") as file:
            return [row for row in csv.DictReader(file) if row["status"] == "finished"]
    except OSError as problem:
        raise Missing(f"cannot read {path}: {problem.strerror}") from None


def split(label):
    """"charge radius [m]" -> "charge radius", "m"."""
    name, _, unit = label.partition(" [")
    return name, unit.rstrip("]")


def number(text):
    return float(text) if text else np.nan


def axis(values, label):
    """Values in a handy unit, and the label of their axis."""
    name, unit = split(label)
    values = np.array(values)
    if unit in ("", "cells") or not np.isfinite(values).any():
        return values, label
    values, _, unit = prefixed(values, unit)
    return values, f"{name} [{unit}]"


def draw(given):
    rows = read_table(given.table)
    if not rows:
        raise Missing(f"no run in {given.table} is finished")
    x, x_label = axis([number(row[given.x]) for row in rows], given.x)
    lines = {}
    for place, row in enumerate(rows):
        lines.setdefault(tuple(row[label] for label in given.by), []).append(place)
    plt.rcParams.update(STYLE)
    count = len(given.y)
    fig, panels = plt.subplots(count, 1, figsize=(7.5, 1.2 + 2.9 * count), sharex=True, squeeze=False)
    colours = (NAVY, RED, TEAL, VIOLET, BLUE, GREY)
    for panel, label in zip(panels[:, 0], given.y):
        y, y_label = axis([number(row[label]) for row in rows], label)
        for k, (values, places) in enumerate(lines.items()):
            order = sorted(places, key=lambda place: x[place])
            named = ", ".join(f"{split(by)[0]} = {value} {split(by)[1]}".strip()
                              for by, value in zip(given.by, values))
            panel.plot(x[order], y[order], "o-", ms=5, color=colours[k % len(colours)], label=named)
        panel.set_ylabel(y_label)
        if np.isfinite(y).any() and np.nanmin(y) >= 0:
            panel.set_ylim(0, 1.08 * np.nanmax(y) or 1)
    panels[-1, 0].set_xlabel(x_label)
    height = fig.get_figheight()
    if given.by:
        panels[0, 0].legend(ncol=3, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)
    fig.text(0.02, 1 - 0.12 / height, given.title, va="top", size=13, weight="bold", color=INK)
    fig.tight_layout(rect=(0, 0, 0.99, 1 - 0.45 / height))
    try:
        fig.savefig(given.picture)
    except OSError as problem:
        raise Missing(f"cannot write {given.picture}: {problem.strerror}") from None
    print(given.picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("table", help="batch.csv of a batch")
    parser.add_argument("picture", help="the picture to write")
    parser.add_argument("--title", default="")
    parser.add_argument("--x", required=True, help="head of the column of the parameter")
    parser.add_argument("--by", action="append", default=[], help="those of the other parameters")
    parser.add_argument("--y", action="append", required=True, help="those of the results")
    try:
        draw(parser.parse_args())
    except Missing as missing:
        print(f"plot: {missing}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
