"""Draws the pictures of a finished or a still running run: python3 plot.py DIR [--frame N]

Reads what the run wrote into DIR and writes PNGs into DIR/pictures. What a picture lacks is named
in one line on stderr; the others are drawn all the same, and the status is 2.
"""
import argparse
import os
import sys

from plot_run import (BLUE, COLOURS, GREY, INK, MOST_DOTS, NAMES, NAVY, RED, STYLE, TEAL, UNITS, VIOLET,
                      Missing, Run, means, np, plt, prefixed, read_csv, value_range)
from matplotlib.colors import LogNorm, Normalize
from mpl_toolkits.axes_grid1 import make_axes_locatable

from plot_cracks import draw_cracks
from plot_fragments import draw_fragments
from plot_gauges import draw_gauges


# ---- Profiles over x or the radius ----
def draw_profiles(run, radial=False):
    """Radial ones only where an exact solution is a function of the radius."""
    particles, column, label = run.particles, "x", "x"
    where, velocity = run.x[:, 0], particles["velocity"][:, 0]
    exact, averages = run.table("exact.csv"), run.table("profile.csv")
    if radial:
        if exact is None or "r" not in exact:
            return
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


# ---- Fields in the plane ----
def draw_fields(run):
    particles, xy, volume = run.particles, run.x[:, :2], run.particles["volume"]
    values = {key: particles[key] for key in COLOURS}
    values["velocity"] = np.linalg.norm(particles["velocity"], axis=1)
    low, high = run.limits(xy)
    _, scale_x, unit_x = prefixed(high - low, "m")
    extent = np.maximum(high - low, 1e-3 * (high - low).max())
    aspect = extent[1] / extent[0]
    rows, columns = (4, 1) if aspect < 0.25 else (1, 4) if aspect > 2 else (2, 2)
    width = {1: 9.5, 2: 4.4, 4: max(7 / aspect, 1.5)}[columns]
    size = (columns * (width + 1.2), rows * (width * aspect + 0.7) + 0.7)
    fig, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, sharex=True, sharey=True)

    spacing = np.sqrt(volume)  # of particles that are one metre deep
    dots = np.argsort(-spacing)  # the wide ones lie below
    grids = None
    if len(xy) > MOST_DOTS:
        fine = max(extent.max() / 800, 2.5 * np.sqrt(extent.prod() / len(xy)))
        shape = np.ceil(extent / fine).astype(int)
        cell = np.clip(((xy - low) / fine).astype(int), 0, shape - 1)
        cell = cell[:, 0] * shape[1] + cell[:, 1]
        grids = means(particles, values["velocity"], cell, shape.prod())
        box = np.array((low, low + shape * fine)).T.ravel() / scale_x
        dots = dots[spacing[dots] > 0.45 * fine][:MOST_DOTS]  # show through the holes of the image
    drawn = []
    for ax, (key, colour_map) in zip(axes.flat, COLOURS.items()):
        bottom, top, decades = value_range(values[key], volume)
        _, scale, unit = prefixed(top, UNITS[key])
        norm = Normalize((0 if key == "velocity" else bottom) / scale, top / scale)
        if key == "energy" and decades:
            norm = LogNorm(max(bottom, 1e-4 * top) / scale, top / scale)
        style = {"norm": norm, "cmap": colour_map}
        # Where particles are drawn apart in one direction, broad squares below fill the gaps.
        for breadth in (2.5, 1.2):
            squares = ax.scatter(*xy[dots].T / scale_x, c=values[key][dots] / scale, marker="s",
                                 linewidths=0, **style)
            drawn.append((squares, breadth))
        if grids is not None:
            image = grids[key].reshape(shape).T / scale
            ax.imshow(image, origin="lower", extent=box, zorder=2, **style)
        (left, below), (right, above) = low / scale_x, high / scale_x
        ax.set(xlim=(left, right), ylim=(below, above), aspect="equal", facecolor="#eef1f3")
        name = "speed" if key == "velocity" else NAMES.get(key, key)
        ax.set_title(f"{name} [{unit}]")
        ax.grid(False)
        bar = make_axes_locatable(ax).append_axes("right", size=0.12, pad=0.08)
        clipped = values[key].max() > 1.01 * top
        fig.colorbar(squares, cax=bar, extend="max" if clipped else "neither", extendfrac=0.03)
    plt.setp(axes[-1], xlabel=f"x [{unit_x}]")
    plt.setp(axes[:, 0], ylabel=f"y [{unit_x}]")
    fig.tight_layout(rect=(0, 0, 0.995, 1 - 0.68 / size[1]))
    fig.canvas.draw()
    width = axes.flat[0].get_window_extent().width * 72 / fig.dpi
    points = width / extent[0]  # that a metre takes on paper
    for squares, breadth in drawn:
        squares.set_sizes(np.maximum(breadth * points * spacing[dots], 0.8) ** 2)
    run.save(fig, "fields")


