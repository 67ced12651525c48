"""What the pictures of a run stand on: what its folder says, numbers of its particles, and their looks."""
import os
import xml.etree.ElementTree as xml

from plot_files import Missing, Mistake, NotWritten, complete, read_csv, read_series, read_vtk
from plot_libraries import np, plt
from plot_options import is_file

UNITS = {"density": "kg/m$^3$", "velocity": "m/s", "pressure": "Pa", "energy": "J/kg"}
NAMES = {"energy": "specific internal energy"}
COLOURS = {"density": "viridis", "pressure": "inferno", "velocity": "cividis", "energy": "magma"}
FLUIDS = ("perfect gas", "jwl", "linear fluid")

BLUE, NAVY, RED, TEAL, VIOLET, INK, GREY = (
    "#6c9bc4", "#173f5f", "#e4572e", "#2a9d8f", "#7b5ea7", "#30383e", "#5f6a72")
STYLE = {
    "font.size": 9.5, "axes.labelsize": 10.5, "axes.labelcolor": INK, "axes.titlesize": 10.5,
    "axes.titlecolor": INK, "axes.titlelocation": "left", "axes.edgecolor": "#9aa5ad",
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "axes.axisbelow": True,
    "grid.color": "#e3e7ea", "grid.linewidth": 0.7, "xtick.color": GREY, "ytick.color": GREY,
    "axes.formatter.useoffset": False, "legend.frameon": False, "figure.dpi": 150, "savefig.dpi": 150,
}


class Run:
    """What a folder says about its run, and how its pictures are titled and kept: in DIR/pictures, in
    another folder, or as the one file that `out` names."""

    def __init__(self, folder, frame=None, out=None):
        self.folder, self.frame = folder, frame
        self.out, self.drawn = out or self.path("pictures"), []
        try:
            given = xml.parse(self.path("input.xml")).getroot()
        except (OSError, xml.ParseError):
            what = "holds no run: it has no input.xml" if os.path.isdir(folder) else "is not a folder"
            raise Mistake(f"'{folder}' {what}") from None

        def told(path, otherwise):
            found = given.find("./" + path)
            return otherwise if found is None else found.get("value")

        self.scene = given.get("name") or os.path.basename(os.path.abspath(folder))
        self.title = told("Parameter[@name='title']", "") or self.scene
        self.geometry = told("Parameter[@name='geometry']", "")
        self.cell = float(told("*[@name='grid']/Parameter[@name='cell size']", 0))
        self.materials = [(one.get("name"), one.find("./Parameter[@name='law']").get("value"))
                          for one in given.findall("./*[@name='materials']/ParameterList")]
        centre = told("*[@name='exact']/Parameter[@name='centre']", "{0, 0}").strip("{} ")
        self.centre = np.array(centre.split(","), dtype=float)[:2]

    def path(self, name):
        return os.path.join(self.folder, name)

    def outputs(self):
        """(time, file) of each output: of particles, or of the grid where there are none."""
        name = "particles.pvd"
        if not os.path.exists(self.path(name)) and os.path.exists(self.path("grid.pvd")):
            name = "grid.pvd"
        return read_series(self.path(name))

    def load(self):
        """Reads the particles of the frame asked for, or of the last one."""
        if not os.path.exists(self.path("particles.pvd")) and os.path.exists(self.path("grid.pvd")):
            raise Missing(f"'{self.folder}' holds no particles, only grids: --field draws those")
        sets = read_series(self.path("particles.pvd"))
        number = len(sets) - 1 if self.frame is None else self.frame
        if not 0 <= number < len(sets):
            raise Missing(f"no frame {number} among the {len(sets)} in {self.folder}")
        self.is_last = number == len(sets) - 1
        self.number, (self.time, file) = number, sets[number]
        self.particles = complete(read_vtk(self.path(file))[1], ("Points",), self.path(file))
        self.x = self.particles["Points"]

    def expect(self, columns):
        """Refuses a picture whose columns are not among those that were written."""
        lacking = [name for name in columns if name not in self.particles]
        if lacking:
            names = ", ".join(f"'{name}'" for name in lacking)
            raise NotWritten(f"the output has no column {names} (output/columns)")

    @property
    def is_line(self):
        return self.geometry == "line"

    def table(self, name):
        """A table that belongs to the last frame, if there is one."""
        there = self.is_last and os.path.exists(self.path(name))
        return read_csv(self.path(name), tuple(UNITS)) if there else None

    def limits(self, x):
        """The range of x in whole cells."""
        cell = self.cell or 1e-12
        return np.floor(x.min(axis=0) / cell) * cell, np.ceil(x.max(axis=0) / cell) * cell

    def save(self, fig, name):
        facts = [self.scene] * (self.scene != self.title)
        if name not in ("history", "gauges"):
            facts.append(f"t = {readable_time(self.time)}")
            facts.append(f"{len(self.x):,} particles")
        if self.cell:
            facts.append("cells of {:.4g} {}".format(*prefixed(self.cell, "m")[::2]))
        head(fig, self.title, facts)
        suffix = "" if self.frame is None else f"_{self.frame:06d}"
        keep(fig, self.out, f"{name}{suffix}.png")
        self.drawn.append(name)


