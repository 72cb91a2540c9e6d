"""A sweep on a cluster of Ray, through the wheel: ``python -m lole.cluster SWEEP.toml --out DIR``.

The manifest is the file of the sweep, and a run is its number in it.  Workers keep their records in ``out``, a
folder that all of them see, before they answer; a worker that dies loses the run that it was at, which another
one takes, and a driver that dies is started again and finds what has ended.  Nothing but the sweep decides what
is in the table, so it is the same to the bit.
"""

from __future__ import annotations

import argparse
import functools
import sys
from pathlib import Path
from typing import Any

from ._lole import Sweep


@functools.lru_cache(maxsize=4)
def _sweep(path: str) -> Sweep:
    return Sweep(path)


def _one(path: str, number: int, out: str) -> int:
    """One run, where a worker is told to: the sweep is read once by each."""
    _sweep(path).perform(number, out)
    return number


def perform_all(path: str, out: str, address: str | None = None) -> int:
    """Performs all runs that ``out`` does not hold on the cluster at ``address`` (one of this machine without
    it), and writes the table; how many were performed."""
    import ray  # pyright: ignore[reportMissingTypeStubs]

    cluster: Any = ray
    sweep = _sweep(path)
    missing = sweep.missing(out)
    if missing:
        if not cluster.is_initialized():
            cluster.init(address=address, log_to_driver=False, logging_level="ERROR")
        # A worker may die as often as it likes; an error of the program is an error.
        one = cluster.remote(num_cpus=1, max_retries=-1)(_one)
        waiting = [one.remote(path, number, out) for number in missing]
        while waiting:
            done, waiting = cluster.wait(waiting)
            cluster.get(done)
            print(f"{len(missing) - len(waiting)}/{len(missing)}", file=sys.stderr, flush=True)
    sweep.write_table(out)
    return len(missing)


def main() -> None:
    """The command line."""
    parser = argparse.ArgumentParser(description="Perform a sweep on a cluster of Ray.")
    parser.add_argument("sweep", type=Path)
    parser.add_argument("--out", type=Path, default=Path("lole-batch"))
    parser.add_argument("--address", help="of the cluster, such as 10.0.0.1:6379; one is started here without it")
    arguments = parser.parse_args()
    # Workers have working folders of their own.
    path, out = str(arguments.sweep.resolve()), str(arguments.out.resolve())
    count = perform_all(path, out, arguments.address)
    print(f"{count} runs performed; the table is in {out}")


if __name__ == "__main__":
    # By its name: workers import what they are sent, and there is no such thing in their own main module.
    from lole import cluster as by_name

    by_name.main()
