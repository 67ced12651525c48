"""One scale of colours, or of heights, for all samples of a field."""
from matplotlib.colors import BoundaryNorm, ListedColormap, LogNorm, Normalize, SymLogNorm, TwoSlopeNorm

from plot_files import Mistake
from plot_libraries import np
from plot_run import BLUE, GREY, INK, NAVY, RED, TEAL, VIOLET, prefixed, value_range

MOST = 100_000  # values of a sample that the range is taken from
DECADES = 4  # below the top of a logarithmic scale
OF_LAWS = {"jwl": RED, "perfect gas": "#d7e3ee", "linear fluid": BLUE, "von mises": NAVY,
           "concrete": "#9aa5ad", "drucker prager": "#c2a878", "elastic": TEAL}
OF_MORE = (VIOLET, GREY, "#f2b134", "#8ab17d", "#b56576")  # where two materials have the same law


def colours_of_materials(materials):
    """By their laws, so that steel is steel in every picture."""
    colours, more = [], iter(OF_MORE * (1 + len(materials)))
    for _, law in materials:
        usual = OF_LAWS.get(law)
        colours.append(usual if usual and usual not in colours else next(more))
    return colours


class Scale:
    """`low`, `high`: ends in units of the field; `factor`, `unit`: what numbers on paper are divided by and
    called; `norm`, `colours`: for matplotlib, of the divided numbers. `asked`: ends that were given, in
    units of the field."""

    def __init__(self, field, samples, asked=None, log=False):
        self.log, self.signed, self.materials = log, False, ()
        values, volume = (np.concatenate([getattr(one, name)[:: 1 + len(one.values) // MOST] for one in samples])
                          for name in ("values", "volume"))
        self.low, self.high = asked or value_range(values, volume)[:2]
        self.least = min(one.values.min(initial=np.inf) for one in samples)
        self.most = max(one.values.max(initial=-np.inf) for one in samples)
        if field.dimensions == 1 and not asked:  # a line shows its peaks
            self.low, self.high = self.least, self.most
        if field.is_material:
            self.factor, self.unit = 1, ""
            self.materials = list(field.materials)
            self.colours = ListedColormap(colours_of_materials(field.materials.items()))
            self.norm = BoundaryNorm(np.arange(len(self.materials) + 1) - 0.5, len(self.materials))
            return
        self.signed = field.is_signed or self.low < -0.1 * abs(self.high)
        if asked is None and not self.signed and 0 < self.low < 0.5 * self.high and not log:
            self.low = 0.0
        if asked is None and self.signed and field.dimensions > 1:
            self.high = max(-self.low, self.high) or 1.0
            self.low = -self.high
        if asked is None and not self.low < self.high:  # the same everywhere
            self.low, self.high = self.low - 0.5, self.high + 0.5
        _, self.factor, self.unit = prefixed(np.array((self.low, self.high)), field.unit)
        self.colours = "RdBu_r" if self.signed else field.colours
        low, high = self.low / self.factor, self.high / self.factor
        if not log:
            both = self.signed and low < 0 < high
            self.norm = TwoSlopeNorm(0, low, high) if both else Normalize(low, high)
        elif self.signed and low < 0 < high:
            self.norm = SymLogNorm(max(-low, high) * 10.0**-DECADES, vmin=low, vmax=high)
        else:
            if self.high <= 0:
                raise Mistake(f"nothing of '{field.name}' is above 0: it has no logarithm")
            if asked and low <= 0:
                raise Mistake(f"--range {asked[0]:g} {asked[1]:g} with --log: MIN must be above 0")
            self.norm = LogNorm(low if asked else max(low, high * 10.0**-DECADES), high)

    def shown(self, values):
        """In the unit on paper; what has no logarithm is as little as there is."""
        values = values / self.factor
        return np.maximum(values, 0.1 * self.norm.vmin) if isinstance(self.norm, LogNorm) else values

    @property
    def ink(self):
        """Of lines that must be seen on the colours."""
        light = self.materials or self.signed or self.colours.endswith("_r")
        return INK if light else "#e8ecef"

    @property
    def extend(self):
        """Which ends of the bar stand for more than they say."""
        if self.materials:
            return "neither"
        margin = 0.01 * (self.high - self.low)
        below = self.least < self.norm.vmin * self.factor - margin
        above = self.most > self.high + margin
        return {(0, 0): "neither", (1, 0): "min", (0, 1): "max", (1, 1): "both"}[below, above]

    def label(self, field):
        return field.label + (f" [{self.unit}]" if self.unit else "")
