"""Where concrete has come apart and in which direction, and how damaged it is: Figs 11 and 12 of
Hu & Chen (2006)."""
from matplotlib.colors import ListedColormap
from mpl_toolkits.axes_grid1 import make_axes_locatable

from plot_columns import Field
from plot_libraries import np, plt
from plot_panels import BACKGROUND, common_limits
from plot_raster import Raster
from plot_run import INK, RED, prefixed

NEEDED = ("volume", "material", "damage", "decohesion", "normal x", "normal y")
OTHER = "#9aa5ad"


def draw_cracks(run):
    particles = run.particles
    numbers = [k for k, (_, law) in enumerate(run.materials) if law == "concrete"]
    if not numbers:
        return
    run.expect(NEEDED)
    concrete = np.isin(particles["material"], numbers)
    if not concrete.any():
        return
    sample = Field([run], "damage").sample(run, run.number)
    xy, sides = sample.x[:, :2], sample.side
    low, high = (end[:2] for end in common_limits([run], [sample]))
    _, scale, unit = prefixed(high - low, "m")
    aspect = (high[1] - low[1]) / (high[0] - low[0])
    width = min(6.0, 7.0 / aspect)
    fig, axes = plt.subplots(1, 3, figsize=(3 * (width + 1.1), width * aspect + 2), sharex=True,
                             sharey=True)
    raster = Raster(xy, sides, low, high, sample.fluid)

    def show(ax, values, where, **style):
        image = raster.image(np.where(where, values, np.nan), sample.volume, mean=False)
        return ax.imshow(image, origin="lower", extent=np.array(raster.extent) / scale,
                         interpolation="nearest", **style)

    apart = concrete & (particles["decohesion"] > 0)
    state = np.where(~concrete, 0, np.where(particles["decohesion"] >= 1, 3, np.where(apart, 2, 1)))
    show(axes[0], state, True, vmin=-0.5, vmax=3.5, cmap=ListedColormap((OTHER, "#dfe5e8", "#f2b134", RED)))
    some = np.flatnonzero(apart)
    some = some[:: max(1, len(some) // 1500)]
    normals = np.stack([particles["normal x"], particles["normal y"]], axis=1)[some]
    # The crack lies across its normal.
    half = 0.45 * np.minimum(sides[some], 2 * np.median(sides[concrete]))[:, None]
    half = half * np.stack([-normals[:, 1], normals[:, 0]], axis=1)
    ends = np.stack([xy[some] - half, xy[some] + half, np.full_like(half, np.nan)], axis=1)
    axes[0].plot(*(ends.reshape(-1, 2) / scale).T, color=INK, lw=0.8)
    axes[0].set_title("failure pattern and planes")
    for colour, label in ((OTHER, "other matter"), ("#dfe5e8", "sound"), ("#f2b134", "coming apart"),
                          (RED, "separate")):
        axes[0].plot([], [], "s", ms=6, color=colour, label=label)
    make_axes_locatable(axes[0]).append_axes("right", size=0.12, pad=0.08).set_visible(False)
    fig.legend(*axes[0].get_legend_handles_labels(), loc="upper right", ncol=4)
    failure = 1 - (1 - particles["damage"]) * (1 - particles["decohesion"])
    for ax, values, title, top in ((axes[1], particles["damage"], "damage D [-]", None),
                                   (axes[2], failure, "1 - (1 - D)(1 - decohesion) [-]", 1)):
        show(ax, 0, ~concrete, cmap=ListedColormap([OTHER]))
        picture = show(ax, values, concrete, cmap="magma_r", vmin=0, vmax=top)
        bar = make_axes_locatable(ax).append_axes("right", size=0.12, pad=0.08)
        fig.colorbar(picture, cax=bar)
        ax.set_title(title)
    for ax in axes:
        ax.set(xlim=(low[0] / scale, high[0] / scale), ylim=(low[1] / scale, high[1] / scale),
               xlabel=f"x [{unit}]", aspect="equal", facecolor=BACKGROUND)
        ax.grid(False)
    axes[0].set_ylabel(f"y [{unit}]")
    fig.tight_layout(rect=(0, 0, 0.995, 1 - 0.7 / fig.get_figheight()))
    run.save(fig, "cracks")
