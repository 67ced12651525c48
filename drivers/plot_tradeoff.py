"""Error against cost: a panel for each scene, all settings, the front, and the presets with their resolutions."""
import argparse
import csv
import math
import sys

from plot_run import GREY, INK, NAVY, RED, STYLE, TEAL, VIOLET, Missing, keep, plt

# Colour, marker, and where the resolutions stand beside it [points]: lines of presets are often close together.
PRESETS = {"paper": (GREY, "X", (5, 4)), "fast": (TEAL, "^", (-14, -10)), "balanced": (NAVY, "o", (4, -11)),
           "accurate": (RED, "s", (5, 4))}
PANEL = 4.1, 3.3  # inches


def read_points(path):
    """The rows with an error, by scene."""
    scenes = {}
    try:
        with open(path, newline="") as file:
            for row in csv.DictReader(file):
                if row["error [-]"]:
                    scenes.setdefault(row["scene"], []).append(row)
    except OSError as problem:
        raise Missing(f"cannot read {path}: {problem.strerror}") from None
    return scenes


def cost(row):
    return float(row["core time [s]"])


def per_cent(row):
    return 100 * float(row["error [-]"])


def line(panel, rows, **looks):
    rows = sorted(rows, key=cost)
    panel.plot([cost(row) for row in rows], [per_cent(row) for row in rows], **looks)


def plain_numbers(axis):
    axis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:g}"))
    low, high = axis.get_view_interval()
    decades = math.log10(high / low)
    between = "235" if decades < 1 else "25" if decades < 1.6 else ""
    axis.set_minor_formatter(plt.FuncFormatter(
        lambda value, _: f"{value:g}" if f"{value:e}"[0] in between else ""))


def draw_scene(panel, scene, rows):
    for preset, (colour, _, _) in PRESETS.items():
        line(panel, [row for row in rows if row["preset"] == preset],
             ls="", marker=".", ms=4, color=colour, alpha=0.35)
    line(panel, [row for row in rows if float(row["cost over front [-]"]) <= 1],
         color=VIOLET, lw=4, alpha=0.3, solid_capstyle="round", label="front")
    for preset, (colour, marker, beside) in PRESETS.items():
        alone = [row for row in rows if row["preset"] == preset and row["preset alone"] == "yes"]
        line(panel, alone, marker=marker, ms=7, lw=1, color=colour, mec="white", mew=0.8, label=preset)
        for row in alone:
            panel.annotate("×" + row["resolution [-]"], (cost(row), per_cent(row)), xytext=beside,
                           textcoords="offset points", size=7.5, color=colour)
    panel.set(xscale="log", yscale="log", title=scene)
    panel.margins(0.1)
    panel.autoscale_view()
    for axis in (panel.xaxis, panel.yaxis):
        plain_numbers(axis)


def draw(table, picture):
    scenes = read_points(table)
    if not scenes:
        raise Missing(f"no setting in {table} has a result")
    plt.rcParams.update(STYLE)
    columns = min(3, len(scenes))
    lines = math.ceil(len(scenes) / columns)
    height = PANEL[1] * lines + 0.9
    fig, panels = plt.subplots(lines, columns, figsize=(max(6.5, PANEL[0] * columns), height), squeeze=False)
    for panel in panels.flat[len(scenes):]:
        panel.set_axis_off()
    for panel, (scene, rows) in zip(panels.flat, scenes.items()):
        draw_scene(panel, scene, rows)
    for panel in panels[:, 0]:
        panel.set_ylabel("error [%]")
    for column in range(columns):
        panels[(len(scenes) - 1 - column) // columns, column].set_xlabel("time of one core [s]")
    fig.tight_layout(rect=(0, 0, 1, 1 - 0.8 / height))
    fig.text(0.02, 1 - 0.12 / height, "What an error costs: presets, and all settings beside them", va="top",
             size=13, weight="bold", color=INK)
    fig.legend(*panels[0, 0].get_legend_handles_labels(), ncol=5, loc="upper left",
               bbox_to_anchor=(0.01, 1 - 0.38 / height))
    keep(fig, picture, "")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("table", help="tradeoff.csv")
    parser.add_argument("picture", help="the picture to write")
    given = parser.parse_args()
    try:
        draw(given.table, given.picture)
    except Missing as missing:
        print(f"plot: {missing}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
