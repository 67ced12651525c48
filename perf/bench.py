"""What ./brisance bench does around the benchmarks themselves."""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from bench_compare import compare  # noqa: E402
from bench_files import Missing  # noqa: E402
from bench_scaling import PATTERN, scale  # noqa: E402


def positive(convert):
    def read(text):
        if not convert(text) > 0:
            raise ValueError
        return convert(text)
    read.__name__ = "number above 0"
    return read


class Options(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"brisance: bench: {message}\n")


def main():
    parser = Options(prog="brisance bench", description=__doc__)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--scaling", action="store_true", help="measure on 1, 2, 4, ... threads")
    what.add_argument("--compare", nargs=2, metavar=("A.json", "B.json"),
                      help="of two builds, each from --benchmark_out=FILE --benchmark_repetitions=5")
    parser.add_argument("--program", default="", help=argparse.SUPPRESS)
    parser.add_argument("--out", default="out/bench", help="folder of --scaling (default: out/bench)")
    parser.add_argument("--threads", type=positive(int), default=len(os.sched_getaffinity(0)),
                        help="the most of --scaling (default: all)")
    parser.add_argument("--filter", default=PATTERN, help="names of the benchmarks of --scaling: a regular expression")
    parser.add_argument("--seconds", type=positive(float), default=0.2, help="for each repetition at least")
    given = parser.parse_args()
    try:
        if given.compare:
            return compare(*given.compare)
        return scale(given.program, given.out, given.threads, given.filter, given.seconds)
    except Missing as missing:
        print(f"brisance: {missing}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
