"""Density, velocity, pressure and energy over x or the radius, beside the exact solution where there is
one."""
from plot_run import (BLUE, NAMES, NAVY, RED, UNITS, means, np, plt, prefixed, value_range)

MOST_DOTS = 300_000


def draw_profiles(run, radial=False):
    """Radial ones only where an exact solution is a function of the radius."""
    exact, averages = run.table("exact.csv"), run.table("profile.csv")
    if radial and (exact is None or "r" not in exact):
        return
    run.expect(("mass", "volume", *UNITS))
    particles, column, label = run.particles, "x", "x"
    where, velocity = run.x[:, 0], particles["velocity"][:, 0]
    if radial:
        column, label = "r", "radius"
        away = run.x[:, :2] - run.centre
        where = np.hypot(*away.T)
        velocity = (particles["velocity"][:, :2] * away).sum(axis=1) / np.maximum(where, 1e-300)
    low, high = run.limits(where)
    if run.cell and column not in (averages or ()):
        bins = ((where - low) / run.cell).astype(int)
        averages = means(particles, velocity, bins, bins.max() + 1)
        averages[column] = low + (0.5 + np.arange(bins.max() + 1)) * run.cell
    some = np.random.default_rng(0).permutation(len(where))[:MOST_DOTS]
    _, scale_x, unit_x = prefixed(high, "m")

    fig, axes = plt.subplots(2, 2, figsize=(10.5, 7.4), sharex=True)
    for ax, (key, unit) in zip(axes.flat, UNITS.items()):
        values = velocity if key == "velocity" else particles[key]
        shown, scale, unit = prefixed(values, unit)
        ax.plot([], [], ".", ms=5, color=BLUE, label="particles")
        ax.plot(where[some] / scale_x, shown[some], ".", ms=3.6 if len(some) < 5000 else 1.8, mew=0,
                color=BLUE, alpha=0.7, rasterized=True)
        if averages is not None and column in averages:
            ax.plot(averages[column] / scale_x, averages[key] / scale, "o", ms=3.2, mfc="white",
                    mec=NAVY, mew=0.8, label=("shell" if radial else "cell") + " averages")
        if exact is not None:
            ax.plot(exact[column] / scale_x, exact[key] / scale, color=RED, lw=1.3, label="exact")
        if key == "energy" and value_range(values, particles["volume"])[2]:
            ax.set(yscale="log", ylim=(np.nanmin(shown) / 2, np.nanmax(shown) * 2))
        bottom, top = ax.get_ylim()
        if top - bottom < 1e-6 * abs(top):  # the same everywhere but for rounding
            ax.set_ylim(bottom - 1e-3 * abs(top), top + 1e-3 * abs(top))
        name = "radial velocity" if radial and key == "velocity" else NAMES.get(key, key)
        ax.set(ylabel=f"{name} [{unit}]", xlim=((0 if radial else low) / scale_x, high / scale_x))
    plt.setp(axes[1], xlabel=f"{label} [{unit_x}]")
    legend = axes.flat[0].get_legend_handles_labels()
    fig.legend(*legend, loc="upper right", ncol=3, markerscale=1.6)
    fig.tight_layout(rect=(0, 0, 0.995, 0.91), h_pad=1.5, w_pad=2)
    run.save(fig, "radial" if radial else "profiles")
