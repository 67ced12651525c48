"""A field of one or several runs at one or several times, all on one scale."""
import os

from plot_columns import Field
from plot_files import Mistake
from plot_libraries import np, plt
from plot_panels import colours_of, common_limits, panel_kind
from plot_run import head, keep, prefixed, readable_time
from plot_scale import Scale

WIDTH, HEIGHT = 12.5, 4.6  # of a picture and of a panel, at most [inches]


def nearest(run, time):
    """The number of the output nearest to a time; the last one without any. Says what it takes."""
    times = np.array([one[0] for one in run.outputs()])
    if time is None:
        return len(times) - 1
    number = int(np.argmin(np.abs(times - time)))
    if not np.isclose(times[number], time, rtol=1e-6, atol=0):
        print(f"{run.folder}: nearest to t = {readable_time(time)} is the output at "
              f"{readable_time(times[number])}")
    return number


def names_of(runs):
    """What tells runs apart: the end of their folders' names."""
    paths = [os.path.abspath(run.folder).split(os.sep) for run in runs]
    for depth in range(1, max(map(len, paths)) + 1):
        names = [os.sep.join(path[-depth:]) for path in paths]
        if len(set(names)) == len(names):
            break
    return names


class FieldPicture:
    """The samples of a field, [time][run], and the panels that show them. `numbers`: outputs of each run,
    [time][run]; `shown`: how many times have a panel of their own, all or 1 (an animation)."""

    def __init__(self, runs, name, numbers, asked=None, log=False):
        if len({run.is_line for run in runs}) > 1:
            raise Mistake("runs on a line and in the plane cannot be drawn side by side")
        self.runs, self.field, self.numbers = runs, Field(runs, name), numbers
        self.samples = [[self.field.sample(run, n) for run, n in zip(runs, row)] for row in numbers]
        flat = [one for row in self.samples for one in row]
        if not any(len(one.values) for one in flat):
            raise Mistake(f"there is nothing to draw of '{self.field.name}'")
        self.scale = Scale(self.field, flat, asked, log)
        self.limits = common_limits(runs * len(numbers), flat)

    def figure(self, rows, columns, pixels=None):
        """A figure and its panels, row after row."""
        extent = np.maximum(self.limits[1] - self.limits[0], 1e-9)[:2]
        line = self.runs[0].is_line
        aspect = 0.62 if line else np.clip(extent[1] / extent[0], 0.08, 12)
        width = min(WIDTH / columns - 0.3, HEIGHT / aspect) if not line or columns > 1 else 8.5
        width = max(width, 1.2)
        size = (max(columns * width + 1.7, 6.0), rows * (width * aspect + 0.45) + 1.2)
        fig, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, sharex=True, sharey=True,
                                 layout="compressed")
        fig.get_layout_engine().set(rect=(0.005, 0, 0.99, 1 - 0.68 / size[1]))
        self.block = columns * width, rows * width * aspect
        kind, keywords = panel_kind(self.runs[0]), {"pixels": pixels} if pixels else {}
        panels = [kind(ax, self.runs[k % len(self.runs)], self.field, self.scale, self.limits, **keywords)
                  for k, ax in enumerate(axes.flat)]
        plt.setp(axes[-1], xlabel=panels[0].labels[0])
        plt.setp(axes[:, 0], ylabel=panels[0].labels[1])
        return fig, axes, panels

    def bar(self, fig, axes, picture):
        """The scale, as long as the panels are high."""
        width, height = self.block
        bar = fig.colorbar(picture, ax=axes, label=self.scale.label(self.field), extend=self.scale.extend,
                           extendfrac=0.03, fraction=0.17 / width, pad=0.15 / width, aspect=height / 0.17)
        if self.scale.materials:
            bar.set_ticks(range(len(self.scale.materials)), labels=self.scale.materials)
            bar.set_label("")
        bar.outline.set_visible(False)

    def title(self, fig):
        run, titles = self.runs[0], list(dict.fromkeys(one.title for one in self.runs))
        if len(self.runs) > 1:
            head(fig, self.field.label.capitalize(), titles)
            return
        cells = "cells of {:.4g} {}".format(*prefixed(run.cell, "m")[::2])
        head(fig, run.title, [run.scene] * (run.scene != run.title) + [self.field.label, cells])

    def draw(self):
        """Maps of several runs stand in columns, a row for each time; those of one run in a block. Lines of
        all times share the axes of their run."""
        times, count = len(self.samples), len(self.runs)
        is_line = self.runs[0].is_line
        columns = self.columns(times) if count == 1 and not is_line else count
        rows = 1 if is_line else -(-times * count // columns)
        fig, axes, panels = self.figure(rows, columns)
        if is_line:
            self.draw_lines(panels)
        else:
            flat = [(k, one) for row in self.samples for k, one in enumerate(row)]
            for panel, (k, sample) in zip(panels, flat):
                picture = panel.show(sample)
                name = [names_of(self.runs)[k]] if count > 1 else []
                panel.ax.set_title("   ".join(name + [f"t = {readable_time(sample.time)}"]))
            for panel in panels[len(flat):]:
                panel.ax.set_visible(False)
            self.bar(fig, axes, picture)
        self.title(fig)
        return fig

    def draw_lines(self, panels):
        for k, panel in enumerate(panels):
            for row, colour in zip(self.samples, colours_of(len(self.samples))):
                panel.show(row[k], colour)
            panel.show_exact(self.samples[-1][k])
            panel.ax.legend(ncol=4, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2)
            if len(panels) > 1:
                panel.ax.set_title(names_of(self.runs)[k], pad=26)

    def columns(self, times):
        """Of panels at several times, so that the whole is about as wide as a screen."""
        extent = np.maximum(self.limits[1] - self.limits[0], 1e-9)
        aspect = extent[1] / extent[0]
        rows = -(-times // int(np.clip(np.ceil(np.sqrt(1.6 * times * aspect)), 1, times)))
        return -(-times // rows)

    def file(self, given_times):
        """A name without its ending: the field, and the outputs that were asked for."""
        name = self.field.name.replace(" ", "_")
        if len(self.runs) > 1:
            name += f"_of_{len(self.runs)}_runs"
        numbers = [row[0] for row in self.numbers] if given_times else []
        if len(numbers) > 3:
            return f"{name}_{numbers[0]:06d}_to_{numbers[-1]:06d}"
        return name + "".join(f"_{n:06d}" for n in numbers)


def draw_field(runs, name, times, asked, log):
    numbers = [[nearest(run, time) for run in runs] for time in times or [None]]
    picture = FieldPicture(runs, name, numbers, asked, log)
    keep(picture.draw(), runs[0].out, picture.file(times) + ".png")