# ---- Pictures ----
def head(fig, title, facts):
    width, height = fig.get_size_inches()
    size = min(14, 14 * (width - 0.3) / (0.14 * len(title)))  # a letter of size 14 takes 0.14 inches at most
    fig.text(0.02, 1 - 0.12 / height, title, va="top", size=size, weight="bold", color=INK)
    fig.text(0.02, 1 - 0.42 / height, "   |   ".join(facts), va="top", color=GREY)


def place(out, name):
    """Where a picture goes; makes the folder."""
    path = out if is_file(out) else os.path.join(out, name)
    try:
        os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    except OSError as problem:
        raise Missing(f"cannot write {path}: {problem.strerror}") from None
    return path


def keep(fig, out, name):
    path = place(out, name)
    try:
        fig.savefig(path)
    except OSError as problem:
        raise Missing(f"cannot write {path}: {problem.strerror}") from None
    plt.close(fig)
    print(path)


# ---- Numbers ----
def prefixed(values, unit):
    """Values with the prefix that leaves the largest in 0.1 ... 1000; the divisor; the unit."""
    largest = np.nanmax(np.abs(values))
    power = 0
    if not unit.startswith("kg") and 0 < largest < np.inf and not 0.1 <= largest < 1000:
        power = int(np.clip(3 * np.floor(np.log10(largest) / 3), -9, 9))
    prefix = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}[power]
    return values / 10.0**power, 10.0**power, prefix + unit


def means(particles, velocity, bins, count):
    """Averages over the particles of each bin; nan where there are none."""
    mass, volume = particles["mass"], particles["volume"]

    def total(weights):
        return np.bincount(bins, weights, count)

    with np.errstate(invalid="ignore", divide="ignore"):
        return {
            "density": total(mass) / total(volume),
            "velocity": total(mass * velocity) / total(mass),
            "pressure": total(volume * particles["pressure"]) / total(volume),
            "energy": total(mass * particles["energy"]) / total(mass),
        }


def value_range(values, volume):
    """What all of the volume but a thousandth at each end has; whether half is far below it."""
    order = np.argsort(values)
    share = np.cumsum(volume[order])
    places = np.searchsorted(share, share[-1] * np.array((1e-3, 0.5, 0.999)))
    low, middle, high = values[order[places]]
    margin = 1e-3 * abs(high) if high - low < 1e-6 * abs(high) else 0
    return low - margin, high + margin, low > 0 and high > 50 * middle


def readable_time(time):
    return "{:.5g} {}".format(*prefixed(time, "s")[::2])
