"""What the pictures stand on, held against what can be said by hand. Fails with the assertion that is wrong:
python3 plot_check.py FOLDER_OF_THE_SCRIPTS"""
import sys
from collections import namedtuple

sys.path.insert(0, sys.argv[1])

from plot_columns import plain
from plot_libraries import np
from plot_raster import Raster
from plot_run import prefixed, readable_time
from plot_scale import Scale

Field = namedtuple("Field", "name column is_material is_signed dimensions unit colours materials")
Values = namedtuple("Values", "values volume")


def lattice(count):
    """Points of a unit square, each in the middle of its own."""
    at = (np.arange(count) + 0.5) / count
    x, y = np.meshgrid(at, at)
    return np.stack([x.ravel(), y.ravel()], axis=1), np.full(count * count, 1 / count)


def image_of(count, pixels, **more):
    xy, side = lattice(count)
    raster = Raster(xy, side, np.zeros(2), np.ones(2), pixels=pixels, **more)
    return raster.image(xy[:, 0], side**2)


def check_raster():
    centres = (np.arange(60) + 0.5) / 60
    # Six pixels a point: each shows the point that it lies in.
    broad = image_of(10, 60, breadth=1)
    assert np.array_equal(broad, np.tile((np.floor(centres * 10) + 0.5) / 10, (60, 1)))
    # A hundred points a pixel: each shows their mean, which is x in its middle.
    assert np.allclose(image_of(600, 60), np.tile(centres, (60, 1)), rtol=0, atol=1e-12)
    # Outside of the points there is nothing.
    low = np.array((-1.0, 0.0))
    half = Raster(*lattice(10), low, np.ones(2), breadth=1, pixels=100).image(np.ones(100), np.ones(100))
    assert half.shape == (50, 100) and np.isnan(half[:, :50]).all() and (half[:, 50:] == 1).all()
    # Every other row of a fluid is gone: what is left fills the gaps. A solid has them.
    xy, side = lattice(20)
    some = np.round(xy[:, 1] * 20 - 0.5).astype(int) % 2 == 0
    for spread, empty in ((np.ones(some.sum(), dtype=bool), 0), (None, 1)):
        seen = Raster(xy[some], side[some], np.zeros(2), np.array((1, 0.95)), spread, pixels=100).seen
        assert (seen < 0).any() == empty


def check_scale():
    def scale(*samples, signed=False, **more):
        field = Field("p", "p", False, signed, 2, "Pa", "viridis", {})
        return Scale(field, [Values(np.array(one, dtype=float), np.ones(len(one))) for one in samples], **more)

    one = scale([1e6, 2e6], [3e6, 8e6])  # both samples on one scale, from 0
    assert (one.norm.vmin, one.norm.vmax, one.unit, one.factor) == (0, 8, "MPa", 1e6)
    both = scale([-3.0, 1.0], signed=True)
    assert (both.norm.vmin, both.norm.vmax, both.colours) == (-3, 3, "RdBu_r")
    given = scale([1.0, 2.0], asked=(1.2, 1.6))
    assert (given.norm.vmin, given.norm.vmax, given.extend) == (1.2, 1.6, "both")
    many = scale([1e-9, 100.0], log=True)  # four decades of it
    assert np.isclose(many.norm.vmin, 0.01) and many.norm.vmax == 100
    assert many.shown(np.array([0.0, 50.0])).tolist() == [0.1 * many.norm.vmin, 50.0]


check_raster()
check_scale()
assert plain("Grid/Pressure") == plain("grid_pressure") == "grid pressure"
assert plain("velocity magnitude") == "velocity"
assert readable_time(2.5e-4) == "250 µs" and prefixed(np.array((7800.0,)), "kg/m$^3$")[2] == "kg/m$^3$"
