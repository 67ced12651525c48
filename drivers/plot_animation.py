"""A field of one or several runs as a film: GIF by Pillow, MP4 by ffmpeg, both packages of Debian."""
import os
import shutil

from matplotlib.animation import FFMpegWriter, PillowWriter

from plot_field import FieldPicture, names_of, nearest
from plot_files import Missing
from plot_libraries import np, plt
from plot_options import is_file
from plot_run import place, readable_time

SECONDS = 6  # that a film lasts
PIXELS = 450  # of the longer side of a map


def writer_for(ending, frames):
    rate = int(np.clip(round(frames / SECONDS), 3, 25))
    if ending == ".gif":
        return PillowWriter(fps=rate), "a GIF by python3-pil"
    if not shutil.which("ffmpeg"):
        raise Missing("no ffmpeg for MP4; install the Debian package ffmpeg, or name a .gif")
    # Players want an even number of pixels and no more than 8 bits a colour.
    more = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"]
    return FFMpegWriter(fps=rate, extra_args=more), "an MP4 by ffmpeg"


def animate(runs, name, times, asked, log):
    """All outputs of the first run, or those nearest to the times; of the other runs what is nearest."""
    out = runs[0].out
    usual = ".mp4" if shutil.which("ffmpeg") else ".gif"
    ending = os.path.splitext(out)[1].lower() if is_file(out) else usual
    moments = [one[0] for one in runs[0].outputs()]
    numbers = [[nearest(run, time) for run in runs] for time in times] if times else [
        [k] + [int(np.argmin([abs(one[0] - t) for one in run.outputs()])) for run in runs[1:]]
        for k, t in enumerate(moments)]
    writer, how = writer_for(ending, len(numbers))
    film = FieldPicture(runs, name, numbers, asked, log)
    fig, axes, panels = film.figure(1, len(runs), PIXELS)

    def show(row):
        for panel, sample, called in zip(panels, row, names_of(runs)):
            picture = panel.show(sample)
            title = [called] if len(runs) > 1 else []
            panel.ax.set_title("   ".join(title + [f"t = {readable_time(sample.time)}"]))
        return picture

    picture = show(film.samples[0])
    if picture is not None:
        film.bar(fig, axes, picture)
    film.title(fig)
    fig.draw_without_rendering()
    fig.set_layout_engine("none")  # nothing moves from here on
    path = place(out, film.file(times) + ending)
    try:
        with writer.saving(fig, path, dpi=100):
            for row in film.samples:
                show(row)
                writer.grab_frame()
    except OSError as problem:
        raise Missing(f"cannot write {path}: {problem.strerror}") from None
    plt.close(fig)
    print(f"{path}: {len(numbers)} outputs, {how}")
