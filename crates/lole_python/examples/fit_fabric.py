"""From a filmed skirt to its cloth: bending stiffness and air drag, recovered on skirts of known cloth.

    python fit_fabric.py [--out fitted] [--runs 48] [--hidden 12]

A Latin hypercube of cloths dances; what a camera could see of each hem (radius, height, folds and their depth,
swing) is fitted by a quadratic in the logarithms of stiffness and drag.  Skirts of other cloths, which the fit has
not seen, are then recovered from what is seen of them alone, by least squares weighted with the fit's own
residuals, and held against what they were made of.
"""

import argparse
import csv
import io
import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import lole

BEND, DRAG = "fabric.bend_warp_un_m", "fabric.drag_per_s"
RANGES = {BEND: (3.0, 100.0), DRAG: (0.1, 2.0)}
SEEN = ("hem_radius_cm", "hem_mean_cm", "fold_count", "fold_depth_cm", "rest_fold_depth_cm", "sway_cm")

Array = NDArray[np.float64]


def sweep(path: Path, count: int, seed: int) -> Path:
    """Writes a hypercube of cloths on a coarse skirt."""
    axes = "".join(
        f"[[axis]]\nkeys = {keys}\nfrom = {low}\nto = {high}\nscale = \"log\"\n"
        for keys, (low, high) in (
            ([BEND, "fabric.bend_weft_un_m"], RANGES[BEND]),
            ([DRAG], RANGES[DRAG]),
        )
    ).replace("'", '"')
    fixed = (
        '[fixed]\n"skirt.column_count" = 256\n"skirt.row_count" = 40\n"skirt.gather_ratio" = 2\n"motion.duration_s" = 4\n'
    )
    text = f'lole_sweep = 1\nkind = "latin-hypercube"\ncount = {count}\nseed = {seed}\n{fixed}{axes}'
    path.write_text(text, encoding="utf-8")
    return path


def perform(path: Path, out: Path) -> tuple[Array, Array]:
    """Logarithms of what the cloths are, and what is seen of them."""
    runs = lole.Sweep(path)
    missing = runs.missing(out)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        tasks = [pool.submit(runs.perform, number, out) for number in missing]
        for done, _ in enumerate((task.result() for task in tasks), 1):
            print(f"\r{path.stem}: {done}/{len(missing)}", end="", flush=True)
    rows = [row for row in csv.DictReader(io.StringIO(runs.write_table(out))) if not row["error"]]
    print(f"\r{path.stem}: {len(rows)} of {len(runs)} runs")
    cloths = np.array([[float(row[name]) for name in (BEND, DRAG)] for row in rows])
    return np.log(cloths), np.array([[float(row[name]) for name in SEEN] for row in rows])


def terms(cloths: Array) -> Array:
    """Quadratic in what the cloths are, `[cloths, 6]`."""
    low, high = np.log(np.array([RANGES[BEND], RANGES[DRAG]], dtype=np.float64)).T
    bend, drag = (2 * (cloths - low) / (high - low) - 1).T
    return np.stack([np.ones_like(bend), bend, drag, bend * bend, bend * drag, drag * drag], axis=1)


def recover(coefficients: Array, spread: Array, seen: Array) -> Array:
    """The cloth whose fitted hem is nearest to the seen one, on a fine grid of the ranges."""
    low, high = np.log(np.array([RANGES[BEND], RANGES[DRAG]], dtype=np.float64)).T
    grid: Array = low + (high - low) * np.indices((121, 121)).reshape(2, -1).T / 120
    away = (terms(grid) @ coefficients - seen) / spread
    nearest: Array = grid[np.argmin((away * away).sum(axis=1))]
    return nearest


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", type=Path, default=Path("fitted"))
    parser.add_argument("--runs", type=int, default=48)
    parser.add_argument("--hidden", type=int, default=12)
    arguments = parser.parse_args()
    out: Path = arguments.out
    out.mkdir(parents=True, exist_ok=True)
    cloths, seen = perform(sweep(out / "known.toml", arguments.runs, 1), out / "known")
    hidden, filmed = perform(sweep(out / "hidden.toml", arguments.hidden, 2), out / "hidden")
    coefficients: Array = np.asarray(np.linalg.lstsq(terms(cloths), seen, rcond=None)[0], dtype=np.float64)
    residuals = terms(cloths) @ coefficients - seen
    spread: Array = np.sqrt((residuals**2).sum(axis=0) / max(len(cloths) - terms(cloths).shape[1], 1)) + 1e-9
    for name, noise, values in zip(SEEN, spread, seen.T):
        print(f"{name:20} varies by {values.std():6.2f}, fitted to {noise:6.2f}")
    found = np.array([recover(coefficients, spread, it) for it in filmed])
    for name, error, width in zip(
        ("bending stiffness", "air drag"),
        (found - hidden).T,
        np.log([RANGES[BEND][1] / RANGES[BEND][0], RANGES[DRAG][1] / RANGES[DRAG][0]]),
    ):
        factor = np.exp(np.median(np.abs(error)))
        # Who guesses the middle of the range is wrong by a quarter of its width at the median.
        blind = np.exp(width / 4)
        print(f"{name}: recovered within a factor of {factor:.2f} at the median, {np.exp(np.abs(error).max()):.2f}"
              f" at worst; a guess without looking: {blind:.2f}")


if __name__ == "__main__":
    main()
