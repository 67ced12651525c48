"""The pictures that a run gives without being asked for anything special."""
import sys

from plot_cracks import draw_cracks
from plot_files import Missing, Mistake, NotWritten
from plot_fragments import draw_fragments
from plot_gauges import draw_gauges
from plot_history import draw_history
from plot_maps import draw_maps
from plot_profiles import draw_profiles

OF_TIMES = {"history": draw_history, "gauges": draw_gauges}  # of the whole run
LACKS = {"fields": "no particles", "profiles": "no exact solution over the radius at that time",
         "cracks": "no concrete that comes apart", "fragments": "no list 'fragments', or not at that time",
         "history": "no history", "gauges": "no list 'gauges'"}


def of_particles(run):
    """Pictures of one output, by name. On a line fields are profiles."""
    if run.is_line:
        return {"profiles": draw_profiles, "cracks": lambda run: None, "fragments": draw_fragments}
    return {"fields": draw_maps, "profiles": lambda run: draw_profiles(run, radial=True),
            "cracks": draw_cracks, "fragments": draw_fragments}


def draw_usual(run, what, numbers):
    """`what`: names, empty for all that there are; `numbers`: outputs, empty for the last. What a picture
    lacks is told, and the others are drawn all the same. Returns whether nothing was missing; what the run
    was not to write is so only where it was asked for by name."""
    wanted = ["profiles" if run.is_line and name == "fields" else name for name in what]
    whole = True
    for number in numbers or [None]:
        run.frame = number
        try:
            pictures = of_particles(run)
            if not wanted or set(wanted) & set(pictures):
                run.load()
        except Missing as missing:
            print(f"plot: {missing}", file=sys.stderr)
            pictures, whole = {}, False
        if number is None or wanted:
            pictures = {**pictures, **OF_TIMES}
        for name, draw in pictures.items():
            if wanted and name not in wanted:
                continue
            before = len(run.drawn)
            try:
                draw(run)
                if wanted and len(run.drawn) == before:
                    raise Mistake(f"no {name} of '{run.folder}': it has {LACKS[name]}")
            except NotWritten as lacking:
                print(f"plot: no picture '{name}': {lacking}", file=sys.stderr)
                whole &= not wanted
            except Missing as missing:
                print(f"plot: {missing}", file=sys.stderr)
                whole = False
    return whole
