"""Sections 4.1.1 and 4.1.2 of the paper: the shock tube and the cylindrical blast."""
from plot_run import BLUE, COLOURS, INK, NAMES, NAVY, RED, TEAL, VIOLET, means, np, plt
from reproduce_model import Case, Exhibit, Picture, Row, Section, measured

# ---- The shock tube ----
START, END, SOUND = 0.5, 0.143, (1.4 * 0.001 / 0.125) ** 0.5  # diaphragm, time, speed of sound on its right
SHOCK, PLATEAU = 0.703534, 0.210858  # exact place of the shock and pressure behind it (Toro 2009, chapter 4)


def shock_place(results, case):
    result = results[case]
    return SHOCK + result.measure("shock position") * result.summary["cell_size"]


def mach(results):
    return (shock_place(results, "riemann") - START) / END / SOUND


def plateau(case):
    """Mean pressure between the fan's tail and the shock, four cells from either."""
    def mean(results):
        run = results[case].frame()
        x, volume = run.x[:, 0], run.particles["volume"]
        inside = (x > 0.555) & (x < 0.68)
        return np.average(run.particles["pressure"][inside], weights=volume[inside])
    return mean


def cell_means(run):
    low, high = run.limits(run.x[:, 0])
    bins = ((run.x[:, 0] - low) / run.cell).astype(int)
    table = means(run.particles, run.particles["velocity"][:, 0], bins, bins.max() + 1)
    return low + (0.5 + np.arange(bins.max() + 1)) * run.cell, table


def draw_tube(results):
    paper, ours = results["riemann_paper"].frame(), results["riemann"].frame()
    exact = results["riemann"].table("exact.csv", ("x", "density"))
    fig, axes = plt.subplots(2, 2, figsize=(11, 7), sharex=True)
    place, table = cell_means(ours)
    order = np.argsort(paper.x[:, 0])
    for ax, key in zip(axes.flat, ("density", "velocity", "pressure", "energy")):
        values = paper.particles[key]
        values = values[:, 0] if values.ndim > 1 else values
        ax.plot(paper.x[order, 0], values[order], color=BLUE, lw=0.9, label="the paper's scheme, points")
        ax.plot(exact["x"], exact[key], color=RED, lw=1.3, label="exact")
        ax.plot(place, table[key], "o", ms=3, mfc="white", mec=NAVY, mew=0.8, label="default scheme, cells")
        ax.set(ylabel=f"{NAMES.get(key, key)} [-]", xlim=(0, 1))
    plt.setp(axes[1], xlabel="x [-]")
    fig.legend(*axes.flat[0].get_legend_handles_labels(), loc="upper right", ncol=3)
    fig.tight_layout(rect=(0, 0, 1, 0.95))
    return fig


RIEMANN = Section(
    key="riemann",
    title="Riemann problem (section 4.1.1)",
    text="""<p>A tube of length 1 holds gas (γ = 1.4) of density 1 and pressure 1 on its left, of 0.125 and
    0.001 on its right; 200 cells of 0.005, time 0.143, dimensionless. It is run twice: with this program's
    default scheme on 3 points a cell, and with the preset <code>paper</code>, which is the paper's Appendix
    A with its viscosity (<i>c</i><sub>0</sub> = 2, <i>c</i><sub>1</sub> = 1). The exact solution is that of
    the Riemann problem (Toro 2009).</p>""",
    cases=(Case("riemann", "riemann", about="the default scheme"),
           Case("riemann_paper", "riemann", ("--preset", "paper"), judged=False,
                about="the paper's scheme; the scene's limits are those of the default one")),
    exhibits=(Exhibit(
        "Fig. 6", "profiles of the Riemann problem", (
            Row("density, error (L1) against the exact solution", "\"quite well\"", "0",
                measured("riemann", "L1 density"),
                "%", high=3),
            Row("density, error of the paper's scheme", "\"quite well\"", "0",
                measured("riemann_paper", "L1 density"),
                "%", high=3),
            Row("Mach number of the shock", "14.43 (misprint)", "13.449", mach, "", 13.37, 13.53),
            Row("pressure behind the shock", "", "0.21086", plateau("riemann"), "", 0.97 * PLATEAU,
                1.03 * PLATEAU),
            Row("the same, paper's scheme", "", "0.21086", plateau("riemann_paper")),
            Row("place of the shock", "", "0.70353", lambda r: shock_place(r, "riemann"), "", SHOCK - 0.01,
                SHOCK + 0.01),
            Row("the same, paper's scheme", "", "0.70353", lambda r: shock_place(r, "riemann_paper"), "",
                SHOCK - 0.01, SHOCK + 0.01),
            Row("noise of velocity in the rarefaction", "", "0", measured("riemann", "fan noise"), "%",
                high=0.3),
            Row("the same, paper's scheme", "\"noise in the rarefaction wave\"", "0",
                measured("riemann_paper", "fan noise"),
                "%", low=0.3),
            Row("energy lost by the paper's scheme", "", "0", measured("riemann_paper", "energy error", -1),
                "%"),
        ), (Picture(draw_tube, "Density, velocity, pressure and specific internal energy at time 0.143 "
                               "(dimensionless). The paper's scheme, drawn from point to point as in its "
                               "Fig. 6, has the noise that the paper describes: a point that crosses into "
                               "another cell changes the balance of forces there. The default scheme does "
                               "not."),)),),
    notes=("The paper gives the shock as M ≈ 14.43. The states it prints give M = 13.45.",))


