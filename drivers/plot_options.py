"""What the command line of plot asks for. Needs nothing but python, so that a mistake is told at once."""
import argparse
import math
import os
import re
import sys

FILMS = (".gif", ".mp4")
WHAT = ("fields", "profiles", "cracks", "fragments", "history", "gauges")


def is_file(out):
    """Whether a path is meant as one picture."""
    return os.path.splitext(out)[1].lower() in (".png", ".jpg", ".pdf", ".svg", *FILMS)


class Parser(argparse.ArgumentParser):
    """Tells a mistake in one line."""

    def error(self, message):
        self.exit(2, f"plot: {message}\n")


def times(text):
    try:
        values = [float(part) for part in text.split(",")]
    except ValueError:
        values = [math.nan]
    if not all(math.isfinite(value) for value in values):
        raise argparse.ArgumentTypeError(f"'{text}' must be seconds, as in 1e-4 or 1e-4,2e-4")
    return values


def parser():
    p = Parser(prog="brisance plot", description="Draws pictures of runs, without options all that there are, "
               "into DIR/pictures. Lengths, times and values are given in SI units.")
    p.add_argument("folders", metavar="DIR", nargs="+", help="folder of a run; of several, fields stand side "
                   "by side on one scale")
    p.add_argument("--field", action="append", metavar="NAME", default=[], help="draw this column of the "
                   "particles or of the grid ('grid NAME'), any number of times; an unknown name tells all")
    p.add_argument("--time", action="append", type=times, metavar="T", default=[], help="time of an output, the "
                   "nearest is taken (default: the last); several: T1,T2,...")
    p.add_argument("--range", nargs=2, type=float, metavar=("MIN", "MAX"), help="ends of the scale of the field")
    p.add_argument("--log", action="store_true", help="logarithmic scale of the field")
    p.add_argument("--animate", action="store_true", help="a film of the field over all outputs (default: of the "
                   "pressure): MP4 where the package ffmpeg is there, else GIF")
    p.add_argument("--what", action="append", choices=WHAT, default=[], help="only these of the usual pictures")
    p.add_argument("--out", metavar="PATH", help="another folder, or the file of the one picture")
    return p


def asked():
    """What the command line asks for; ends the program for what cannot be meant."""
    p = parser()
    # "-1e9" is a number, whatever argparse takes it for.
    number = re.compile(r"-\.?\d")
    given = p.parse_intermixed_args([" " + word if number.match(word) else word for word in sys.argv[1:]])
    given.time = [time for some in given.time for time in some]
    if given.animate and not given.field:
        given.field = ["pressure"]
    if given.what and given.field:
        p.error("--what chooses among the usual pictures: not with --field or --animate")
    if (given.range or given.log) and not given.field:
        p.error("--range and --log are of a field: name it with --field")
    if given.range and not -math.inf < given.range[0] < given.range[1] < math.inf:
        p.error("--range: MIN must be below MAX, both finite")
    one = len(given.field) == 1 or not given.field and (
        len(given.what) == 1 and len(given.folders) == 1 and len(given.time) < 2)
    if given.out and is_file(given.out):
        if not one:
            p.error(f"--out {given.out} is one file: ask for one picture, by --field or by --what")
        if given.animate != (os.path.splitext(given.out)[1].lower() in FILMS):
            p.error(f"--out {given.out}: .gif and .mp4 are for --animate, which writes nothing else")
    return given
