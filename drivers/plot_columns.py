"""The fields of a run by name: every column of its particles and of its grid, with unit and looks."""
from collections import namedtuple

from plot_files import Missing, Mistake, complete, read_grid, read_series, read_vtk
from plot_libraries import np
from plot_run import COLOURS, FLUIDS, NAMES, UNITS

UNITS_OF_MORE = {
    "mass": "kg", "volume": "m$^3$", "burned": "-", "lighting time": "s", "damage": "-", "decohesion": "-",
    "crack density": "-", "damage work": "J/kg", "decohesion work": "J/kg", "plastic work": "J/kg",
    "plastic strain": "-", "normal x": "-", "normal y": "-", "opening": "m", "slip": "m",
    "peak rate": "1/s", "strength": "Pa", "fill": "-", "temperature": "K", "sound speed": "m/s"}
SHARES = ("damage", "decohesion", "burned", "crack density", "plastic strain", "fill")  # 0 is nothing
OTHER_NAMES = {"speed": "velocity", "velocity magnitude": "velocity"}
AXES = "xyz"

# A field at one output. `x`: (n, 3) [m]; `side` of the square that a row fills [m]; `volume`: what it
# weighs in means; `material`: its number, `fluid`: whether it is one, None where that was not written and
# for a grid.
Sample = namedtuple("Sample", "time number x side volume values material fluid")


def plain(name):
    """However a name is written: "Grid/Pressure", "grid_pressure", "grid pressure"."""
    name = " ".join(name.lower().replace("_", " ").replace("/", " ").split())
    return OTHER_NAMES.get(name, name)


def names_in(arrays, dimensions):
    """The scalar columns; of vectors their magnitude and their components, on a line what is along it."""
    names = []
    for name, values in arrays.items():
        if name in ("Points", "connectivity", "offsets", "spacing", "id"):
            continue
        names.append(name)
        if values.ndim > 1 and dimensions > 1:
            names += [f"{name} {axis}" for axis in AXES[:dimensions]]
    return names


def column(arrays, name, dimensions):
    base, _, axis = name.rpartition(" ")
    if base in arrays and arrays[base].ndim > 1 and axis in AXES:
        return arrays[base][:, AXES.index(axis)]
    values = arrays[name]
    if values.ndim > 1 and dimensions == 1:
        return values[:, 0]
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else np.asarray(values, dtype=float)


class Field:
    """A column of runs, found by its name in the last output of the first. Raises Mistake with what there
    is for a name that is unknown. `materials`: law of each by its name, of all runs."""

    def __init__(self, runs, name):
        run = runs[0]
        self.dimensions = 1 if run.is_line else 2
        there = []
        for kind, prefix in (("particles", ""), ("grid", "grid ")):
            try:
                there += [(prefix + one, kind, one)
                          for one in names_in(self.arrays(run, kind, -1)[1], self.dimensions)]
            except Missing:
                continue
        if not there:
            raise Missing(f"'{run.folder}' holds neither particles nor grids")
        wanted = plain(name)
        found = [one for one in there if plain(one[0]) == wanted] or [
            one for one in there if one[1] == "grid" and plain(one[2]) == wanted]
        if not found:
            known = ", ".join(one[0] for one in there)
            raise Mistake(f"no field '{name}' in {run.folder}; there are: {known}")
        self.name, self.kind, self.column = found[0]
        self.base = self.column.rpartition(" ")[0] if self.column[-2:] in (" x", " y", " z") else ""
        self.is_material = self.column == "material"
        self.materials = {name: law for run in runs for name, law in run.materials}

    @staticmethod
    def arrays(run, kind, number):
        """Time [s] and columns of an output, from particles or grid."""
        time, file = read_series(run.path(kind + ".pvd"))[number]
        path = run.path(file)
        return time, read_grid(path) if kind == "grid" else complete(
            read_vtk(path)[1], ("Points",), path)

    def sample(self, run, number):
        time, arrays = self.arrays(run, self.kind, number)
        try:
            values = column(arrays, self.column, self.dimensions)
        except KeyError:
            raise Missing(f"no field '{self.name}' in {run.folder}") from None
        if self.kind == "particles":
            if "volume" not in arrays and not run.is_line:
                raise Missing(f"no map of {run.folder}: the output has no column 'volume' (output/columns)")
            volume = arrays["volume"] if "volume" in arrays else np.zeros(len(values))
            side = volume if run.is_line else np.sqrt(volume)  # of particles that are one metre deep
            if "material" not in arrays:
                return Sample(time, number, arrays["Points"], side, volume, values, None, None)
            fluids = [k for k, (_, law) in enumerate(run.materials) if law in FLUIDS]
            if self.is_material:  # numbered alike in all runs
                numbers = [list(self.materials).index(name) for name, _ in run.materials]
                values = np.array(numbers, dtype=float)[arrays["material"]]
            return Sample(time, number, arrays["Points"], side, volume, values, arrays["material"],
                          np.isin(arrays["material"], fluids))
        full = arrays["fill"] > 0
        side = np.full(full.sum(), arrays["spacing"])
        return Sample(time, number, arrays["Points"][full], side, side**self.dimensions, values[full], None, None)

    @property
    def unit(self):
        known = {**UNITS, **UNITS_OF_MORE}
        if self.column.startswith("stress"):
            return "Pa"
        return known.get(self.column, known.get(self.base, ""))

    @property
    def label(self):
        name = NAMES.get(self.column, self.column)
        if self.column == "velocity" and self.dimensions > 1:
            name = "speed"
        return name + (" (mean of the cell)" if self.kind == "grid" and self.column != "fill" else "")

    @property
    def colours(self):
        return "magma_r" if self.column in SHARES else COLOURS.get(self.column, "viridis")

    @property
    def is_signed(self):
        """Whether values below 0 mean as much as those above."""
        if self.column == "velocity" and self.dimensions == 1:
            return True
        return bool(self.base) and self.base != "normal" or self.column.startswith("stress")
