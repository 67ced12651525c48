"""What ./brisance bench does around the benchmarks themselves."""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import bench_roofline  # noqa: E402
import bench_scaling  # noqa: E402
import bench_sizes  # noqa: E402
from bench_compare import compare  # noqa: E402
from bench_files import Missing  # noqa: E402


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
    parser = Options(prog="brisance bench", description=__doc__,
                     epilog="Without one of the first four, all words go to Google Benchmark: "
                            "--benchmark_filter=step, --benchmark_list_tests, ...; --cells=100,200 adds boxes of gas "
                            "of so many cells along an edge, size/PRESET/N.")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--scaling", action="store_true", help="measure on 1, 2, 4, ... threads")
    what.add_argument("--sizes", action="store_true",
                      help="time and memory of a particle in boxes of 1e4 to 1e7; minutes")
    what.add_argument("--roofline", action="store_true",
                      help="what steps have to do, beside what the machine can do in the same call; minutes")
    what.add_argument("--compare", nargs=2, metavar=("A.json", "B.json"),
                      help="of two builds, each from --benchmark_out=FILE --benchmark_repetitions=5")
    parser.add_argument("--program", default="", help=argparse.SUPPRESS)
    parser.add_argument("--out", default="out/bench", help="folder of table and picture (default: out/bench)")
    parser.add_argument("--threads", type=positive(int), default=len(os.sched_getaffinity(0)),
                        help="of --scaling the most (default: all)")
    parser.add_argument("--filter", help="names of the benchmarks: a regular expression")
    parser.add_argument("--seconds", type=positive(float), default=0.2, help="for each repetition at least")
    parser.add_argument("--largest", type=positive(float), default=1e7, help="particles of --sizes (default: 1e7)")
    given = parser.parse_args()
    try:
        if given.compare:
            return compare(*given.compare)
        if given.sizes:
            return bench_sizes.grow(given.program, given.out, given.threads, given.filter, given.seconds,
                                    given.largest)
        work = bench_roofline.place if given.roofline else bench_scaling.scale
        return work(given.program, given.out, given.threads, given.filter, given.seconds)
    except Missing as missing:
        print(f"brisance: {missing}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
