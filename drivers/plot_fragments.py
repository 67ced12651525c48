"""The pieces into which a solid has broken: how many are heavier than a mass, how fast they fly and of
which shape they are."""
import os

from plot_run import BLUE, GREY, INK, RED, np, plt, prefixed, read_csv


def draw_fragments(run):
    path = run.path("fragments.csv")
    if not run.is_last or not os.path.exists(path):
        return
    table = read_csv(path, ("time", "mass", "velocity_x", "velocity_y", "length", "width"))
    times = np.unique(table["time"])
    fig, (left, right) = plt.subplots(1, 2, figsize=(10.5, 5))
    for time in times:
        mass = np.sort(table["mass"][table["time"] == time])[::-1]
        last = time == times[-1]
        # From one piece to the next the number steps up: N pieces weigh as much as the Nth or more.
        left.step(mass, np.arange(1, len(mass) + 1), where="post", color=RED if last else GREY,
                  lw=1.8 if last else 0.6, alpha=1 if last else 0.35, zorder=3 if last else 2)
    for colour, time in ((GREY, times[:-1]), (RED, times[-1:])):
        if len(time):
            shown, _, unit = prefixed(time, "s")
            label = f"t = {shown[0]:.4g}" + (f" to {shown[-1]:.4g}" if len(time) > 1 else "") + f" {unit}"
            left.plot([], [], color=colour, label=label)
    left.set(xscale="log", yscale="log", xlabel="mass m [kg]", ylabel="pieces of mass m or more")
    left.legend(ncol=2, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)

    now = table["time"] == times[-1]
    speed, _, unit = prefixed(np.hypot(table["velocity_x"], table["velocity_y"])[now], "m/s")
    mass, length, width = (table[name][now] for name in ("mass", "length", "width"))
    slender = length > 2 * width
    for these, colour, label in ((~slender, BLUE, "chunky"), (slender, INK, "longer than two widths")):
        if run.is_line:  # which knows no width
            colour, label = BLUE, None
        right.plot(mass[these], speed[these], "o", ms=5, mew=0.5, mec="white", color=colour, label=label)
    right.set(xscale="log", xlabel="mass [kg]", ylabel=f"speed of the centre [{unit}]",
              ylim=(0, 1.08 * speed.max() or 1))
    if not run.is_line:
        right.legend(ncol=2, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)
    fig.tight_layout(rect=(0, 0, 0.99, 0.9), w_pad=3)
    run.save(fig, "fragments")