# ---- The blast ----
def radial(run):
    away = run.x[:, :2] - run.centre
    return np.hypot(*away.T)


def shells(run, key):
    """Mean over shells half a cell thick, density by volume as mass is."""
    bins = (radial(run) / (0.5 * run.cell)).astype(int)
    table = means(run.particles, np.zeros(len(bins)), bins, bins.max() + 1)
    return (0.5 + np.arange(bins.max() + 1)) * 0.5 * run.cell, table[key]


def grid_of(run, key):
    """Means over the cells of the whole square, and its half width."""
    half = 0.3
    count = int(round(2 * half / run.cell))
    cell = np.clip(((run.x[:, :2] + half) / run.cell).astype(int), 0, count - 1)
    table = means(run.particles, np.zeros(len(cell)), cell[:, 0] * count + cell[:, 1], count * count)
    return table[key].reshape(count, count), half


def unsymmetry(results):
    """Largest difference of a cell's pressure from its mirror images, over the peak."""
    pressure, _ = grid_of(results["sedov_table1"].frame(), "pressure")
    images = (pressure[::-1], pressure[:, ::-1], pressure.T)
    return max(np.nanmax(np.abs(pressure - image)) for image in images) / np.nanmax(pressure)


def centre_over_peak(results):
    run = results["sedov_table1"].frame()
    core = radial(run) < 0.3 * results["sedov_table1"].measure("front radius")
    volume = run.particles["volume"][core]
    return np.average(run.particles["pressure"][core],
        weights=volume) / results["sedov_table1"].measure("peak pressure")


def draw_blast(results):
    fig, axes = plt.subplots(1, 2, figsize=(11, 4.9))
    run = results["sedov_table1"].frame()
    for ax, key, scale, unit, lines in ((axes[0], "density", 1, "kg/m³", (1, 2, 3, 4)),
                                        (axes[1], "pressure", 1e6, "MPa", (1, 2.5, 4))):
        values, half = grid_of(run, key)
        image = ax.imshow(values.T / scale, origin="lower", extent=(-half, half, -half, half),
            cmap=COLOURS[key])
        side = (np.arange(len(values)) + 0.5) * run.cell - half
        ax.contour(side, side, values.T / scale, lines, colors="white", linewidths=0.5, alpha=0.8)
        turn = np.linspace(0, 2 * np.pi, 200)
        ax.plot(0.1677 * np.cos(turn), 0.1677 * np.sin(turn), color="#57e0ff", lw=1.3, ls=(0, (4, 3)),
            label="exact front")
        ax.set(title=f"{key} [{unit}]", xlabel="x [m]", ylabel="y [m]", xlim=(-0.22, 0.22),
               ylim=(-0.22, 0.22))
        ax.grid(False)
        fig.colorbar(image, ax=ax, fraction=0.046, pad=0.03)
    axes[0].legend(loc="upper right", labelcolor="white")
    fig.tight_layout()
    return fig


def draw_radial(results):
    fig, axes = plt.subplots(1, 2, figsize=(11, 4.6))
    curves = (("sedov_table1", NAVY, "energy of Table 1, default scheme"), ("sedov_paper", VIOLET,
        "12 cells, paper's scheme"),
              ("sedov_as_printed", TEAL, "as printed, default scheme"))
    for ax, key, scale, unit in ((axes[0], "density", 1, "kg/m³"), (axes[1], "pressure", 1e6, "MPa")):
        for name, colour, label in curves:
            run = results[name].frame()
            exact = results[name].table("exact.csv", ("r", "density"))
            ax.plot(exact["r"], exact[key] / scale, color=RED, lw=1,
                label="exact" if name == "sedov_table1" else None)
            where, values = shells(run, key)
            ax.plot(where, values / scale, "o", ms=3.2, mfc="white", mec=colour, mew=0.9, label=label)
        ax.set(ylabel=f"{key} [{unit}]", xlabel="radius [m]", xlim=(0, 0.25))
    axes[1].axhline(4.6, color=INK, lw=0.8, ls=":")
    axes[1].text(0.002, 4.66, "4.60 MPa, the paper's peak", color=INK, fontsize=8.5)
    axes[0].legend(loc="upper right")
    fig.tight_layout()
    return fig


