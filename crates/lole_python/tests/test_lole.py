"""The module as its users meet it. Laws, not remembered numbers."""

import csv
import math
import random
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lole


def test_a_design_is_the_same_as_dict_as_file_and_as_text(tmp_path: Path, small: dict[str, Any]) -> None:
    design = lole.Design(small)
    path = tmp_path / "d.lole"
    path.write_text(design.text, encoding="utf-8")
    assert lole.Design(path) == design == lole.Design(str(path)) == lole.Design(design.to_dict())
    assert design.replaced({"skirt.column_count": 128}).to_dict()["skirt"]["column_count"] == 128
    assert design.to_dict()["skirt"]["column_count"] == 96, "the first is as it was"
    assert lole.Design(None) == lole.Design({})


@pytest.mark.parametrize(
    ("source", "word"),
    [
        ({"skirt": {"gather_ratoi": 3}}, "did you mean gather_ratio"),
        ({"skirt": {"gather_ratio": math.nan}}, "out of range"),
        ({"skirt": {"gather_ratio": math.inf}}, "out of range"),
        ({"skirt": {"gather_ratio": 1e300}}, "out of range"),
        ({"skirt": {"gather_ratio": None}}, "no value of a design"),
        ({"skirt": {"column_count": True}}, "true"),
        ({"nothing": {}}, "no such"),
        ({"lole": 99}, "newer Lole"),
        ({"motion": {"file": "nowhere.bvh"}}, "nowhere.bvh"),
        ("nowhere.lole", "cannot be read"),
    ],
)
def test_what_is_wrong_is_the_sentence_of_the_command(source: Any, word: str) -> None:
    with pytest.raises(lole.LoleError, match=word) as caught:
        lole.Design(source)
    assert "\n" not in str(caught.value)
    assert caught.value.japanese and not caught.value.japanese.isascii()
    assert isinstance(caught.value, ValueError)


def test_random_designs_in_their_ranges_are_drafted() -> None:
    chance = random.Random(26)
    for _ in range(20):
        ratio = chance.uniform(1.5, 5)
        design = lole.Design({"dancer": {"hip_cm": chance.uniform(85, 105)}, "skirt": {"gather_ratio": ratio}})
        draft = design.draft()
        assert draft is not None
        assert draft["flat_length_cm"] > 60 * ratio
        # Cloth is bought by the decimetre, and a gathered skirt may fall two centimetres short of its draft.
        assert draft["cloth_to_buy_m"] * 100 >= draft["cut_length_cm"] - 2.0 or draft["warnings"]
    assert lole.Design({"skirt": {"worn": "no"}, "garment": [{"kind": "ti-leaf-skirt"}]}).draft() is None


def test_the_bill_follows_the_price_of_the_cloth() -> None:
    total = [lole.Design({"fabric": {"price_per_m": price}}).cost()["total"] for price in (0.0, 1000.0, 2000.0)]
    assert total[1] > total[0]
    assert total[2] - total[1] == pytest.approx(total[1] - total[0])


def test_a_dancer_is_closed_and_as_tall_as_she_was_asked_to_be() -> None:
    dancer = lole.Dancer(lole.Design({"dancer": {"stature_cm": 160}}))
    positions, triangles = dancer.positions(), dancer.triangles()
    assert positions.dtype == np.float32 and positions.shape[1] == 3
    assert triangles.dtype == np.uint32 and triangles.max() < len(positions)
    assert dancer.measures["stature_cm"] == pytest.approx(160, abs=1)
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    assert (counts >= 2).mean() > 0.95


