"""numpy and matplotlib, from the python that has them; every script that draws takes them from here."""
import os
import sys

try:
    import numpy as np
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    # A private python may stand in front of the one that the distribution's packages belong to.
    python = "/usr/bin/python3"
    if os.path.exists(python) and not os.path.samefile(sys.executable, python):
        os.execv(python, [python, *sys.argv])
    missing = "numpy" if error.name == "numpy" else "matplotlib"
    print(f"plot: no {missing}; install the Debian package python3-{missing}", file=sys.stderr)
    sys.exit(1)

__all__ = ["np", "plt"]
