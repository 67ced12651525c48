"""A field at one output in one pair of axes: a map of the plane, or a line over x. Each can show another
output in place of the first, as an animation needs."""
import os

from plot_files import Missing, read_csv
from plot_libraries import np, plt
from plot_raster import BREADTH, PIXELS, Raster
from plot_run import FLUIDS, INK, RED, UNITS, prefixed, readable_time

BACKGROUND = "#eef1f3"


def common_limits(runs, samples):
    """Corners that hold the squares of all samples, in whole cells; (3,) each [m]."""
    half = 0.5 - 1e-6  # a body that fills whole cells needs no more
    ends = [run.limits(one.x + sign * half * one.side[:, None]) for sign in (-1, 1)
            for run, one in zip(runs, samples) if len(one.x)]
    if not ends:
        raise Missing("nothing is left to draw")
    return np.min([end[0] for end in ends], axis=0), np.max([end[1] for end in ends], axis=0)


class MapPanel:
    """`limits`: corners of the picture [m]."""

    def __init__(self, ax, run, field, scale, limits, pixels=PIXELS):
        self.ax, self.run, self.scale, self.pixels = ax, run, scale, pixels
        self.mean = not field.is_material
        self.low, self.high = (end[:2] for end in limits)
        _, self.metre, unit = prefixed(self.high - self.low, "m")
        self.picture, self.outlines = None, []
        ax.set(aspect="equal", facecolor="#c9d0d5" if scale.signed else BACKGROUND,
               xlim=(self.low[0] / self.metre, self.high[0] / self.metre),
               ylim=(self.low[1] / self.metre, self.high[1] / self.metre))
        ax.grid(False)
        self.labels = (f"x [{unit}]", f"y [{unit}]")

    def show(self, sample):
        breadth = 1 if sample.material is None else BREADTH
        raster = Raster(sample.x[:, :2], sample.side, self.low, self.high, sample.fluid, breadth, self.pixels)
        image = self.scale.shown(raster.image(sample.values, sample.volume, self.mean))
        extent = np.array(raster.extent) / self.metre
        if self.picture is None:
            self.picture = self.ax.imshow(image, origin="lower", extent=extent, norm=self.scale.norm,
                                          cmap=self.scale.colours, interpolation="nearest")
        else:
            self.picture.set_data(image)
        self.outline(sample, raster, extent)
        return self.picture

    def outline(self, sample, raster, extent):
        """A line around each solid, where there is something beside it."""
        for line in self.outlines:
            line.remove()
        self.outlines = []
        if sample.material is None or len(self.run.materials) < 2:
            return
        material = np.where(raster.seen >= 0, sample.material[raster.seen], -1)
        for number, (_, law) in enumerate(self.run.materials):
            there = material == number
            if law in FLUIDS or there.all() or not there.any():
                continue
            contour = self.ax.contour(there, levels=[0.5], colors=self.scale.ink, linewidths=0.5, origin="lower",
                                      extent=extent)
            self.outlines += contour.collections


class LinePanel:
    """Heights are those of the scale."""

    def __init__(self, ax, run, field, scale, limits, **_):
        self.ax, self.run, self.field, self.scale, self.line, self.exact = ax, run, field, scale, None, None
        _, self.metre, unit = prefixed(np.array((limits[0][0], limits[1][0])), "m")
        low, high = scale.norm.vmin, scale.norm.vmax
        margin = 0.04 * (high - low)
        ends = (low - margin, high + margin)
        if scale.log and low < 0:
            ax.set_yscale("symlog", linthresh=scale.norm.linthresh)
        elif scale.log:
            ax.set_yscale("log")
            ends = (low / 1.2, high * 1.2)
        ax.set(xlim=(limits[0][0] / self.metre, limits[1][0] / self.metre), ylim=ends)
        self.labels = (f"x [{unit}]", scale.label(field))

    def show(self, sample, colour=INK):
        order = np.argsort(sample.x[:, 0], kind="stable")
        x, values = sample.x[order, 0] / self.metre, sample.values[order] / self.scale.factor
        if self.line is None or colour != self.line.get_color():
            self.line, = self.ax.plot(x, values, ".-", ms=3.2, lw=0.9, mew=0, color=colour,
                                      label=f"t = {readable_time(sample.time)}")
        else:
            self.line.set_data(x, values)

    def show_exact(self, sample):
        """The exact solution, which the run tells at its end only."""
        path = self.run.path("exact.csv")
        is_last = sample.number == len(self.run.outputs()) - 1
        if not is_last or self.field.column not in UNITS or not os.path.exists(path):
            return
        table = read_csv(path, tuple(UNITS))
        if "x" in table:
            self.ax.plot(table["x"] / self.metre, table[self.field.column] / self.scale.factor, color=RED,
                         lw=1, label="exact")


def panel_kind(run):
    return LinePanel if run.is_line else MapPanel


def colours_of(count):
    """Of lines at as many times, early ones light."""
    return [INK] if count == 1 else [plt.get_cmap("viridis_r")(x) for x in np.linspace(0.12, 1, count)]
