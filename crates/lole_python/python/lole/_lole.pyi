"""Types of the compiled module; what each thing means stands in its docstring there and is repeated here."""

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

__version__: str

class LoleError(ValueError):
    """What was asked for cannot be done; its text is one sentence, and ``japanese`` the same in Japanese."""

    japanese: str

class Diverged(RuntimeError):
    """The cloth flew apart; its text says when and where."""

    japanese: str

@final
class Design:
    """A design document: from a dict of tables, from a file, or the built-in pāʻū skirt."""

    def __new__(
        cls, source: Mapping[str, Any] | str | PathLike[str] | None = None
    ) -> Design: ...
    @property
    def text(self) -> str:
        """The document as TOML: what ``lole dance`` reads."""
    def to_dict(self) -> dict[str, Any]:
        """The document as tables; ``Design(design.to_dict())`` is the same design."""
    def replaced(self, keys: Mapping[str, Any]) -> Design:
        """The same design with other values, such as ``{"skirt.gather_ratio": 3}``."""
    def draft(self) -> dict[str, Any] | None:
        """The skirt on paper, lengths in cm; ``None`` where none is worn."""
    def cost(self) -> dict[str, Any]:
        """The bill: what is paid for, in the design's currency; a line without a price has no sum, and ``asks``
        names the key that would tell it."""

@final
class Dancer:
    """The dancer of a design, standing."""

    def __new__(cls, design: Design | None = None) -> Dancer: ...
    @property
    def measures(self) -> dict[str, float]:
        """Her tape, taken on her body [cm]."""
    def positions(self) -> NDArray[np.float32]:
        """Vertices of her skin [m], shape ``[vertices, 3]``."""
    def triangles(self) -> NDArray[np.uint32]:
        """Triangles of her skin, shape ``[triangles, 3]``."""

@final
class Performance:
    """A dancer in what she wears, moved on by frames of 1/60 s."""

    def __new__(cls, design: Design | None = None, *, threads: int = 1) -> Performance: ...
    @property
    def time(self) -> float:
        """Time of the dance [s]; negative while the cloth settles."""
    @property
    def garments(self) -> dict[str, tuple[int, int]]:
        """Begin and end of each gathered garment's particles in :meth:`positions`."""
    @property
    def state_hash(self) -> str:
        """All bits of the cloth as 16 hexadecimal digits."""
    def settle(self) -> None:
        """Lets the cloth come to rest on the standing dancer: at most three seconds, to time 0."""
    def step(self, frames: int = 1) -> None:
        """Moves on by so many frames."""
    def run(
        self,
        seconds: float,
        *,
        every: int = 2,
        callback: Callable[[Performance], object] | None = None,
    ) -> NDArray[np.float32]:
        """Dances so long [s], and gives the positions of every so many frames [m],
        shape ``[pictures, particles, 3]``; ``callback`` is called after each frame, and ends the dance by
        returning ``False``."""
    def positions(self) -> NDArray[np.float32]:
        """Where every particle of the cloth is now [m], shape ``[particles, 3]``: a copy, because the cloth
        moves on under a view."""
    def positions_into(self, out: NDArray[np.float32]) -> None:
        """The same, into an array of one's own of that shape: nothing is allocated."""
    def body_positions(self) -> NDArray[np.float32]:
        """Vertices of the posed skin [m], shape ``[vertices, 3]``."""
    def measure(self) -> dict[str, float]:
        """This frame in numbers: strain in percent, depth in the skin in mm, height of the hem in cm."""

@final
class Sweep:
    """Runs by the thousand: a sweep in a file, performed in any order by anyone."""

    def __new__(cls, path: str | PathLike[str]) -> Sweep: ...
    def __len__(self) -> int: ...
    @property
    def parameters(self) -> list[str]:
        """What is varied: names of columns of the table."""
    def run(self, number: int) -> dict[str, Any]:
        """``id``, ``values`` and ``document`` of a run, counted from 0."""
    def is_done(self, number: int, out: str | PathLike[str]) -> bool:
        """Whether the folder holds the run."""
    def perform(self, number: int, out: str | PathLike[str]) -> dict[str, Any]:
        """Performs a run unless the folder holds it, keeps it there, and gives its record."""
    def missing(self, out: str | PathLike[str]) -> list[int]:
        """The runs that are to be performed, because the folder does not hold them; of equal runs only the first."""
    def gather(self, out: str | PathLike[str], others: Sequence[str | PathLike[str]]) -> int:
        """Takes over runs from other folders; how many."""
    def write_table(self, out: str | PathLike[str]) -> str:
        """Writes ``runs.csv`` and ``runs.parquet`` into the folder; the CSV as text."""

def fabrics() -> list[dict[str, Any]]:
    """The fabrics of the shelf, in SI units."""

def validate(only: str | None = None) -> list[dict[str, Any]]:
    """The engine against closed forms, a row each: what was measured, its reference and its bounds."""

def bench(design: Design | None = None, *, frames: int = 120, threads: int = 1) -> dict[str, Any]:
    """What a frame of a design costs on this machine, once it has settled: ``frame_ms`` of processor time and
    ``frame_wall_ms``, median and 99th percentile."""
