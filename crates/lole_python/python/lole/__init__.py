"""Lole: hula costume CAD with live cloth.

Lengths of positions are metres, world axes are right-handed with ``+Y`` up and ``+Z`` the dancer's front, and
the floor is at 0.  What a design holds carries its unit in the key, such as ``hem_height_cm``.  Long work runs
without Python's lock, on the calling thread or as many as ``threads`` says, and gives the same bits either way.

>>> import lole
>>> design = lole.Design({"skirt": {"gather_ratio": 3}})
>>> performance = lole.Performance(design)
>>> performance.settle()
>>> performance.step(60)
>>> performance.positions().shape[1]
3
"""

from ._lole import (
    Dancer,
    Design,
    Diverged,
    LoleError,
    Performance,
    Sweep,
    __version__,
    bench,
    fabrics,
    validate,
)

__all__ = [
    "Dancer",
    "Design",
    "Diverged",
    "LoleError",
    "Performance",
    "Sweep",
    "__version__",
    "bench",
    "fabrics",
    "validate",
]
