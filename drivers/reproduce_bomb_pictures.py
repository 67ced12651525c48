"""Pictures of the bomb in the box. The paper's steps I to XIII are spread evenly over a run."""
from matplotlib.colors import LogNorm

import plot_fragments
from plot_run import GREY, INK, NAVY, RED, TEAL, VIOLET, Missing, Run, means, np, plt
from reproduce_box import Box
from reproduce_impact import failure, squares

ROMAN = {1: "I", 3: "III", 5: "V", 7: "VII", 9: "IX", 11: "XI", 13: "XIII"}
COLOURS = {"explosive": RED, "steel": NAVY, "concrete": "#9aa5ad"}
CENTRE = 1.0  # the paper's coordinates of the box's middle [m]


def at_step(result, step):
    """The output nearest to a step of the paper, and how its picture is called."""
    time = result.frames[-1] * (step - 1) / 12
    number = int(np.argmin(np.abs(np.array(result.frames) - time)))
    return Box(result, number), f"STEP {ROMAN[step]}, {1e6 * result.frames[number]:.0f} µs"


def draw_points(results, name):
    fig, axes = plt.subplots(2, 3, figsize=(11.5, 8.1), sharex=True, sharey=True)
    for ax, step in zip(axes.flat, (1, 3, 5, 7, 9, 11)):
        box, title = at_step(results[name], step)
        for kind, colour in COLOURS.items():
            there = getattr(box, kind)
            ax.scatter(*(box.xy[there] + CENTRE).T, s=2.2, c=colour, linewidths=0, label=kind)
        ax.set(xlim=(0, 2), ylim=(0, 2), aspect="equal")
        ax.set_title(title)
    plt.setp(axes[1], xlabel="x [m]")
    plt.setp(axes[:, 0], ylabel="y [m]")
    fig.legend(*axes.flat[0].get_legend_handles_labels(), loc="upper right", ncol=3, markerscale=4)
    fig.tight_layout(rect=(0, 0, 1, 0.95))
    return fig


def gas_pressure(box):
    """Means over cells of air and products; nan where there is neither."""
    cell, half = box.run.cell, 1.0
    gas = box.explosive | box.air
    place = ((box.xy[gas] + half) / cell).astype(int)
    count = int(round(2 * half / cell))
    inside = ((place >= 0) & (place < count)).all(axis=1)
    part = {key: values[gas][inside] for key, values in box.particles.items()
            if key in ("mass", "volume", "pressure", "energy")}
    bins = place[inside, 0] * count + place[inside, 1]
    return means(part, np.zeros(len(bins)), bins, count * count)["pressure"].reshape(count, count)


def draw_pressure(results):
    steps = (3, 5, 7, 11)
    fig, axes = plt.subplots(2, 4, figsize=(11.5, 5.3), sharex=True, sharey=True, layout="constrained")
    for row, name in zip(axes, ("bomb_cased", "bomb_bare")):
        for ax, step in zip(row, steps):
            box, title = at_step(results[name], step)
            image = ax.imshow(np.maximum(gas_pressure(box).T, 1e3) / 1e6, origin="lower", extent=(0, 2, 0, 2),
                cmap="inferno",
                              norm=LogNorm(0.1, 1e3))
            solid = box.steel | box.concrete
            ax.scatter(*(box.xy[solid] + CENTRE).T, s=0.7, c=GREY, linewidths=0)
            ax.set(xlim=(0, 2), ylim=(0, 2), facecolor="#f7f9fa")
            ax.set_title(title.split(", ")[1], fontsize=9.5)
            ax.grid(False)
        row[0].set_ylabel(("with case" if name == "bomb_cased" else "without case") + "\ny [m]")
    plt.setp(axes[1], xlabel="x [m]")
    fig.colorbar(image, ax=axes, shrink=0.75, label="pressure of air and products [MPa]")
    return fig


def draw_damage(results, name):
    fig, axes = plt.subplots(1, 2, figsize=(11, 5.1), sharey=True, layout="constrained")
    for ax, step in zip(axes, (7, 13)):
        box, title = at_step(results[name], step)
        xy, sides = box.xy + CENTRE, np.sqrt(box.particles["volume"])
        wall = box.concrete
        drawn = squares(ax, xy[wall], sides[wall], failure(box.particles)[wall], cmap="magma_r", clim=(0, 1))
        ax.scatter(*xy[box.steel].T, s=5, marker="s", c=GREY, linewidths=0)
        ax.set(xlim=(0.8, 1.8), ylim=(0.8, 1.8), xlabel="x [m]")
        ax.set_title(title)
    axes[0].set_ylabel("y [m]")
    fig.colorbar(drawn, ax=axes, fraction=0.05, pad=0.02, label="failure 1 − (1 − D)(1 − λ) [-]")
    return fig


