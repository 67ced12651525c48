"""Section 4.3 of the paper: a piston on a container of liquid, and one that drives a shock into gas."""
from plot_run import BLUE, GREY, INK, NAVY, RED, TEAL, Missing, np, plt
from reproduce_model import Case, Exhibit, Picture, Row, Section, measured

# ---- Piston-container ----
MASSES = (("piston_container", 17.51, 886.831, 0.015), ("piston_container_heavy", 175.1, 281.227, 0.034))
FIRST_SPEED = 0.01  # of the piston [m/s]


def piston_path(results, name, until):
    """Times and displacements of the densest matter: that is the piston."""
    result = results[name]
    times, places = [], []
    for k, time in enumerate(result.frames):
        if time > until:
            break
        run = result.frame(k)
        particles = run.particles
        if k == 0:
            piston = particles["material"][np.argmax(particles["density"])]
        there = particles["material"] == piston
        times.append(time)
        places.append(np.average(run.x[there, 0], weights=particles["mass"][there]))
    if len(times) < 10:
        raise Missing(f"{name} has too few outputs before {1e3 * until:g} ms")
    return np.array(times), np.array(places) - places[0]


def draw_deflection(results):
    fig, axes = plt.subplots(1, 2, figsize=(11.5, 4.2))
    for ax, (name, mass, omega, until) in zip(axes, MASSES):
        times, away = piston_path(results, name, until)
        fine = np.linspace(0, until, 400)
        sign = np.sign(away[1]) or 1
        ax.plot(1e3 * fine, 1e3 * sign * FIRST_SPEED / omega * np.sin(omega * fine), color=RED, lw=1.3,
                label="first mode, exact")
        ax.plot(1e3 * times, 1e3 * away, "o", ms=4, mfc="white", mec=NAVY, mew=0.9, label="material point")
        for k in range(1, int(until * omega / 2 / np.pi) + 1):
            ax.axvline(1e3 * 2 * np.pi * k / omega, color=GREY, lw=1, ls="--",
                label="exact period" if k == 1 else None)
        ax.set(title=f"m = {mass} kg", xlabel="time [ms]", ylabel="displacement of the piston [mm]",
               xlim=(0, 1e3 * until))
    fig.legend(*axes[0].get_legend_handles_labels(), loc="upper right", ncol=3)
    fig.tight_layout(rect=(0, 0, 1, 0.94))
    return fig


