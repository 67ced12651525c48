"""How time and memory grow with the number of particles: a table, sizes.csv and sizes.png."""
import math
import os

from bench_files import Missing, make_folder, measure, origin, present

PATTERN = r"^size/(paper|balanced)/"
SMALLEST = 1e4
PER_CELL = 4
REPETITIONS = 3  # the largest boxes take half a minute each


def edges(largest):
    """Cells along the edge of boxes, two in each decade of particles."""
    count = math.floor(2 * math.log10(largest / SMALLEST) + 1e-9) + 1 if largest >= SMALLEST else 0
    if count < 2:
        raise Missing(f"--largest must be at least {SMALLEST * math.sqrt(10):.0f} particles")
    return [round(math.sqrt(SMALLEST * 10 ** (k / 2) / PER_CELL)) for k in range(count)]


def rows_of(results, threads):
    rows = []
    for name, result in results.items():
        rows.append({
            "benchmark": name.rsplit("/", 1)[0], "particles": round(result.count("particles")), "threads": threads,
            "ns/particle-step": 1e9 / result.rate, "noise": result.noise,
            "peak bytes/particle": result.count("peak bytes/particle")})
    return sorted(rows, key=lambda row: (row["benchmark"], row["particles"]))


def table(rows):
    width = max(len(row["benchmark"]) for row in rows)
    lines = [f"{'benchmark':{width}}  particles  ns/particle-step  noise  peak bytes/particle"]
    for row in rows:
        lines.append(f"{row['benchmark']:{width}}  {row['particles']:9}  {row['ns/particle-step']:16.1f}  "
                     f"{100 * row['noise']:3.0f} %  {row['peak bytes/particle']:19.0f}")
    return "\n".join(lines)


def draw(rows, context, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    fig, panels = plt.subplots(2, 1, figsize=(7, 7), sharex=True)
    for panel, key, label in zip(panels, ("ns/particle-step", "peak bytes/particle"),
                                 ("time of a particle-step, ns", "peak memory of a particle, bytes")):
        for name in sorted({row["benchmark"] for row in rows}):
            some = [row for row in rows if row["benchmark"] == name]
            spread = [0.5 * row["noise"] * row[key] for row in some] if key.startswith("ns") else None
            panel.errorbar([row["particles"] for row in some], [row[key] for row in some], spread, fmt=".-", ms=6, lw=1,
                           capsize=2, label=name.split("/", 1)[1])
        panel.set(xscale="log", ylabel=label)
        panel.set_ylim(bottom=0)
        panel.grid(color="#e3e7ea")
        panel.legend(frameon=False)
    panels[1].set_xlabel("particles")
    fig.suptitle(origin(context, rows[0]["threads"]), fontsize=9)
    fig.tight_layout()
    fig.savefig(path, dpi=150)


def grow(program, out, threads, pattern, seconds, largest):
    cells = "--cells=" + ",".join(str(n) for n in edges(largest))
    make_folder(out)
    context, results = measure(program, pattern or PATTERN, threads, os.path.join(out, "sizes.json"), seconds,
                               REPETITIONS, [cells])
    rows = rows_of(results, threads)
    print(table(rows))
    return present(out, "sizes", rows, context, lambda path: draw(rows, context, path))
