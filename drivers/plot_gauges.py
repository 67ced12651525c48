"""What gauges have seen: pressure and impulse against time."""
import os

from plot_run import BLUE, GREY, NAVY, RED, TEAL, VIOLET, np, plt, prefixed, read_csv


def draw_gauges(run):
    if not os.path.exists(run.path("gauges.csv")):
        return
    table = read_csv(run.path("gauges.csv"), ("time",))
    gauges = [key[len("pressure_"):] for key in table if key.startswith("pressure_")]
    time, _, unit_t = prefixed(table["time"], "s")
    fig, axes = plt.subplots(2, 1, figsize=(8.5, 7), sharex=True)
    for ax, quantity, unit in ((axes[0], "pressure", "Pa"), (axes[1], "impulse", "Pa s")):
        _, scale, unit = prefixed(np.concatenate([table[f"{quantity}_{name}"] for name in gauges]), unit)
        for name, colour in zip(gauges, (NAVY, RED, TEAL, VIOLET, BLUE, GREY) * len(gauges)):
            ax.plot(time, table[f"{quantity}_{name}"] / scale, color=colour, lw=1.5,
                    label=name.replace("_", " "))
        ax.set(ylabel=f"{quantity} [{unit}]")
    axes[1].set(xlabel=f"time [{unit_t}]")
    axes[1].set_xlim(time[0], time[-1] if len(time) > 1 else None)
    axes[0].legend(ncol=6, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)
    fig.tight_layout(rect=(0, 0, 0.99, 0.91), h_pad=1.2)
    run.save(fig, "gauges")
