"""Draws pictures of finished and of running runs; says in one line what is wrong or missing. The status
is 0 if all was drawn, 2 if what was asked for cannot be meant, 1 if something is missing."""
import os
import sys

from plot_options import asked

given = asked()  # before the libraries, which take their time

from plot_animation import animate
from plot_field import draw_field, nearest
from plot_files import Missing, Mistake
from plot_run import STYLE, Run, plt
from plot_usual import draw_usual


def draw():
    """Returns whether nothing was missing."""
    plt.rcParams.update(STYLE)
    if given.field:
        runs = [Run(folder, out=given.out) for folder in given.folders]
        for name in given.field:
            (animate if given.animate else draw_field)(runs, name, given.time, given.range, given.log)
        return True
    whole = True
    for folder in given.folders:
        out = given.out
        if out and len(given.folders) > 1:
            out = os.path.join(out, os.path.basename(os.path.abspath(folder)))
        run = Run(folder, out=out)
        whole &= draw_usual(run, given.what, [nearest(run, time) for time in given.time])
    return whole


def main():
    try:
        return 0 if draw() else 1
    except KeyboardInterrupt:
        return 130
    except (Missing, Mistake) as problem:
        print(f"plot: {problem}", file=sys.stderr)
        return 2 if isinstance(problem, Mistake) else 1


if __name__ == "__main__":
    sys.exit(main())
