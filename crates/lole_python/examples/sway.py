"""Gather ratio, bending stiffness and tempo against folds and sway: a sweep, plotted.

    python sway.py [--sweep sway.toml] [--out swept] [--picture sway.png]

What is known from measured skirts, and is printed with a yes or no: stiffer cloth hangs in fewer folds, and more
cloth in the same girth in more.
"""

import argparse
import csv
import io
import os
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from statistics import mean

import lole

RATIO, BEND, TEMPO = "skirt.gather_ratio", "fabric.bend_warp_un_m", "motion.tempo_bpm"


def perform(path: Path, out: Path) -> list[dict[str, float]]:
    """The rows of the sweep; what the folder holds is not run again."""
    sweep = lole.Sweep(path)
    missing = sweep.missing(out)
    # A run releases Python's lock, so that threads are enough for all cores.
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        tasks = [pool.submit(sweep.perform, number, out) for number in missing]
        for done, _ in enumerate((task.result() for task in tasks), 1):
            print(f"\r{done}/{len(missing)}", end="", flush=True)
    rows = list(csv.DictReader(io.StringIO(sweep.write_table(out))))
    failed = [row for row in rows if row["error"]]
    print(f"\r{len(rows)} runs, {len(failed)} failed")
    names = (RATIO, BEND, TEMPO, "rest_fold_count", "fold_count", "fold_depth_cm", "sway_cm")
    return [{name: float(row[name]) for name in names} for row in rows if not row["error"]]


def means(rows: list[dict[str, float]], by: tuple[str, ...], value: str) -> dict[tuple[float, ...], float]:
    """Mean of a column for every combination of others."""
    groups: dict[tuple[float, ...], list[float]] = defaultdict(list)
    for row in rows:
        groups[tuple(row[name] for name in by)].append(row[value])
    return {key: mean(values) for key, values in sorted(groups.items())}


def judge(rows: list[dict[str, float]]) -> None:
    """Says whether the trends of measured skirts come out."""
    for name, by, falls in (
        ("folds fall as bending stiffness grows", BEND, True),
        ("folds grow with the gather ratio", RATIO, False),
    ):
        found = list(means(rows, (by,), "fold_count").values())
        steps = list(zip(found, found[1:]))
        holds = all((b < a) if falls else (a < b) for a, b in steps)
        print(f"{name}: {'yes' if holds else 'NO'} ({', '.join(f'{it:.1f}' for it in found)})")
    for (tempo,), sway in means(rows, (TEMPO,), "sway_cm").items():
        print(f"sway at {tempo:.0f} counts a minute: {sway:.2f} cm")


def plot(rows: list[dict[str, float]], picture: Path) -> None:
    """Folds and sway by stiffness, a line for every gather ratio."""
    import matplotlib

    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    tempos = sorted({row[TEMPO] for row in rows})
    for ratio, color in zip(sorted({row[RATIO] for row in rows}), ("#2a6f97", "#b5651d", "#7b2d5b", "#4c7a34")):
        here = [row for row in rows if row[RATIO] == ratio]
        folds = means(here, (BEND,), "fold_count")
        axes[0].plot([key[0] for key in folds], list(folds.values()), "o-", color=color, label=f"gather ratio {ratio:g}")
        for tempo, style in zip(tempos, ("o-", "s--")):
            sway = means([row for row in here if row[TEMPO] == tempo], (BEND,), "sway_cm")
            label = f"{ratio:g}, {tempo:.0f}/min"
            axes[1].plot([key[0] for key in sway], list(sway.values()), style, color=color, label=label)
    axes[0].set_ylabel("folds of the hem, mean of the dance")
    axes[1].set_ylabel("amplitude of the hem's swing [cm]")
    for axis in axes:
        axis.set_xscale("log")
        axis.set_xlabel("bending rigidity [µN·m]")
        axis.set_ylim(bottom=0)
        axis.legend(fontsize=8)
    figure.savefig(picture, dpi=120)
    print(f"{picture} written")


def main() -> None:
    here = Path(__file__).parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--sweep", type=Path, default=here / "sway.toml")
    parser.add_argument("--out", type=Path, default=Path("swept"))
    parser.add_argument("--picture", type=Path, default=Path("sway.png"))
    arguments = parser.parse_args()
    rows = perform(arguments.sweep, arguments.out)
    judge(rows)
    plot(rows, arguments.picture)


if __name__ == "__main__":
    main()