def test_stepping_and_running_on_any_threads_give_the_same_bits(small: dict[str, Any]) -> None:
    design = lole.Design(small)
    stepped, ran = lole.Performance(design), lole.Performance(design, threads=2)
    stepped.settle()
    assert stepped.time == 0
    stepped.step(10)
    seen: list[float] = []
    pictures = ran.run(10 / 60, every=5, callback=lambda performance: seen.append(performance.time))
    assert pictures.shape == (2, *stepped.positions().shape) and pictures.dtype == np.float32
    assert len(seen) == 10 and seen == sorted(seen)
    assert stepped.state_hash == ran.state_hash
    assert np.array_equal(pictures[-1], stepped.positions())
    mine = np.empty_like(stepped.positions())
    stepped.positions_into(mine)
    assert np.array_equal(mine, stepped.positions())
    with pytest.raises(lole.LoleError, match="shape"):
        stepped.positions_into(np.empty((3, 3), dtype=np.float32))
    begin, end = next(iter(dict(stepped.garments).values()))
    assert 0 <= begin < end <= len(mine)
    assert np.isfinite(stepped.body_positions()).all()
    assert stepped.measure()["strain_mean_pct"] >= 0


def test_a_callback_ends_the_dance_and_its_exceptions_come_through(small: dict[str, Any]) -> None:
    performance = lole.Performance(lole.Design(small))
    assert performance.run(1, every=1, callback=lambda _: False).shape[0] == 1

    def fail(_: lole.Performance) -> None:
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        performance.run(1, callback=fail)
    performance.step()
    for seconds in (-1, math.nan, math.inf, 601):
        with pytest.raises(lole.LoleError, match="seconds"):
            performance.run(seconds)


def test_other_threads_go_on_while_she_dances(small: dict[str, Any]) -> None:
    performance = lole.Performance(lole.Design(small))
    ticks, is_over = 0, False

    def tick() -> None:
        nonlocal ticks
        while not is_over:
            ticks += 1
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    performance.settle()
    is_over = True
    thread.join()
    assert ticks > 10


def test_fabrics_and_validation_are_tables() -> None:
    shelf = lole.fabrics()
    assert all(row["areal_density_kg_per_m2"] > 0 and len(row["bend_n_m"]) == 2 for row in shelf)
    rows = lole.validate("pendulum")
    assert rows and all(row["pass"] for row in rows)
    with pytest.raises(lole.LoleError, match="choose one of"):
        lole.validate("nothing")


def test_a_bench_dances_the_same_dance(small: dict[str, Any]) -> None:
    design = lole.Design(small)
    row = lole.bench(design, frames=10, threads=2)
    performance = lole.Performance(design)
    performance.settle()
    performance.step(10)
    assert row["state_hash"] == performance.state_hash
    assert 0 < row["frame_wall_ms"]["median"] <= row["frame_wall_ms"]["p99"]
    with pytest.raises(lole.LoleError, match="frames"):
        lole.bench(design, frames=0)


def test_a_sweep_in_any_order_makes_one_table(sweep_file: Path, tmp_path: Path) -> None:
    sweep = lole.Sweep(sweep_file)
    assert len(sweep) == 8 and sweep.parameters[0] == "skirt.gather_ratio"
    first, second = tmp_path / "first", tmp_path / "second"
    for number in range(8):
        sweep.perform(number, first)
    with pytest.raises(lole.LoleError, match="8 of 8 runs are missing"):
        sweep.write_table(second)
    for number in reversed(range(8)):
        record = sweep.perform(number, second / str(number % 2))
        assert record["error"] is None, record["error"]
    assert sweep.gather(second, [second / "0", second / "1"]) == 8
    assert sweep.write_table(first) == sweep.write_table(second)
    assert (first / "runs.parquet").read_bytes() == (second / "runs.parquet").read_bytes()
    assert sweep.missing(first) == [] and sweep.is_done(3, first)
    with pytest.raises(lole.LoleError, match="from 0 to 7"):
        sweep.run(8)
    rows = list(csv.DictReader((first / "runs.csv").open(newline="")))
    parquet = pytest.importorskip("pyarrow.parquet", reason="pyarrow is not installed")
    table = parquet.read_table(first / "runs.parquet").to_pylist()
    assert [row["id"] for row in table] == [row["id"] for row in rows]
    for ours, theirs in zip(rows, table, strict=True):
        for name, value in theirs.items():
            text = ours[name]
            assert text == "" if value is None else value == type(value)(text), name
