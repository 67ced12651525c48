"""Energies and errors of conservation against time."""
from plot_run import BLUE, GREY, INK, NAVY, RED, TEAL, VIOLET, np, plt, prefixed, read_csv


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
