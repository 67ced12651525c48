"""The concrete box with the bomb at one time: which points are what, and where, from its centre."""
from plot_run import np

FACE = 0.65  # from the centre to the wall's inner face [m]
LAWS = {"explosive": ("jwl",), "air": ("perfect gas",), "steel": ("von mises",), "concrete": ("concrete",)}


class Box:
    def __init__(self, result, number):
        self.run = result.frame(number)
        self.particles = self.run.particles
        centre = result.parameter("burst", "centre", "{1, 1}").strip("{} ").split(",")
        self.xy = self.run.x[:, :2] - np.array(centre, dtype=float)
        self.reach = np.abs(self.xy).max(axis=1)  # in the max-norm: the box is a square
        for kind, laws in LAWS.items():
            setattr(self, kind, result.of_law(self.particles, *laws))

    def outward_velocity(self, kind):
        """Mean by mass of the velocity away from the centre."""
        there = getattr(self, kind)
        if not there.any():
            return 0.0
        away, velocity = self.xy[there], self.particles["velocity"][there, :2]
        outward = (away * velocity).sum(axis=1) / np.maximum(np.hypot(*away.T), 1e-12)
        return np.average(outward, weights=self.particles["mass"][there])

    def kinetic(self, kind):
        there = getattr(self, kind)
        square = (self.particles["velocity"][there] ** 2).sum(axis=1)
        return 0.5 * (self.particles["mass"][there] * square).sum()
