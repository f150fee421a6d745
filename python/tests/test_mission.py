"""Missions as data equal mission documents."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

import waybreaker as wb

EVERYTHING = wb.Mission(
    [
        wb.Vehicle((1, 2), (3, 4), id="a", speed=1.5, radius=0.75, corners="none", ready_at=3, approach=[[1, 3, 2], [1, 2, 3]]),
        wb.Vehicle((9, 2), (3, 9), id="b", corners="cut"),
        wb.Aircraft((5, 5), (6, 6), id="heli", speed=4, breaches=2),
        wb.Aircraft((5.5, 5.25), (6, 6), id="late", ready_at=9),
    ],
    wb.Rules(
        removals=2,
        budget=3,
        protect=[1, "amenity=school"],
        force=[2],
        opened=[{"obstacle": 3, "at": 4.5}],
        separation=1,
        at_goal="leave",
    ),
    wb.Method(select="exact", weight=1.5, heuristic="octile", moves=8, explain=True),
    wb.Limits(seconds=2, expansions=1000, gap=0.01),
    time_unit="s",
)


def test_document() -> None:
    document = EVERYTHING.to_dict()
    assert document["format"] == "waybreaker-mission/1"
    assert document["agents"][2] == {
        "id": "heli",
        "kind": "air",
        "start": [5, 5],
        "goal": [6, 6],
        "speed": 4,
        "breaches": 2,
    }
    assert document["rules"]["protect"] == [1, "amenity=school"]
    assert document["time_unit"] == "s"


def test_round_trip() -> None:
    assert wb.Mission.from_dict(EVERYTHING.to_dict()) == EVERYTHING
    assert wb.Mission.from_dict(json.loads(json.dumps(EVERYTHING.to_dict()))) == EVERYTHING


def test_what_is_not_said_is_left_out() -> None:
    assert wb.Mission.ground_and_air((1, 2), (3, 4)).to_dict() == {
        "format": "waybreaker-mission/1",
        "agents": [
            {"id": "ground", "kind": "ground", "start": [1, 2], "goal": [3, 4], "speed": 1.0},
            {"id": "air", "kind": "air", "start": [1, 2], "goal": [3, 4], "speed": 1.0},
        ],
    }


def test_plan_states_the_mission(wall_map: wb.Map, through_the_wall: wb.Mission) -> None:
    mission = wb.plan(wall_map, through_the_wall).mission
    assert mission.agents[0] == wb.Vehicle((4, 4), (36, 4), radius=0.5, corners="none")
    assert (mission.rules.removals, mission.method.select) == (1, "exact")
    assert wb.plan(wall_map, mission).to_json() == wb.plan(wall_map, through_the_wall).to_json()


def test_document_as_dict_is_the_same(wall_map: wb.Map, through_the_wall: wb.Mission) -> None:
    document = through_the_wall.to_dict()
    assert wb.plan(wall_map, document).to_json() == wb.plan(wall_map, through_the_wall).to_json()
    assert document == through_the_wall.to_dict()  # it is not changed


def test_numpy_numbers(wall_map: wb.Map, through_the_wall: wb.Mission) -> None:
    start, goal = np.array([[4, 4], [36, 4]])
    mission = wb.Mission.ground_and_air((start[0], start[1]), (goal[0], goal[1]), removals=np.int64(1))
    assert wb.plan(wall_map, mission).to_json() == wb.plan(wall_map, through_the_wall).to_json()
    document = through_the_wall.to_dict()
    document["agents"][0]["start"] = start
    assert wb.plan(wall_map, document).to_json() == wb.plan(wall_map, through_the_wall).to_json()


def test_paper() -> None:
    assert wb.Method.paper().flight == "optimal"
    assert wb.Method.paper(3).flight == "nearest"


def test_limits_of_the_call_replace_those_of_the_mission(wall_map: wb.Map, through_the_wall: wb.Mission) -> None:
    document = {**through_the_wall.to_dict(), "limits": {"expansions": 1}}
    assert wb.plan(wall_map, document).limit_reached
    assert wb.plan(wall_map, document, expansions=10**6, seconds=math.inf).solved
    assert wb.plan(wall_map, through_the_wall, expansions=1).limit_reached


def test_unknown_member() -> None:
    with pytest.raises(ValueError, match="Rules has no member 'removal'; it has .*removals"):
        wb.Mission.from_dict({"agents": [], "rules": {"removal": 1}})


@pytest.mark.parametrize(
    "change, error",
    [
        ({"format": "x"}, "format"),
        ({"agents": []}, "agent"),
        ({"rules": {"removal": 1}}, "removal"),
        ({"rules": {"removals": -1}}, "removals"),
        ({"rules": {"protect": [99]}}, "99"),
        ({"rules": {"protect": ["amenity=school"]}}, "amenity=school"),
        ({"limits": {"seconds": 0}}, "seconds"),
        ({"method": {"select": "best"}}, "select"),
        ({"overlays": [{"file": "flood.geojson", "as": "water"}]}, "waybreaker map overlay"),
    ],
)
def test_bad_documents(change: dict[str, Any], error: str, wall_map: wb.Map, through_the_wall: wb.Mission) -> None:
    with pytest.raises(wb.InputError, match=error):
        wb.plan(wall_map, {**through_the_wall.to_dict(), **change})


def test_places(wall_map: wb.Map) -> None:
    with pytest.raises(wb.InputError, match="start"):
        wb.plan(wall_map, wb.Mission.ground_and_air((20, 4), (36, 4)))
    with pytest.raises(wb.InputError, match="goal"):
        wb.plan(wall_map, wb.Mission.ground_and_air((4, 4), (40, 4)))


def test_what_json_cannot_say(wall_map: wb.Map, through_the_wall: wb.Mission) -> None:
    with pytest.raises(ValueError):
        wb.plan(wall_map, {**through_the_wall.to_dict(), "rules": {"breach_time": math.nan}})
    with pytest.raises(TypeError, match="holds no object"):
        wb.plan(wall_map, {**through_the_wall.to_dict(), "rules": {"removals": object()}})
    with pytest.raises(wb.InputError, match="threads"):
        wb.plan(wall_map, through_the_wall, threads=-1)
