"""Draws the pictures of a finished or a still running run: python3 plot.py DIR [--frame N]

Reads what the run wrote into DIR and writes PNGs into DIR/pictures. What a picture lacks is named
in one line on stderr; the others are drawn all the same, and the status is 2.
"""
import argparse
import json
import os
import sys
import xml.etree.ElementTree as xml

try:
    import numpy as np
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.colors import LogNorm, Normalize
    from mpl_toolkits.axes_grid1 import make_axes_locatable
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
            arrays[array.get("Name")] = values.reshape(-1, columns) if columns > 1 else values
    except FileNotFoundError:
        raise Missing(f"no {path}") from None
    except (ValueError, IndexError, xml.ParseError):
        raise Missing(f"{path} is cut off or no particle file") from None
    return complete(arrays, ("Points", "velocity", "mass", "volume", *UNITS), path)


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
        if name != "history":
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
    if run.is_line:
        draw_profiles(run)
    else:
        draw_fields(run)
        draw_profiles(run, radial=True)


# ---- History ----
def draw_history(run):
    energies, errors = ("total", "internal", "kinetic"), ("energy", "momentum", "mass")
    needed = ("time", *energies, *(key + "_error" for key in errors))
    table = read_csv(run.path("history.csv"), needed)
    time, _, unit_t = prefixed(table["time"], "s")
    _, scale, unit = prefixed(table["total"], "J")
    unit += {"line": "/m$^2$", "plane strain": "/m"}.get(run.geometry, "")
    fig, (upper, lower) = plt.subplots(2, 1, figsize=(8.5, 7), sharex=True)
    for key, colour in zip(energies, (INK, RED, TEAL)):
        upper.plot(time, table[key] / scale, color=colour, lw=1.8, label=key)
    for key, colour in zip(errors, (RED, TEAL, VIOLET)):
        # A logarithm knows no 0: what is conserved to the last digit runs along the bottom.
        error = np.maximum(np.abs(table[key + "_error"]), 1e-17)
        lower.semilogy(time, error, color=colour, lw=1.4, label=key)
    lower.axhline(2.2e-16, color=GREY, lw=0.9, ls=":", label="rounding")
    upper.set(ylabel=f"energy [{unit}]", ylim=(min(0, upper.get_ylim()[0]), None))
    lower.set(ylabel="error of conservation [-]", xlabel=f"time [{unit_t}]")
    lower.set(ylim=(6e-18, max(1e-12, 10 * lower.get_ylim()[1])))
    lower.set_xlim(time[0], time[-1] if len(time) > 1 else None)
    upper.legend(ncol=3, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)
    lower.legend(ncol=4, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)
    fig.tight_layout(rect=(0, 0, 0.99, 0.91), h_pad=1.2)
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
    for draw in (draw_particles, draw_history) if given.frame is None else (draw_particles,):
        try:
            draw(run)
        except Missing as missing:
            print(f"plot: {missing}", file=sys.stderr)
            status = 2
    return status


if __name__ == "__main__":
    sys.exit(main())
