"""Laws that hold on every map: hypothesis draws small ones."""

from __future__ import annotations

from typing import Tuple

import numpy as np
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import waybreaker as wb

Cells = NDArray[np.bool_]

settings.register_profile(
    "repeatable", derandomize=True, deadline=None, max_examples=60, suppress_health_check=list(HealthCheck)
)
settings.load_profile("repeatable")


@st.composite
def missions(draw: st.DrawFn) -> Tuple[Cells, wb.Mission]:
    """A random map and a mission across it, both ends of which are free."""
    height, width = draw(st.integers(4, 16)), draw(st.integers(4, 16))
    blocked = draw(st.integers(0, 60))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    cells = random.random((height, width)) * 100 < blocked
    free = np.argwhere(~cells)
    assume(len(free) >= 2)
    (y, x), (goal_y, goal_x) = random.choice(free, 2, replace=False)
    mission = wb.Mission.ground_and_air(
        (int(x), int(y)),
        (int(goal_x), int(goal_y)),
        removals=draw(st.integers(0, 3)),
        breach_time=draw(st.sampled_from([0, 1.5])),
    )
    return cells, mission


@given(missions())
def test_plans_are_valid_and_no_worse_than_no_removal(drawn: Tuple[Cells, wb.Mission]) -> None:
    cells, mission = drawn
    map = wb.Map.from_array(cells)
    plan = wb.plan(map, mission)
    assert wb.check(map, plan) == []
    if plan.before.makespan is not None:
        assert plan.makespan is not None and plan.makespan <= plan.before.makespan * (1 + 1e-9)
    if plan.makespan is not None and plan.bound is not None:
        assert plan.bound <= plan.makespan * (1 + 1e-9)


@given(missions())
def test_labels_of_a_map_are_the_same_map(drawn: Tuple[Cells, wb.Mission]) -> None:
    cells, mission = drawn
    map = wb.Map.from_array(cells)
    again = wb.Map.from_labels(map.labels)
    assert np.array_equal(map.labels, again.labels) and map.obstacles == again.obstacles
    assert wb.plan(again, mission).makespan == wb.plan(map, mission).makespan


@given(missions())
def test_turned_maps_have_plans_as_good(drawn: Tuple[Cells, wb.Mission]) -> None:
    cells, mission = drawn
    vehicle = mission.agents[0]
    assert isinstance(vehicle, wb.Vehicle)
    start, goal = vehicle.start, vehicle.goal
    turned = wb.Mission.ground_and_air(
        (start[1], start[0]),
        (goal[1], goal[0]),
        removals=mission.rules.removals or 0,
        breach_time=mission.rules.breach_time or 0,
    )
    before = wb.plan(wb.Map.from_array(cells), mission).before.makespan
    after = wb.plan(wb.Map.from_array(cells.T), turned).before.makespan
    assert (before is None) == (after is None)
    assert before is None or abs(before - (after or 0)) <= 1e-9 * before


@given(missions())
def test_equal_input_gives_equal_bytes(drawn: Tuple[Cells, wb.Mission]) -> None:
    cells, mission = drawn
    first = wb.plan(wb.Map.from_array(cells), mission)
    assert wb.plan(wb.Map.from_array(cells), mission).to_json() == first.to_json()
