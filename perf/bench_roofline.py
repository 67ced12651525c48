"""What steps have to do in a second, beside what the machine can: a table, roofline.csv and roofline.png."""
import os

from bench_files import Missing, make_folder, measure, origin, present

PATTERN = r"^step/.*/500/"
BANDWIDTH, ARITHMETIC = "machine/triad", "machine/multiply and add"


def rows_of(results, threads):
    for name in (BANDWIDTH, ARITHMETIC):
        if name not in results:
            raise Missing(f"'{name}' was not measured")
    triad, peak = results[BANDWIDTH].rate, results[ARITHMETIC].rate
    rows = []
    for name, result in results.items():
        flops, bytes_ = result.count("GFLOP/s"), result.count("GB/s")
        if name in (BANDWIDTH, ARITHMETIC) or not (flops > 0 and bytes_ > 0):
            continue
        roof = min(peak, triad * flops / bytes_)
        rows.append({
            "benchmark": name, "threads": threads, "rate": result.rate, "unit": result.unit, "noise": result.noise,
            "FLOP/B": flops / bytes_, "GFLOP/s": flops, "GB/s": bytes_, "roof, GFLOP/s": roof,
            "share of roof": flops / roof, "triad, GB/s": triad, "multiply and add, GFLOP/s": peak})
    if not rows:
        raise Missing("no benchmark of these counts both GB/s and GFLOP/s")
    return rows


def table(rows):
    first = rows[0]
    width = max(len(row["benchmark"]) for row in rows)
    lines = [f"machine: triad {first['triad, GB/s']:.1f} GB/s, multiply and add "
             f"{first['multiply and add, GFLOP/s']:.1f} GFLOP/s",
             f"{'benchmark':{width}}        rate  {'unit':16}  noise  FLOP/B  GFLOP/s    GB/s  of triad  of peak  "
             "of roof"]
    for row in rows:
        lines.append(f"{row['benchmark']:{width}}  {row['rate']:10.4g}  {row['unit']:16}  {100 * row['noise']:3.0f} %  "
                     f"{row['FLOP/B']:6.2f}  {row['GFLOP/s']:7.2f}  {row['GB/s']:6.2f}  "
                     f"{100 * row['GB/s'] / row['triad, GB/s']:6.0f} %  "
                     f"{100 * row['GFLOP/s'] / row['multiply and add, GFLOP/s']:5.0f} %  "
                     f"{100 * row['share of roof']:5.0f} %")
    return "\n".join(lines)


def draw(rows, context, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    triad, peak = rows[0]["triad, GB/s"], rows[0]["multiply and add, GFLOP/s"]
    fig, panel = plt.subplots(figsize=(9, 4.8))
    intensities = [row["FLOP/B"] for row in rows]
    low, high = 0.5 * min(intensities + [peak / triad]), 2 * max(intensities + [peak / triad])
    panel.plot([low, peak / triad, high], [low * triad, peak, peak], color="#3b4750", lw=1.5,
               label=f"triad {triad:.1f} GB/s, multiply and add {peak:.0f} GFLOP/s")
    colours = plt.get_cmap("tab10").colors
    for k, row in enumerate(rows):
        panel.plot(row["FLOP/B"], row["GFLOP/s"], "o", color=colours[k % len(colours)],
                   label=f"{row['benchmark']}: {100 * row['share of roof']:.0f} % of the roof")
    panel.set(xscale="log", yscale="log", xlabel="operations per byte that a step cannot do without, FLOP/B",
              ylabel="GFLOP/s")
    for axis in (panel.xaxis, panel.yaxis):
        axis.set_major_locator(plt.LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(plt.NullFormatter())
    panel.grid(color="#e3e7ea", which="both", lw=0.5)
    panel.legend(fontsize=7, frameon=False, loc="upper left", bbox_to_anchor=(1.01, 1))
    fig.suptitle(origin(context, rows[0]["threads"]), fontsize=9)
    fig.tight_layout()
    fig.savefig(path, dpi=150)


def place(program, out, threads, pattern, seconds):
    make_folder(out)
    names = f"^({BANDWIDTH}|{ARITHMETIC})|{pattern or PATTERN}"
    context, results = measure(program, names, threads, os.path.join(out, "roofline.json"), seconds)
    rows = rows_of(results, threads)
    print(table(rows))
    return present(out, "roofline", rows, context, lambda path: draw(rows, context, path))