CONTAINER = Section(
    key="piston_container",
    title="Piston-container problem (section 4.3.1)",
    text="""<p>A piston on a spring (1.75e4 N/m) closes a column of liquid 0.508 m long and 6.45e-4 m² wide
    (1000 kg/m³, bulk modulus 10.9 GPa), in 40 points, and is pushed at 0.01 m/s. Exact is the first root of
    the paper's equation (20), ω = √([<i>K</i> + ρω<i>cA</i> cot(ω<i>L</i>/<i>c</i>)]/<i>m</i>). The piston
    is one heavy point on a spring without mass; in a third run the spring is of elastic points as in the
    paper's Fig. 13, at a hundredth of the piston's density, which has an exact period of its own.</p>""",
    cases=(Case("piston_container", "piston_container",
                ("--set", "output/interval=2.5e-4", "--set", "output/grid=false"), about="17.51 kg"),
           Case("piston_container_heavy", "piston_container_heavy",
                ("--set", "output/interval=7e-4", "--set", "output/grid=false"), about="175.1 kg"),
           Case("piston_literal", "piston_literal", about="a spring of elastic points")),
    exhibits=(
        Exhibit("Table 2", "periods of vibration", (
            Row("period, 17.51 kg", "theory 7.08 ms, MPM 7.1 ms", "7.0850 ms",
                measured("piston_container", "period"), "ms", 7.0850 * 0.99, 7.0850 * 1.01),
            Row("period, 175.1 kg", "theory 22.34 ms, MPM 22.4 ms", "22.3420 ms",
                measured("piston_container_heavy", "period"), "ms", 22.342 * 0.99, 22.342 * 1.01),
            Row("frequency, 17.51 kg", "theory 886.8 rad/s", "886.831 rad/s",
                lambda r: 2 * np.pi / r["piston_container"].measure("period"), "rad/s"),
            Row("frequency, 175.1 kg", "theory 281.2 rad/s", "281.227 rad/s",
                lambda r: 2 * np.pi / r["piston_container_heavy"].measure("period"), "rad/s"),
            Row("mean distance of passages, 17.51 kg, spring of points", "", "7.204 ms, all modes summed",
                measured("piston_literal", "period"), "ms", 7.204 * 0.985, 7.204 * 1.015),
        )),
        Exhibit("Fig. 14", "piston deflection", (
            Row("amplitude, 17.51 kg", "0.011 mm (read from the figure)", "0.01128 mm",
                measured("piston_container", "amplitude"), "mm", 0.0111, 0.0115),
            Row("amplitude, 175.1 kg", "0.036 mm (read from the figure)", "0.03556 mm",
                measured("piston_container_heavy", "amplitude"), "mm", 0.0352, 0.0359),
            Row("change of velocity from the first to the last periods, 17.51 kg", "none seen", "0",
                measured("piston_container", "velocity drift"), "%", -1, 1),
            Row("the same, 175.1 kg", "none seen", "0", measured("piston_container_heavy", "velocity drift"),
                "%", -1, 1),
        ), (Picture(draw_deflection, "Displacement of the piston against time, for two masses; dashed: "
                                     "exact periods, as the vertical lines in the paper's Fig. 14."),),
            cases=("piston_container", "piston_container_heavy"))),
    notes=("The bulk modulus of 10.9 GPa is not water's but is no misprint: the printed frequencies belong "
           "to it.",
           "Nineteen points of a hundredth of the piston's density weigh 0.19 of the piston. Eq. (20) with such "
           "a spring has modes of 874.2 and 924.5 rad/s, so that the swing comes and goes: the paper's 7.1 ms "
           "belong to a spring without mass."))


# ---- Piston-gas ----
# Exact for a piston of 26352 m/s of elastic steel: a shock in the gas, one in the steel, one stress between.
STRESS, SHOCK, FACE, STEEL_FRONT = 1.00047e9, 0.058877, 0.065771, 0.073254  # [Pa], [m] at 1.3 microseconds
CALM = 1.0e6  # pressure before the shock [Pa]


def stresses(results):
    """Places, stress along x, and which points are gas, in order of place."""
    result = results["piston_gas"]
    run = result.frame()
    particles = run.particles
    gas = result.of_law(particles, "perfect gas")
    stress = np.where(gas, -particles["pressure"], particles.get("stress xx", -particles["pressure"]))
    order = np.argsort(run.x[:, 0])
    return run.x[order, 0], stress[order], gas[order]


def mean_between(low, high):
    """Of the stress, over points well inside one of the plateaus."""
    def mean(results):
        x, stress, _ = stresses(results)
        inside = (x > low) & (x < high)
        if not inside.any():
            raise Missing(f"no points between {low} and {high} m")
        return stress[inside].mean()
    return mean


def passage(low, high):
    """Where the stress passes half of its plateau between two places."""
    def place(results):
        x, stress, _ = stresses(results)
        inside = (x > low) & (x < high)
        level = stress[inside] + STRESS / 2
        change = np.flatnonzero(np.diff(np.sign(level)))
        if not len(change):
            raise Missing("no front is there")
        k = change[0]
        a, b = x[inside][k : k + 2]
        return a + (b - a) * level[k] / (level[k] - level[k + 1])
    return place


def face(results):
    """Half-way between the last point of the gas and the first of the right piston."""
    x, _, gas = stresses(results)
    last = np.flatnonzero(gas)[-1]
    return 0.5 * (x[last] + x[last + 1])


