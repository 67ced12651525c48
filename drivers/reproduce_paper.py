"""What is printed wrongly in Hu & Chen (2006), what is not printed, and how it was read."""

TITLE = "Hu &amp; Chen (2006), reproduced"

INTRODUCTION = """<p>W. Hu and Z. Chen, <i>Model-based simulation of the synergistic effects of blast and
fragmentation on a concrete wall using the MPM</i>, International Journal of Impact Engineering 32 (2006),
2066&ndash;2096: every problem of the paper, run by this program, each table and figure beside ours, with the
exact or a reference value and the number that the paper prints. All is in SI units and plane strain; masses,
energies and forces are per metre of depth.</p>"""

OTHER_EXHIBITS = ("Figs 1 to 5, 7, 9, 10, 13, 15 and 17 show set-ups, curves of the laws and a flow chart: "
                  "there is nothing to compute.")

MISPRINTS = (
    ("4.1.1", "shock of Mach 14.43", "The printed states give Mach 13.45 (13.449 exactly, 13.444 from the "
        "strong-shock formula)."),
    ("Table 1", "peak 5.23 MPa, radius 0.1677 m", "They do not follow from the printed data. In a "
        "cylindrical blast <i>p</i><sub>2</sub><i>R</i>² = <i>E</i>/(2(γ + 1)α) holds whatever the density "
        "and the time; the four cells of 1 GPa hold <i>E</i> = 149.25 kJ/m, Table 1 needs 440.7 kJ/m, "
        "2.953 times as much."),
    ("4.1.2", "density of the gas", "Not printed. 1.67 kg/m³ (argon, as γ = 1.67 suggests) is taken."),
    ("4.1.2", "\"spherical\" blast wave", "In a plane model it is cylindrical, <i>R</i> ~ √<i>t</i>."),
    ("4.1.2, 4.3.2", "\"41.0 ms\", \"1.3 ms\"", "Microseconds: the blast is 0.17 m wide and the gas is "
        "crossed in 1.58 µs. The 0.442 ms of the impact really are milliseconds."),
    ("Fig. 15", "piston of 26.532 km/s", "The text has 26.352 km/s, which is what a strong shock of 1 GPa "
        "in this gas needs; the figure's digits are transposed."),
    ("4.3.2", "the piston \"remains elastic\"", "With the steel of section 4.2 it would not: its elastic "
        "limit in uniaxial strain is 845 MPa, less than 1 GPa. Elastic steel is used there."),
    ("Eqs 12, A.19, A.22", "work divided by the new density",
        "To be exact the work of a step is divided by the old density, as A.16 changes the density by its "
        "old value; the printed form is wrong by the volume change of a step. The preset \"paper\" can do "
        "either (<code>MUSL work</code>)."),
    ("A.13", "sum over the points", "The velocity gradient sums over the nodes."),
    ("A.7, A.8", "one symbol for two velocities", "Places move with the grid's velocity of A.7; the "
        "velocity of A.8 is kept by the point and mapped back in A.11."),
    ("A.17", "no rotation of the stress", "A body that spins would lose its stress; solids carry it along "
        "(Jaumann's rate)."),
    ("1, 15, 17, 19, A.3", "signs", "Minus signs of the divergence, of the inner forces and of <i>P</i> = "
        "&minus;<i>B</i> div <b>u</b> are not legible in the copy at hand; physics leaves no choice."),
    ("14", "sign of the volume strain", "The viscosity asks for the rate of volume strain (a dot is "
        "missing in 14b), and both its terms resist compression."),
    ("2.2, Fig. 10", "\"confining pressure\"", "It is the mean stress, positive in tension, while the "
        "pressure of fluids is positive in compression."),
    ("4.2", "unit of <i>k</i>", "\"l/m³\" is 1/m³."),
    ("Fig. 12", "damage up to 0.6", "The model's own bifurcation stops damage at 0.30 or below (0.18 in "
        "uniaxial strain): what is plotted cannot be the damage at that moment. We show the damage, and "
        "the failure 1 &minus; (1 &minus; <i>D</i>)(1 &minus; λ) with the decohesion λ."),
    ("4.2", "the cone of Drucker and Prager", "No parameter is printed. Cohesion and angle come from the "
        "strength that the modulus implies (ACI) and Richart's confinement; no dilatancy."),
    ("2.2", "shear modulus of damaged concrete, floor of the strain rate, length of decohesion",
        "Not printed. Isotropic elasticity with the damaged bulk modulus and Poisson's ratio; 1 /s; the "
        "chord of a cell."),
    ("5.1", "energy of the air 2.0e6 J/kg", "That is 10 atmospheres. 2.0e5 J/kg gives one."),
    ("Fig. 17", "size of the bomb", "The labels 150 and 250 mm cannot belong to a circle with a wall of 25 "
        "mm. A charge of 200 mm in a case of 250 mm outside is taken, as the text says \"cylindrical\" and "
        "\"25 mm thick\"."),
    ("5", "detonation, fracture of steel, times of the steps",
        "Not described. The charge is lit at its centre and burns at the printed velocity; steel breaks "
        "where its points part; steps are spread over the run."),
    ("1", "fragments of 3 or 4 km/s", "For the bomb of section 5 Gurney's formula and a calculation in one "
        "dimension give 0.8 to 1.5 km/s."),
    ("Abstract", "\"isothermal\" cases", "They are adiabatic (section 5.1 says so)."),
)


def misprints_part():
    rows = "".join(f"<tr><td>{where}</td><td>{what}</td><td>{reading}</td></tr>" for where, what,
        reading in MISPRINTS)
    return ('<h2 id="misprints">Misprints and gaps of the paper</h2><p>What is printed wrongly, or not at '
            'all, and what '
            'was computed instead.</p><div '
            'class="scroll"><table><thead><tr><th>where</th><th>what</th><th>reading</th>'
            f"</tr></thead><tbody>{rows}</tbody></table></div>")
