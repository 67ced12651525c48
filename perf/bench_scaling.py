"""How the benchmarks gain from threads: a table, scaling.csv and scaling.png."""
import os

from bench_files import make_folder, measure, origin, present

PATTERN = r"^(machine|kernel/linear FLIP by cell|kernel/quadratic|kernel/sort|step/.*/[0-9]{3}/|weak)"


def thread_counts(most):
    """1, 2, 4, ... and the most."""
    counts = [1]
    while counts[-1] * 2 < most:
        counts.append(counts[-1] * 2)
    return counts if most == 1 else [*counts, most]


def rows_of(runs):
    """One for each benchmark and number of threads. Weak: names with boxes that grow with the threads."""
    def key(name):
        return name.rsplit("/", 1)[0] if name.startswith("weak/") else name

    start, rows = None, []
    for threads, results in runs:
        named = {key(name): result for name, result in results.items()}
        start = start or named
        triad = named.get("machine/triad")
        for name, result in named.items():
            if name not in start:
                continue
            gain = result.rate / start[name].rate
            rows.append({
                "benchmark": name, "scaling": "weak" if name.startswith("weak/") else "strong", "threads": threads,
                "rate": result.rate, "unit": result.unit, "speed-up": gain, "efficiency": gain / threads,
                "noise": result.noise, "GB/s": result.count("GB/s"),
                "share of triad": result.count("GB/s") / triad.rate if triad else float("nan")})
    return rows


def table(rows):
    width = max(len(row["benchmark"]) for row in rows)
    lines = [f"{'benchmark':{width}}  threads        rate  {'unit':16}  speed-up  efficiency  noise  of triad"]
    for row in sorted(rows, key=lambda row: (row["scaling"], row["benchmark"], row["threads"])):
        share = row["share of triad"]
        lines.append(f"{row['benchmark']:{width}}  {row['threads']:7}  {row['rate']:10.4g}  {row['unit']:16}  "
                     f"{row['speed-up']:8.2f}  {100 * row['efficiency']:8.0f} %  {100 * row['noise']:3.0f} %"
                     + (f"  {100 * share:6.0f} %" if share == share else ""))
    return "\n".join(lines)


def draw(rows, context, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    fig, panels = plt.subplots(1, 2, figsize=(11, 5.2), sharey=True)
    threads = sorted({row["threads"] for row in rows})
    for panel, scaling in zip(panels, ("strong", "weak")):
        panel.plot(threads, threads, "--", color="#9aa5ad", lw=1, label="ideal")
        names = sorted({row["benchmark"] for row in rows if row["scaling"] == scaling})
        colours = plt.get_cmap("tab20").colors
        for k, name in enumerate(names):
            some = [row for row in rows if row["benchmark"] == name]
            panel.plot([row["threads"] for row in some], [row["speed-up"] for row in some], ".-", ms=5, lw=1,
                       color=colours[k % len(colours)], label=name)
        panel.set(xscale="log", yscale="log", xlabel="threads", title=f"{scaling} scaling", xticks=threads)
        for axis in (panel.xaxis, panel.yaxis):
            axis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_formatter(plt.NullFormatter())
        panel.grid(color="#e3e7ea")
        panel.legend(fontsize=6.5, frameon=False)
    panels[0].set_ylabel("rate over that of one thread")
    fig.suptitle(origin(context), fontsize=9)
    fig.tight_layout()
    fig.savefig(path, dpi=150)


def scale(program, out, most, pattern, seconds):
    make_folder(out)
    runs, context = [], {}
    for threads in thread_counts(most):
        path = os.path.join(out, f"threads_{threads}.json")
        context, results = measure(program, pattern or PATTERN, threads, path, seconds)
        runs.append((threads, results))
    rows = rows_of(runs)
    print(table(rows))
    return present(out, "scaling", rows, context, lambda path: draw(rows, context, path))
