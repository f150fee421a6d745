"""A plan is that of the command, to the byte, whatever the map and the mission."""

from __future__ import annotations

import json
import math
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import DATA, PlanFile
from numpy.typing import NDArray

import waybreaker as wb

ENDLESS = math.inf
ADLERSHOF = DATA / "berlin-adlershof.tif", (130, 104), (466, 105)
MONACO = DATA / "monaco.tif", (301, 63), (375, 345)
ANDORRA = DATA / "andorra.tif", (251, 185), (395, 395)
KREMS = DATA / "krems-flooded.tif", (182, 167), (233, 423)
MANHATTAN = DATA / "manhattan.tif", (354, 45), (16, 237)

MISSIONS: dict[str, tuple[Any, dict[str, Any], dict[str, Any]]] = {
    "usual": (ADLERSHOF, {}, {}),
    "explained": (ADLERSHOF, {"removals": 2}, {"explain": True}),
    "sections": (MONACO, {"removals": 2}, {}),
    "flood": (KREMS, {}, {}),
    "flowtime": (MANHATTAN, {"removals": 1, "objective": "flowtime", "breach_time": 5}, {}),
    "least demolition": (ANDORRA, {"removals": 2, "minimise_demolition": 0.005}, {}),
    "square metres": (ANDORRA, {"removals": 3, "budget_m2": 400}, {}),
    "protected": (ADLERSHOF, {"protect": [607, "name=Atelier*"]}, {}),
    "paper": (ADLERSHOF, {"removals": 1, "timing": "ignore"}, {"select": "hits", "planner": "theta", "bound": True}),
    "greedy": (ADLERSHOF, {"removals": 2}, {"select": "greedy", "flight": "nearest"}),
}


@pytest.mark.parametrize("name", MISSIONS)
def test_one_vehicle(name: str, plan_file: PlanFile) -> None:
    (path, start, goal), rules, method = MISSIONS[name]
    mission = wb.Mission(
        [wb.Vehicle(start, goal), wb.Aircraft(start, goal, speed=2)], wb.Rules(**rules), wb.Method(**method)
    )
    plan = wb.plan(wb.Map.open(path), mission, seconds=ENDLESS)
    assert plan.to_json() == plan_file(path, mission.to_dict())
    assert plan.to_dict() == json.loads(plan.to_json())


TEAM = [
    wb.Vehicle((130, 104), (466, 105), id="a"),
    wb.Vehicle((466, 105), (130, 104), id="b", ready_at=20),
    wb.Vehicle((317, 124), (175, 102), id="c", speed=0.5),
]


@pytest.mark.parametrize("aircraft", [0, 1, 2])
def test_team(aircraft: int, plan_file: PlanFile) -> None:
    path = ADLERSHOF[0]
    flying = [wb.Aircraft((130, 104), (130, 104), id=f"air {i}", speed=3, breaches=2) for i in range(aircraft)]
    mission = wb.Mission([*TEAM, *flying], wb.Rules(removals=2, separation=0.5, at_goal="leave"))
    plan = wb.plan(wb.Map.open(path), mission, seconds=ENDLESS)
    assert plan.to_json() == plan_file(path, mission.to_dict())
    assert [agent.id for agent in plan.agents] == [agent.id for agent in mission.agents]


def test_movingai_map_and_array(wall: NDArray[np.bool_], tmp_path: Path, plan_file: PlanFile) -> None:
    path = tmp_path / "wall.map"
    path.write_bytes(wb.Map.from_array(wall).to_movingai())
    mission = wb.Mission.ground_and_air((4, 4), (36, 4), removals=1)
    expected = plan_file(path, mission.to_dict())
    for map in (
        wb.Map.open(path),
        wb.Map.from_movingai(path.read_text(), "wall.map"),
        wb.Map.from_array(wall, "wall.map"),
    ):
        assert wb.plan(map, mission, seconds=ENDLESS).to_json() == expected


def test_diagonal_neighbours_are_one_obstacle(tmp_path: Path, plan_file: PlanFile) -> None:
    cells = np.zeros((30, 30), dtype=bool)
    np.fill_diagonal(cells[2:, :], True)
    path = tmp_path / "stairs.map"
    path.write_bytes(wb.Map.from_array(cells).to_movingai())
    mission = wb.Mission.ground_and_air((2, 27), (20, 5), removals=1)
    for connectivity in (4, 8):
        plan = wb.plan(wb.Map.open(path, connectivity=connectivity), mission, seconds=ENDLESS)
        assert plan.to_json() == plan_file(path, mission.to_dict(), "--connectivity", str(connectivity))


def test_paper_map(plan_file: PlanFile) -> None:
    path = DATA / "paper-maps/berlin-adlershof-01.tif"
    mission = wb.Mission.ground_and_air((292, 113), (66, 481), removals=1)
    plan = wb.plan(wb.Map.open(path), mission, seconds=ENDLESS)
    assert plan.to_json() == plan_file(path, mission.to_dict())


def test_front(tmp_path: Path, plan_file: PlanFile) -> None:
    cells = np.zeros((24, 60), dtype=bool)
    cells[:20, 15] = cells[6:, 30] = cells[:22, 45] = True
    path = tmp_path / "walls.map"
    path.write_bytes(wb.Map.from_array(cells).to_movingai())
    asked = wb.Mission.ground_and_air((2, 12), (57, 12), removals=9)
    plans = wb.front(wb.Map.open(path), asked, seconds=ENDLESS)
    assert plans[-1].to_json() == plan_file(path, asked.to_dict(), "--removals", "auto")
    assert [len(plan.removed) for plan in plans] == [0, 1, 2, 3]
    reached = [plan.makespan or math.inf for plan in plans]
    assert reached == sorted(reached, reverse=True)


@pytest.mark.parametrize("mission", [ADLERSHOF, MONACO, KREMS])
def test_geojson_and_picture(mission: Any, plan_file: PlanFile, tmp_path: Path) -> None:
    path, start, goal = mission
    asked = wb.Mission.ground_and_air(start, goal)
    geojson, svg = tmp_path / "plan.geojson", tmp_path / "plan.svg"
    plan_file(path, asked.to_dict(), "--geojson", str(geojson), "--svg", str(svg))
    plan = wb.plan(wb.Map.open(path), asked, seconds=ENDLESS)
    assert plan.to_geojson() == json.loads(geojson.read_text())
    assert plan.to_svg() == svg.read_text()


def test_checked_by_the_command(command: Path, tmp_path: Path) -> None:
    path, start, goal = MONACO
    file = tmp_path / "plan.json"
    plan = wb.plan(wb.Map.open(path), wb.Mission.ground_and_air(start, goal))
    file.write_bytes(plan.to_json())
    subprocess.run([str(command), "check", str(path), str(file)], check=True, stdout=subprocess.PIPE)
