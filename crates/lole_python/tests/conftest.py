"""What the tests share: a small sweep in a folder of its own."""

from pathlib import Path

import pytest

SMALL = {"skirt": {"column_count": 96, "row_count": 40}}


@pytest.fixture
def small() -> dict[str, dict[str, int]]:
    """A skirt coarse enough that a run takes a second or two."""
    return {table: dict(keys) for table, keys in SMALL.items()}


@pytest.fixture
def sweep_file(tmp_path: Path) -> Path:
    """Eight runs of half a second."""
    (tmp_path / "small.lole").write_text("lole = 1\n[skirt]\ncolumn_count = 96\nrow_count = 40\n")
    path = tmp_path / "sweep.toml"
    path.write_text(
        'lole_sweep = 1\ndesign = "small.lole"\nkind = "latin-hypercube"\ncount = 8\nseed = 3\nfiles = ["series"]\n'
        '[fixed]\n"motion.duration_s" = 0.5\n'
        '[[axis]]\nkey = "skirt.gather_ratio"\nfrom = 1.5\nto = 4\n'
        '[[axis]]\nkeys = ["fabric.bend_warp_un_m", "fabric.bend_weft_un_m"]\nfrom = 1\nto = 100\nscale = "log"\n'
        '[[axis]]\nkey = "skirt.hem_height_cm"\nvalues = [20, 28]\n'
    )
    return path