def draw_case(results):
    result = results["bomb_cased"]
    boxes = [Box(result, k) for k in range(len(result.frames))]
    time = 1e6 * np.array(result.frames)
    fig, (left, right) = plt.subplots(1, 2, figsize=(11.5, 4.2))
    left.plot(time, [box.outward_velocity("steel") for box in boxes], "o-", ms=3.5, color=NAVY, lw=1.2)
    left.axhline(1327, color=RED, lw=1.1, label="one dimension, 1327 m/s")
    left.axhline(1362, color=TEAL, lw=1.1, ls="--", label="Gurney, 1362 m/s")
    left.set(xlabel="time [µs]", ylabel="mean outward speed of the case [m/s]", ylim=(0, None))
    left.legend(loc="lower right")
    right.plot(time, [1e-6 * box.kinetic("steel") for box in boxes], "o-", ms=3.5, color=NAVY, lw=1.2)
    right.set(xlabel="time [µs]", ylabel="kinetic energy of the case [MJ/m]", ylim=(0, None))
    fig.tight_layout()
    return fig


def draw_energies(results):
    """From the history, which tells the energies of each material."""
    fig, axes = plt.subplots(1, 2, figsize=(11.5, 4.6), sharey=True)
    for ax, name in zip(axes, ("bomb_cased", "bomb_bare")):
        table = results[name].table("history.csv", ("time", "total"))
        for (material, _), colour in zip(results[name].materials(), (RED, TEAL, NAVY, VIOLET, INK)):
            column = material.replace(" ", "_")
            if "kinetic_" + column not in table:
                raise Missing(f"the history of {name} has no energies of its materials")
            ax.plot(1e6 * table["time"], 1e-6 * table["kinetic_" + column], color=colour, lw=1.6,
                label=f"{material}, kinetic")
            ax.plot(1e6 * table["time"], 1e-6 * table["internal_" + column], color=colour, lw=1.2, ls="--",
                    label=f"{material}, internal")
        ax.plot(1e6 * table["time"], 1e-6 * table["total"], color=GREY, lw=1.1, ls=":", label="total")
        ax.set(title="with case" if name == "bomb_cased" else "without case", xlabel="time [µs]",
               ylim=(0, None))
    axes[0].set_ylabel("energy [MJ/m]")
    fig.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncol=5, fontsize=9)
    fig.tight_layout(rect=(0, 0.1, 1, 1))
    return fig


def draw_gauges(results):
    """Overpressure and impulse at the gauges that both runs have."""
    tables = [results[name].table("gauges.csv") for name in ("bomb_cased", "bomb_bare")]
    both = set(tables[0]) & set(tables[1])
    names = sorted(key[len("overpressure_"):] for key in both if key.startswith("overpressure_"))
    if not names:
        raise Missing("the two runs have no gauge in common")
    fig, axes = plt.subplots(1, 2, figsize=(11.5, 4.4))
    for name, colour in zip(names, (NAVY, RED, TEAL, VIOLET, INK)):
        for table, style, which in zip(tables, ("-", "--"), ("with case", "without")):
            for ax, quantity, scale in zip(axes, ("overpressure", "impulse"), (1e6, 1e3)):
                ax.plot(1e6 * table["time"], table[f"{quantity}_{name}"] / scale, style, color=colour, lw=1.3,
                        label=f"{name.replace('_', ' ')}, {which}")
    axes[0].set(xlabel="time [µs]", ylabel="overpressure [MPa]")
    axes[1].set(xlabel="time [µs]", ylabel="impulse [kPa s]")
    axes[0].legend(fontsize=8.5)
    fig.tight_layout()
    return fig


class Kept(Run):
    """A run whose pictures are kept for the page."""
    fig = None

    def save(self, fig, _):
        self.fig = fig


def draw_fragments(results):
    """Mass and speed of the pieces of the case at the end."""
    run = Kept(results["bomb_cased"].folder, None)
    run.load()
    plot_fragments.draw_fragments(run)
    if run.fig is None:
        raise Missing("bomb_cased has no fragments.csv")
    return run.fig
