"""Density, pressure, speed and specific internal energy in the plane, each on a scale of its own."""
from mpl_toolkits.axes_grid1 import make_axes_locatable

from plot_columns import Field
from plot_libraries import np, plt
from plot_panels import MapPanel, common_limits
from plot_run import COLOURS, value_range
from plot_scale import Scale


def draw_maps(run):
    run.expect(("volume", *COLOURS))
    samples = {key: Field([run], key).sample(run, run.number) for key in COLOURS}
    low, high = common_limits([run], [samples["density"]])
    extent = np.maximum(high - low, 1e-3 * (high - low).max())[:2]
    aspect = extent[1] / extent[0]
    rows, columns = (4, 1) if aspect < 0.25 else (1, 4) if aspect > 2 else (2, 2)
    width = {1: 9.5, 2: 4.4, 4: max(7 / aspect, 1.5)}[columns]
    size = (columns * (width + 1.2), rows * (width * aspect + 0.7) + 0.7)
    fig, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, sharex=True, sharey=True)
    for ax, key in zip(axes.flat, COLOURS):
        field, sample = Field([run], key), samples[key]
        many_decades = key == "energy" and value_range(sample.values, sample.volume)[2]
        scale = Scale(field, [sample], log=many_decades)
        panel = MapPanel(ax, run, field, scale, (low, low + np.append(extent, 0)))
        picture = panel.show(sample)
        ax.set_title(scale.label(field))
        bar = make_axes_locatable(ax).append_axes("right", size=0.12, pad=0.08)
        fig.colorbar(picture, cax=bar, extend=scale.extend, extendfrac=0.03)
    plt.setp(axes[-1], xlabel=panel.labels[0])
    plt.setp(axes[:, 0], ylabel=panel.labels[1])
    fig.tight_layout(rect=(0, 0, 0.995, 1 - 0.68 / size[1]))
    run.save(fig, "fields")
