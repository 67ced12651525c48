"""Points as an image: as fast with millions of them as with thousands."""
from plot_libraries import np

PIXELS = 900  # along the longer side
BREADTH = 1.15  # of a square: points are never quite one beside the other
SPREAD, COARSE = 3.2, 3  # breadth of what fills gaps in a fluid, and of its pixels


def paint(shape, at, side, breadth):
    """The number of the point seen at each pixel, -1 where there is none. `at`, `side`: in pixels. Narrow
    points lie above broad ones; those that cover as many pixels are painted at once."""
    seen = np.full(shape, -1, dtype=np.int64)
    half = 0.5 * breadth * side[:, None]
    first = np.round(at - half).astype(int)
    count = np.maximum(np.round(at + half).astype(int) - first, 1)
    order = np.argsort(-side, kind="stable")
    kinds = (count[:, 0] * (count[:, 1].max(initial=0) + 1) + count[:, 1])[order]
    for kind in np.unique(kinds)[::-1]:
        points = order[kinds == kind]
        column, row = first[points].T
        width, height = count[points[0]]
        for dy in range(height):
            for dx in range(width):
                x, y = column + dx, row + dy
                inside = (x >= 0) & (x < shape[1]) & (y >= 0) & (y < shape[0])
                seen[y[inside], x[inside]] = points[inside]
    return seen


class Raster:
    """Which point is seen at each pixel, `seen`. `xy`: (n, 2), `side` of a point's square, `low`, `high`:
    corners of the image, all in metres; `spread`: which points also fill the gaps beside them, as those of a
    fluid that is drawn out in one direction."""

    def __init__(self, xy, side, low, high, spread=None, breadth=BREADTH, pixels=PIXELS):
        pixel = (high - low).max() / pixels
        self.shape = tuple(np.maximum(np.ceil((high - low) / pixel - 1e-9).astype(int), 1)[::-1])
        self.extent = (low[0], low[0] + self.shape[1] * pixel, low[1], low[1] + self.shape[0] * pixel)
        at, side = (xy - low) / pixel, side / pixel
        self.seen = paint(self.shape, at, side, breadth)
        if spread is not None and spread.any():
            numbers = np.append(np.flatnonzero(spread), -1)
            coarse = paint([-(-n // COARSE) for n in self.shape], at[spread] / COARSE, side[spread] / COARSE,
                           SPREAD)
            broad = numbers[coarse].repeat(COARSE, axis=0).repeat(COARSE, axis=1)
            self.seen = np.where(self.seen >= 0, self.seen, broad[: self.shape[0], : self.shape[1]])
        # Where points are smaller than pixels, an image of single ones would be noise.
        inside = ((at >= 0) & (at < self.shape[::-1])).all(axis=1)
        self.small = np.flatnonzero(inside & (side < 0.7))
        column, row = at[self.small].astype(int).T
        self.bins = row * self.shape[1] + column
        is_small = np.zeros(len(side) + 1, dtype=bool)  # the last stands for no point at all
        is_small[self.small] = True
        self.averaged = is_small[self.seen]

    def image(self, values, volume, mean=True):
        """The values seen, nan where there is nothing; the mean by volume of points smaller than pixels."""
        out = np.where(self.seen >= 0, values[self.seen], np.nan)
        if mean and len(self.small):
            weight = np.bincount(self.bins, volume[self.small], out.size).reshape(out.shape)
            total = np.bincount(self.bins, (volume * values)[self.small], out.size).reshape(out.shape)
            many = self.averaged & (weight > 0)
            out[many] = total[many] / weight[many]
        return out