def jump(results):
    """Stress of the piston over that of the gas, less 1."""
    return mean_between(0.067, 0.0715)(results) / mean_between(0.0605, 0.0645)(results) - 1


def draw_shock(results):
    x, stress, gas = stresses(results)
    fig, ax = plt.subplots(figsize=(11, 4.6))
    exact = ((0.04, -CALM), (SHOCK, -CALM), (SHOCK, -STRESS), (STEEL_FRONT, -STRESS), (STEEL_FRONT, 0), (0.08,
        0))
    ax.plot(*np.array(exact).T * ((1e3,), (1e-9,)), color=RED, lw=1.4, label="exact")
    ax.plot(1e3 * x[gas], 1e-9 * stress[gas], "o", ms=3.6, mfc="white", mec=TEAL, mew=0.9, label="gas")
    ax.plot(1e3 * x[~gas], 1e-9 * stress[~gas], "s", ms=3.4, mfc="white", mec=NAVY, mew=0.9, label="steel")
    ax.axvline(1e3 * FACE, color=INK, lw=1, ls="--")
    for place, text, side in ((FACE, "interface, exact ", "right"), (SHOCK, "shock in the gas ", "right"),
                              (STEEL_FRONT, " shock in the piston", "left")):
        ax.text(1e3 * place, 0.35, text, ha=side, color=INK, fontsize=9)
    ax.axvspan(40, 1e3 * SHOCK, color=BLUE, alpha=0.07, lw=0)
    ax.set(xlim=(40, 80), ylim=(-2.5, 2.5), xlabel="x [mm]", ylabel="stress along x [GPa]")
    ax.legend(loc="upper left", ncol=3)
    fig.tight_layout()
    return fig


GAS = Section(
    key="piston_gas",
    title="Piston-gas problem (section 4.3.2)",
    text="""<p>Gas (γ = 1.4, 1.2 kg/m³, 1 MPa) of 50 mm lies between two steel pistons of 50 mm, of which the
    right one flies at 26.352 km/s into it; 600 cells of 0.25 mm, one point in each, time 1.3 µs. A shock of
    1 GPa runs through the gas, one of the same stress through the steel. Exact is the coupled Riemann
    problem of a perfect gas and elastic steel.</p>""",
    cases=(Case("piston_gas", "piston_gas"),),
    exhibits=(Exhibit(
        "Fig. 16", "strong shock in a perfect gas and in the piston", (
            Row("stress in the shocked gas", "−1.0 GPa", "−1.00047 GPa", mean_between(0.0605, 0.0645), "GPa",
                -1.03, -0.97),
            Row("stress in the shocked steel", "−1.0 GPa", "−1.00047 GPa", mean_between(0.067, 0.0715), "GPa",
                -1.03, -0.97),
            Row("stress across the interface, steel over gas less 1", "continuous", "0", jump, "%", -3, 3),
            Row("shock in the gas", "between 0.055 and 0.060 m", "0.05888 m", passage(0.045, 0.064), "m",
                SHOCK - 5e-4,
                SHOCK + 5e-4),
            Row("interface", "at about 0.066 m", "0.06577 m", face, "m", FACE - 5e-4, FACE + 5e-4),
            Row("shock in the piston", "between 0.070 and 0.075 m", "0.07325 m", passage(0.068, 0.08), "m",
                STEEL_FRONT - 5e-4, STEEL_FRONT + 5e-4),
        ), (Picture(draw_shock, "Stress along x at 1.3 µs, in the window of the paper's Fig. 16. Limits of "
                                "the places are two cells."),)),),
    notes=("The figure of the set-up says 26.532 km/s; 26.352 km/s is right. \"<i>t</i> = 1.3 ms\" is 1.3 "
           "microseconds: at 1.58 µs the gas has been crossed.",
           "The paper lets the piston remain elastic: with its yield stress of 500 MPa it would not, so "
           "elastic steel is used."))
