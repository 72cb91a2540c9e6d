"""A sweep on a local cluster of Ray that loses a worker and its driver."""

import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

import lole

ray: Any = pytest.importorskip("ray", reason="ray is not installed: pip install ray")


def records(out: Path) -> int:
    return len(list((out / "runs").glob("*/*.json")))


def wait_for(out: Path, count: int, driver: "subprocess.Popen[bytes]") -> None:
    until = time.monotonic() + 300
    while records(out) < count:
        assert driver.poll() is None, "the driver has ended"
        assert time.monotonic() < until, "nothing happens"
        time.sleep(0.05)


def test_a_lost_worker_a_new_one_and_a_new_driver_end_in_the_same_table(sweep_file: Path, tmp_path: Path) -> None:
    from ray.cluster_utils import Cluster

    text = sweep_file.read_text().replace("count = 8", "count = 24")
    sweep_file.write_text(text)
    sweep = lole.Sweep(sweep_file)
    alone, out = tmp_path / "alone", tmp_path / "out"
    for number in range(len(sweep)):
        sweep.perform(number, alone)
    sweep.write_table(alone)

    memory = {"object_store_memory": 80 << 20}
    cluster: Any = Cluster(initialize_head=True, head_node_args={"num_cpus": 0, "include_dashboard": False, **memory})
    try:
        lost = cluster.add_node(num_cpus=1, **memory)
        cluster.add_node(num_cpus=1, **memory)
        command = [sys.executable, "-m", "lole.cluster", str(sweep_file), "--out", str(out)]
        command += ["--address", cluster.address]
        driver = subprocess.Popen(command)
        wait_for(out, 3, driver)
        cluster.remove_node(lost, allow_graceful=False)
        cluster.add_node(num_cpus=1, **memory)
        wait_for(out, 8, driver)
        driver.send_signal(signal.SIGKILL)
        driver.wait()
        done = records(out)
        assert done < len(sweep), "the driver was killed too late to prove anything"
        assert not (out / "runs.csv").exists()
        driver = subprocess.Popen(command)
        assert driver.wait(timeout=300) == 0
    finally:
        cluster.shutdown()
    for name in ("runs.csv", "runs.parquet"):
        assert (out / name).read_bytes() == (alone / name).read_bytes()