def draw_particles(run):
    run.load()
    shown = ("velocity", "mass", "volume", *COLOURS)
    if run.is_line:
        if run.has("profiles", shown):
            draw_profiles(run)
    else:
        if run.has("fields", shown):
            draw_fields(run)
            draw_profiles(run, radial=True)
        if "volume" in run.particles and "material" in run.particles:
            draw_cracks(run)
    draw_fragments(run)


# ---- History ----
def draw_materials(ax, table, materials, time, scale, unit):
    for name, colour in zip(materials, (BLUE, RED, TEAL, VIOLET, GREY, NAVY) * len(materials)):
        label = name.replace("_", " ")
        ax.plot(time, table["kinetic_" + name] / scale, color=colour, lw=1.8, label=label + ", kinetic")
        ax.plot(time, table["internal_" + name] / scale, color=colour, lw=1.4, ls="--",
                label=label + ", internal")
    ax.set(ylabel=f"energy [{unit}]")
    ax.legend(ncol=4, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)


def draw_history(run):
    energies, errors = ("total", "internal", "kinetic"), ("energy", "momentum", "mass")
    needed = ("time", *energies, *(key + "_error" for key in errors))
    table = read_csv(run.path("history.csv"), needed)
    time, _, unit_t = prefixed(table["time"], "s")
    _, scale, unit = prefixed(table["total"], "J")
    unit += {"line": "/m$^2$", "plane strain": "/m"}.get(run.geometry, "")
    materials = [key[len("kinetic_"):] for key in table if key.startswith("kinetic_")]
    rows = 3 if len(materials) > 1 else 2
    fig, axes = plt.subplots(rows, 1, figsize=(8.5, 1 + 3 * rows), sharex=True)
    upper, lower = axes[0], axes[-1]
    for key, colour in zip(energies, (INK, RED, TEAL)):
        upper.plot(time, table[key] / scale, color=colour, lw=1.8, label=key)
    # Parts of the internal energy of solids, where they can be seen.
    for key, style in (("elastic", "--"), ("plastic", "-."), ("damage", ":"), ("decohesion", ":")):
        if key in table and table[key].max() > 2e-3 * table["total"].max():
            upper.plot(time, table[key] / scale, color=GREY, lw=1.4, ls=style, label=key)
    if rows > 2:
        draw_materials(axes[1], table, materials, time, scale, unit)
    for key, colour in zip(errors, (RED, TEAL, VIOLET)):
        # A logarithm knows no 0: what is conserved to the last digit runs along the bottom.
        error = np.maximum(np.abs(table[key + "_error"]), 1e-17)
        lower.semilogy(time, error, color=colour, lw=1.4, label=key)
    lower.axhline(2.2e-16, color=GREY, lw=0.9, ls=":", label="rounding")
    upper.set(ylabel=f"energy [{unit}]", ylim=(min(0, upper.get_ylim()[0]), None))
    lower.set(ylabel="error of conservation [-]", xlabel=f"time [{unit_t}]")
    lower.set(ylim=(6e-18, max(1e-12, 10 * lower.get_ylim()[1])))
    lower.set_xlim(time[0], time[-1] if len(time) > 1 else None)
    upper.legend(ncol=6, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)
    lower.legend(ncol=4, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)
    fig.tight_layout(rect=(0, 0, 0.99, 1 - 0.65 / fig.get_figheight()), h_pad=1.2)
    run.save(fig, "history")


def main():
    parser = argparse.ArgumentParser(description="Draws pictures of a run into DIR/pictures.")
    parser.add_argument("folder", metavar="DIR", help="where the run wrote its results")
    parser.add_argument("--frame", type=int, metavar="N", help="a particle file, not the last")
    given = parser.parse_args()
    plt.rcParams.update(STYLE)
    if not os.path.isdir(given.folder):
        print(f"plot: no folder {given.folder}", file=sys.stderr)
        return 2
    run = Run(given.folder, given.frame)
    status = 0
    of_times = (draw_history, draw_gauges) if given.frame is None else ()
    for draw in (draw_particles, *of_times):
        try:
            draw(run)
        except Missing as missing:
            print(f"plot: {missing}", file=sys.stderr)
            status = 2
    return status


if __name__ == "__main__":
    sys.exit(main())
