"""What the pictures of a run stand on: its tables and particles, numbers of them, and their looks."""
import json
import os
import sys
import xml.etree.ElementTree as xml

try:
    import numpy as np
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    # A private python may stand in front of the one that the distribution's packages belong to.
    python = "/usr/bin/python3"
    if os.path.exists(python) and not os.path.samefile(sys.executable, python):
        os.execv(python, [python, *sys.argv])
    missing = "numpy" if error.name == "numpy" else "matplotlib"
    print(f"plot: no {missing}; install the Debian package python3-{missing}", file=sys.stderr)
    sys.exit(2)

MOST_DOTS = 300_000  # with more particles an image of averages is faster and clearer

UNITS = {"density": "kg/m$^3$", "velocity": "m/s", "pressure": "Pa", "energy": "J/kg"}
NAMES = {"energy": "specific internal energy"}
COLOURS = {"density": "viridis", "pressure": "inferno", "velocity": "cividis", "energy": "magma"}

BLUE, NAVY, RED, TEAL, VIOLET, INK, GREY = (
    "#6c9bc4", "#173f5f", "#e4572e", "#2a9d8f", "#7b5ea7", "#30383e", "#5f6a72")
STYLE = {
    "font.size": 9.5, "axes.labelsize": 10.5, "axes.labelcolor": INK, "axes.titlesize": 10.5,
    "axes.titlecolor": INK, "axes.titlelocation": "left", "axes.edgecolor": "#9aa5ad",
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "axes.axisbelow": True,
    "grid.color": "#e3e7ea", "grid.linewidth": 0.7, "xtick.color": GREY, "ytick.color": GREY,
    "axes.formatter.useoffset": False, "legend.frameon": False, "figure.dpi": 150, "savefig.dpi": 150,
}


class Missing(Exception):
    """Something that a picture needs is not there; says what in one line."""


# ---- Reading ----
def complete(table, needed, path):
    """The table, if it has all the columns that are needed, and rows."""
    for name in needed:
        if name not in table:
            raise Missing(f"{path} has no column '{name}'")
    if len(table[needed[0]]) == 0:
        raise Missing(f"{path} is empty")
    return table


def read_vtp(path):
    """The arrays of a particle file by name, left on the disk until they are used."""
    mark = b'<AppendedData encoding="raw">\n_'
    arrays = {}
    try:
        raw = np.memmap(path, dtype=np.uint8, mode="r")
        head = bytes(raw[: 1 << 16]).partition(mark)[0]
        for array in xml.fromstring(head + b"</VTKFile>").iter("DataArray"):
            begin = len(head) + len(mark) + int(array.get("offset")) + 8
            kind = np.dtype(array.get("type").lower()).newbyteorder("<")
            rows = int(raw[begin - 8 : begin].view("<u8")[0]) // kind.itemsize
            columns = int(array.get("NumberOfComponents"))
            values = np.frombuffer(raw, kind, rows, begin) if rows else np.empty(0, kind)
            if kind == np.float32:  # sums over many particles need more digits
                values = values.astype(float)
            arrays[array.get("Name")] = values.reshape(-1, columns) if columns > 1 else values
    except FileNotFoundError:
        raise Missing(f"no {path}") from None
    except (ValueError, IndexError, xml.ParseError):
        raise Missing(f"{path} is cut off or no particle file") from None
    return complete(arrays, ("Points",), path)


def read_csv(path, needed):
    """The columns of a table by name; a last line that is still being written is left out."""
    try:
        with open(path) as file:
            names = [name.strip() for name in file.readline().split(",")]
            rows = [line.split(",") for line in file if line.endswith("\n")]
        rows = np.array([row for row in rows if len(row) == len(names)], dtype=float)
    except FileNotFoundError:
        raise Missing(f"no {path}") from None
    except ValueError:
        raise Missing(f"{path} holds something that is no number") from None
    return complete(dict(zip(names, rows.reshape(-1, len(names)).T)), needed, path)


class Run:
    """What a folder says about its run, and how its pictures are titled and kept."""

    def __init__(self, folder, frame):
        self.folder, self.frame = folder, frame
        try:
            with open(self.path("summary.json")) as file:
                summary = json.load(file)
        except (FileNotFoundError, ValueError):  # a run that is not finished yet
            summary = {}
        self.scene = summary.get("scene") or os.path.basename(os.path.abspath(folder))
        self.title = summary.get("title") or self.scene
        self.cell = summary.get("cell_size")
        self.centre = np.array(summary.get("centre") or (0, 0), dtype=float)[:2]
        self.geometry = summary.get("geometry", "")

    def path(self, name):
        return os.path.join(self.folder, name)

    def load(self):
        """Reads the particles of the frame asked for, or of the last one."""
        try:
            sets = list(xml.parse(self.path("particles.pvd")).getroot().iter("DataSet"))
        except (FileNotFoundError, xml.ParseError):
            raise Missing(f"no particles.pvd in {self.folder}, or it is cut off") from None
        number = len(sets) - 1 if self.frame is None else self.frame
        if not 0 <= number < len(sets):
            raise Missing(f"no frame {number} among the {len(sets)} in {self.folder}")
        self.is_last = number == len(sets) - 1
        self.time = float(sets[number].get("timestep"))
        self.particles = read_vtp(self.path(sets[number].get("file")))
        self.x = self.particles["Points"]
        self.is_line = self.geometry == "line" or not (self.geometry or self.x[:, 1].any())

    def has(self, picture, columns):
        """Whether the particles have what a picture shows. Says what is not there, in one line."""
        lacking = [name for name in columns if name not in self.particles]
        if lacking:
            names = ", ".join(f"'{name}'" for name in lacking)
            print(f"plot: no picture '{picture}': the output has no column {names} (output/columns)",
                  file=sys.stderr)
        return not lacking

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
            facts.append("t = {:.5g} {}".format(*prefixed(self.time, "s")[::2]))
            facts.append(f"{len(self.x):,} particles")
        if self.cell:
            facts.append("cells of {:.4g} {}".format(*prefixed(self.cell, "m")[::2]))
        height = fig.get_figheight()
        fig.text(0.02, 1 - 0.12 / height, self.title, va="top", size=14, weight="bold", color=INK)
        fig.text(0.02, 1 - 0.42 / height, "   |   ".join(facts), va="top", color=GREY)
        suffix = "" if self.frame is None else f"_{self.frame:06d}"
        path = self.path(f"pictures/{name}{suffix}.png")
        try:
            os.makedirs(self.path("pictures"), exist_ok=True)
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
    prefix = {-9: "n", -6: r"$\mathrm{\mu}$", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}[power]
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