SEDOV = Section(
    key="sedov",
    title="Sedov–Taylor blast wave (section 4.1.2)",
    text="""<p>In a square of 0.6 m with cells of 5 mm the middle is at 1 GPa, all else at 1 Pa (γ = 1.67);
    25 points in a cell at the middle, fewer outwards, time 41 µs. In plane strain this is a cylindrical
    blast; Sedov's solution for the energy <i>E</i> per length is <i>R</i> = (<i>E
    t</i>²/(αρ<sub>0</sub>))<sup>1/4</sup>, <i>p</i><sub>2</sub> = 2ρ<sub>0</sub><i>Ṙ</i>²/(γ + 1), with α =
    0.56112. Three runs: the set-up as printed, the energy to which Table 1 belongs, and the paper's own
    scheme with the twelve cells whose centres lie within 10 mm, the source that comes closest to its Table
    1.</p>""",
    cases=(Case("sedov_table1", "sedov_table1", about="energy of Table 1"),
           Case("sedov_as_printed", "sedov_as_printed", about="four cells of 1 GPa"),
           Case("sedov_paper", "sedov_paper", about="the paper's scheme, twelve cells of 1 GPa")),
    exhibits=(
        Exhibit("Table 1", "blast wave at 41.0 µs", (
            Row("peak pressure, energy of Table 1", "theory 5.23 MPa, MPM 4.60 MPa", "5.23 MPa",
                measured("sedov_table1", "peak pressure"), "MPa", 4.97, 5.49),
            Row("front radius, energy of Table 1", "theory 0.1677 m, MPM 0.1750 m", "0.1677 m",
                measured("sedov_table1", "front radius"), "m", 0.1652, 0.1702),
            Row("peak pressure, the paper's scheme", "MPM 4.60 MPa", "5.27 MPa",
                measured("sedov_paper", "peak pressure"),
                "MPa", 4.2, 5.0),
            Row("front radius, the paper's scheme", "MPM 0.1750 m", "0.1683 m",
                measured("sedov_paper", "front radius"), "m",
                0.168, 0.178),
            Row("energy lost by the paper's scheme", "", "0", measured("sedov_paper", "energy error", -1),
                "%"),
            Row("peak pressure, as printed", "", "3.044 MPa", measured("sedov_as_printed", "peak pressure"),
                "MPa",
                2.892, 3.196),
            Row("front radius, as printed", "", "0.12792 m", measured("sedov_as_printed", "front radius"),
                "m",
                0.1254, 0.1304),
        ), (Picture(draw_radial, "Density and pressure against the radius at 41 µs: means over shells half "
                                 "a cell thick, and Sedov's solution for the energy that each run was "
                                 "given."),)),
        Exhibit("Fig. 8", "density and pressure of the blast wave", (
            Row("front along the axes over front along the diagonals, less 1", "circular", "0",
                measured("sedov_table1", "asymmetry"), "%", -2, 2),
            Row("pressure against its mirror images in x, y and the diagonal, over the peak", "symmetric",
                "0",
                unsymmetry, "%", high=0.1),
            Row("pressure within 0.3 radii over the peak", "", "0.321", centre_over_peak, "", 0.29, 0.353),
        ), (Picture(draw_blast, "Means over cells at 41 µs with the energy of Table 1, lines of equal "
                                "value, and the exact front (dashed)."),), cases=("sedov_table1",))),
    notes=("Table 1 does not follow from what is printed. <i>p</i><sub>2</sub><i>R</i>² = <i>E</i>/(2(γ + "
           "1)α) depends on the energy alone: four cells of 1 GPa hold 149.25 kJ/m, which gives 49.8 kN; "
           "Table 1 gives 147.1 kN, 2.953 times as much (11.8 cells), and then asks for 1.669 kg/m³. The "
           "density is not printed; 1.67 kg/m³ is taken.",
           "\"41.0 ms\" is 41.0 microseconds, and the \"spherical\" wave is cylindrical."))
