"""Two results of the benchmarks, of two builds or two days: which are faster, which slower, beyond their noise."""
from bench_files import Missing, read

LEAST = 3  # repetitions, from which a range can be told
# What a machine does to a program from call to call that its repetitions, close together, do not show.
FLOOR = 0.02


def verdict(a, b):
    """Of two lists of rates."""
    if min(len(a.rates), len(b.rates)) < LEAST:
        return "too few repetitions"
    if abs(b.rate / a.rate - 1) <= max(FLOOR, a.noise, b.noise):
        return "same within noise"
    return "faster" if b.rate > a.rate else "SLOWER"


def compare(first, second):
    """Prints the table; 1 if anything is slower, else 0."""
    (of_a, a), (of_b, b) = read(first), read(second)
    for key in ("processor", "threads", "compiler"):
        if of_a.get(key) != of_b.get(key):
            print(f"not alike: {key} is '{of_a.get(key)}' in A, '{of_b.get(key)}' in B")
    print(f"A: {first}, commit {of_a.get('commit')}\nB: {second}, commit {of_b.get('commit')}")
    common = [name for name in a if name in b]
    if not common:
        raise Missing("the two files have no benchmark in common")
    width = max(len(name) for name in common)
    print(f"{'benchmark':{width}}  {'A':>10}  {'B':>10}  {'unit':16}  {'B over A':>8}  {'noise':>6}  verdict")
    verdicts = []
    for name in common:
        verdicts.append(verdict(a[name], b[name]))
        noise = max(a[name].noise, b[name].noise)
        print(f"{name:{width}}  {a[name].rate:10.4g}  {b[name].rate:10.4g}  {a[name].unit:16}  "
              f"{b[name].rate / a[name].rate:8.3f}  {100 * noise:4.0f} %  {verdicts[-1]}")
    for where, some, other in (("A", a, b), ("B", b, a)):
        alone = len([name for name in some if name not in other])
        if alone:
            print(f"only in {where}: {alone}")
    print(", ".join(f"{verdicts.count(kind)} {kind}" for kind in
                    ("faster", "same within noise", "SLOWER", "too few repetitions") if kind in verdicts))
    return 1 if "SLOWER" in verdicts else 0
