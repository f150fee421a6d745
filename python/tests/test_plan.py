"""What plans say, how they are shown and checked."""

from __future__ import annotations

import copy
import sys
import xml.etree.ElementTree as ET
from typing import Any, cast

import matplotlib
import numpy as np
import pytest
from conftest import DATA

import waybreaker as wb

matplotlib.use("agg")

modules = cast("dict[str, Any]", sys.modules)  # None stands for one that is not installed


@pytest.fixture
def plan(wall_map: wb.Map, through_the_wall: wb.Mission) -> wb.Plan:
    return wb.plan(wall_map, through_the_wall)


def test_attributes(plan: wb.Plan) -> None:
    assert plan.status == "solved" and plan.solved and not plan.limit_reached
    assert plan.makespan == plan.after.makespan == 32.0
    assert plan.before.makespan is not None and plan.before.makespan > 40
    assert plan.bound is not None and plan.bound <= plan.makespan
    assert plan.gap is not None and 0 <= plan.gap < 0.01
    assert plan.after.lengths["ground"] == 32.0
    assert plan.seconds > 0
    (breach,) = plan.removed
    assert (breach.obstacle, breach.cells, breach.by, breach.area_m2) == (1, 18, "air", None)
    assert breach.entered_at is not None and breach.cleared_at <= breach.entered_at


def test_orders(plan: wb.Plan) -> None:
    (order,) = plan.orders
    assert (order.why, order.obstacle) == ("opening", plan.removed[0].obstacle)
    assert (order.before.agent, order.before.fraction, order.after.agent) == ("air", 0.0, "ground")
    assert plan["air"].times[order.before.point] == plan.removed[0].cleared_at
    assert order.slack >= 0


def test_paths(plan: wb.Plan) -> None:
    rover = plan["ground"]
    assert rover is plan.agents[0] and plan["air"].kind == "air"
    assert rover.path.shape == (len(rover.times), 2) and rover.path.dtype == np.float64
    assert rover.path[0].tolist() == [4, 4] and rover.path[-1].tolist() == [36, 4]
    assert rover.arrives_at == 32.0
    assert rover.at(16.0).tolist() == [20.0, 4.0]
    assert rover.at(99.0).tolist() == [36.0, 4.0]
    for values in (rover.path, rover.times):
        with pytest.raises(ValueError):
            values[0] = 1
    with pytest.raises(KeyError):
        plan["nobody"]


def test_no_plan() -> None:
    cells = np.zeros((9, 9), dtype=bool)
    cells[:, 4] = True
    plan = wb.plan(wb.Map.from_array(cells), wb.Mission.ground_and_air((1, 1), (7, 7), removals=0))
    assert plan.status == "no_plan" and not plan.solved
    assert plan.makespan is None and plan.flowtime is None
    assert plan.agents == () and plan.removed == ()
    assert repr(plan) == "<waybreaker.Plan: no_plan>"
    assert plan.to_svg() and plan.plot()


def test_timing(plan: wb.Plan) -> None:
    assert "seconds" in plan.to_dict(timing=True)
    assert b"seconds" not in plan.to_json()


def test_picture(plan: wb.Plan) -> None:
    assert ET.fromstring(plan._repr_svg_()).tag == "{http://www.w3.org/2000/svg}svg"
    assert plan._repr_html_().startswith("<svg")


def test_plot(plan: wb.Plan) -> None:
    from matplotlib import pyplot

    _, ax = pyplot.subplots()
    assert plan.plot(ax) is ax
    assert [line.get_label() for line in ax.lines] == ["ground", "air", "breach"]
    assert np.array_equal(ax.lines[0].get_xydata(), plan["ground"].path)
    pyplot.close("all")


def test_plot_without_matplotlib(plan: wb.Plan, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(modules, "matplotlib", None)
    with pytest.raises(ImportError, match="python3-matplotlib"):
        plan.plot()


def test_geodataframe() -> None:
    map = wb.Map.open(DATA / "monaco.tif")
    plan = wb.plan(map, wb.Mission.ground_and_air((301, 63), (375, 345), removals=2))
    frame = plan.to_geodataframe()
    assert frame.crs.to_epsg() == 4326
    roles = frame["role"].value_counts()
    assert (roles["path"], roles["breach"], roles["removed"]) == (2, len(plan.removed), len(plan.removed))
    west, south, east, north = frame.total_bounds
    assert 7.3 < west < east < 7.5 and 43.7 < south < north < 43.8
    metres = frame.to_crs(map.place.crs if map.place else "")
    length = metres[(metres["role"] == "path") & (metres["kind"] == "ground")].length.sum()
    assert length == pytest.approx((plan.after.lengths["ground"] or 0) * (map.cell_size or 0), rel=1e-4)


def test_geodataframe_without_geopandas(plan: wb.Plan, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(modules, "geopandas", None)
    with pytest.raises(ImportError, match="python3-geopandas"):
        plan.to_geodataframe()


def test_geojson_without_a_place(plan: wb.Plan) -> None:
    with pytest.raises(wb.InputError, match="where it lies"):
        plan.to_geojson()


def test_check(plan: wb.Plan) -> None:
    assert wb.check(plan.map, plan) == []
    assert wb.check(plan.map, plan.to_dict()) == []
    assert wb.check(plan.map, plan.to_json()) == []
    assert wb.check(plan.map, plan.to_json().decode()) == []


def test_check_finds_a_cut_corner(plan: wb.Plan) -> None:
    document = copy.deepcopy(plan.to_dict())
    document["removed"] = []
    rules = {violation.rule for violation in wb.check(plan.map, document)}
    assert "collision" in rules


def test_check_finds_another_map(plan: wb.Plan) -> None:
    cells = plan.map.blocked
    cells[19, 0] = True
    other = wb.Map.from_array(cells)
    (violation,) = wb.check(other, plan)
    assert violation.rule == "map"
    assert wb.check(other, plan, ignore_digest=True) == []


def test_check_of_no_plan(wall_map: wb.Map) -> None:
    with pytest.raises(wb.InputError):
        wb.check(wall_map, "{}")


def test_front(wall_map: wb.Map) -> None:
    plans = wb.front(wall_map, wb.Mission.ground_and_air((4, 4), (36, 4), removals=5))
    assert [len(plan.removed) for plan in plans] == [0, 1]
    assert plans[0].makespan == plans[1].before.makespan
    for plan in plans:
        assert wb.check(wall_map, plan) == []


def test_team(wall_map: wb.Map) -> None:
    mission = wb.Mission(
        [
            wb.Vehicle((4, 4), (36, 4), id="a"),
            wb.Vehicle((36, 4), (4, 4), id="b"),
            wb.Aircraft((4, 10), (4, 10), id="drone", speed=2),
        ],
        wb.Rules(removals=1),
    )
    plan = wb.plan(wall_map, mission, threads=2)
    assert plan.solved and [agent.id for agent in plan.agents] == ["a", "b", "drone"]
    assert plan.removed[0].by == "drone"
    assert set(plan.before.lengths) == {"a", "b", "drone"}
    assert wb.check(wall_map, plan) == []
    apart = [np.hypot(*(plan["a"].at(t) - plan["b"].at(t))) for t in np.linspace(0, 40, 401)]
    assert min(apart) >= 1 - 1e-6


def test_repr(plan: wb.Plan) -> None:
    assert repr(plan).startswith("<waybreaker.Plan: makespan 32 instead of 4")
    assert "1 removed, gap" in repr(plan)
