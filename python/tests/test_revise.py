"""Plans that meet the field: states, revisions, continuity; equal to those of the command."""

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

EVERYTHING = wb.State(
    sequence=3,
    now=42.5,
    agents=[
        wb.AgentState("rover", 3, at=(12.25, 8.0), doing="driving", goal=(9, 9)),
        wb.AgentState("heli", 0, doing="lost"),
    ],
    opened=[wb.Opening(4, 40.0)],
    failed=[wb.Opening(7, 42.5)],
    found=[wb.Found([(13, 9), (14, 9)], destructible=True), wb.Found([(1, 1)], blocked=False)],
    joined=[wb.Vehicle((1, 2), (3, 4), id="second")],
)


@pytest.fixture
def mission() -> wb.Mission:
    return wb.Mission.ground_and_air((4, 4), (36, 4), removals=1, breach_time=3)


@pytest.fixture
def plan(wall_map: wb.Map, mission: wb.Mission) -> wb.Plan:
    return wb.plan(wall_map, mission)


def failed(plan: wb.Plan) -> wb.State:
    """The breach has left its obstacle standing."""
    breach = plan.removed[0]
    return wb.State(1, breach.cleared_at, failed=[wb.Opening(breach.obstacle, breach.cleared_at)])


def test_state_document() -> None:
    document = EVERYTHING.to_dict()
    assert document["format"] == "waybreaker-state/1"
    assert document["agents"][1] == {"id": "heli", "passed": 0, "doing": "lost"}
    assert document["found"][1] == {"cells": [[1, 1]], "blocked": False}
    assert document["joined"][0]["kind"] == "ground"
    assert wb.State.from_dict(document) == EVERYTHING
    assert wb.State.from_dict(json.loads(json.dumps(document))) == EVERYTHING
    assert wb.State(1, 2).to_dict() == {"format": "waybreaker-state/1", "sequence": 1, "now": 2}
    with pytest.raises(ValueError, match="State has no member 'time'"):
        wb.State.from_dict({"format": "waybreaker-state/1", "sequence": 1, "now": 2, "time": 3})


def test_failed_breach(wall_map: wb.Map, plan: wb.Plan) -> None:
    state = failed(plan)
    after = wb.revise(wall_map, plan, state)
    assert after.solved and not after.removed
    assert plan.makespan and after.makespan and after.makespan > plan.makespan
    revision = after.revision
    assert revision and (revision.number, revision.sequence, revision.status) == (1, 1, "revised")
    assert {decision.agent for decision in revision.decided} == {"ground", "air"}
    assert after["ground"].times[0] == state.now
    assert after.mission.rules.failed == [plan.removed[0].obstacle]
    assert wb.check(wall_map, after, after=plan, state=state) == []
    assert plan.revision is None


def test_failed_breach_is_tried_again(wall_map: wb.Map, wall: NDArray[np.bool_]) -> None:
    rules = wb.Rules(removals=1, breach_time=3, retries=1)
    plan = wb.plan(wall_map, wb.Mission([wb.Vehicle((4, 4), (36, 4)), wb.Aircraft((4, 4), (36, 4), speed=3)], rules))
    again = wb.revise(wall_map, plan, failed(plan))
    assert [breach.obstacle for breach in again.removed] == [1]
    assert again.mission.rules.retries == 1


def test_report_that_is_known_changes_nothing(wall_map: wb.Map, plan: wb.Plan) -> None:
    after = wb.revise(wall_map, plan, failed(plan))
    assert wb.revise(wall_map, after, failed(plan)).to_json() == after.to_json()


def test_revision_is_revised(wall_map: wb.Map, plan: wb.Plan) -> None:
    first = wb.revise(wall_map, plan, failed(plan))
    later = wb.State(2, failed(plan).now + 2, found=[wb.Found([(25, 10)])])
    second = wb.revise(wall_map, first, later)
    assert second.revision and second.revision.number == 2
    assert second.revision.found == (wb.Found([(25, 10)], blocked=True),)
    assert wb.check(wall_map, second, after=first, state=later) == []
    assert wb.check(wall_map, second) == []


def test_broken(wall_map: wb.Map, plan: wb.Plan) -> None:
    """The street is blocked right ahead of the vehicle, which knows of the new plan too late."""
    ground = plan["ground"]
    now = float(ground.times[-1]) / 4
    x, y = np.rint(ground.at(now + 3)).astype(int)
    state = wb.State(1, now, found=[wb.Found([(int(x), int(y))])])
    broken = wb.revise(wall_map, plan, state, reaction=20)
    assert broken.status == "no_plan"
    assert broken.revision and broken.revision.status == "broken"
    (halt,) = broken.revision.halts
    assert halt.agent == "ground" and now < halt.by < now + 3


def test_no_vehicle_left(wall_map: wb.Map, plan: wb.Plan) -> None:
    none = wb.revise(wall_map, plan, wb.State(1, 5, [wb.AgentState("ground", 0, doing="lost")]))
    assert not none.solved and none.revision
    assert (none.revision.status, none.revision.reason) == ("no_plan", "no vehicle is left to drive")


def test_continuity_is_judged(wall_map: wb.Map, mission: wb.Mission, plan: wb.Plan) -> None:
    fresh = wb.plan(wall_map, mission)
    assert "continuity" in {v.rule for v in wb.check(wall_map, fresh, after=plan, state=failed(plan))}


def test_documents_as_dicts_and_texts(wall_map: wb.Map, plan: wb.Plan) -> None:
    state = failed(plan)
    expected = wb.revise(wall_map, plan, state)
    texts: "list[bytes | str]" = [plan.to_json(), plan.to_json().decode()]
    for held in texts:
        assert wb.revise(wall_map, held, state.to_dict()).to_json() == expected.to_json()
    by_dict = wb.revise(wall_map, plan.to_dict(), state)
    assert by_dict["ground"].times.tolist() == expected["ground"].times.tolist()
    assert wb.check(wall_map, by_dict.to_dict(), after=plan.to_dict(), state=state.to_dict()) == []


def test_refusals(wall_map: wb.Map, wall: NDArray[np.bool_], plan: wb.Plan) -> None:
    state = failed(plan)
    with pytest.raises(wb.InputError, match="^state: opened obstacle 9"):
        wb.revise(wall_map, plan, wb.State(1, 5, opened=[wb.Opening(9, 4)]))
    with pytest.raises(wb.InputError, match="^state.*sequence"):
        wb.revise(wall_map, plan, wb.State(0, 5))
    with pytest.raises(wb.InputError, match="^plan"):
        wb.revise(wall_map, b"{}", state)
    wall[0, 0] = True
    with pytest.raises(wb.InputError, match="^plan: .*another map"):
        wb.revise(wb.Map.from_array(wall), plan, state)
    with pytest.raises(wb.InputError, match="connectivity 4"):
        wb.revise(wb.Map.from_movingai(wall_map.to_movingai(), "array", connectivity=8), plan, state)
    with pytest.raises(wb.InputError, match="^the time of reaction must be from 0"):
        wb.revise(wall_map, plan, state, reaction=-1)
    with pytest.raises(wb.InputError, match="^the time limit must be above 0"):
        wb.revise(wall_map, plan, state, seconds=0)
    with pytest.raises(wb.InputError, match="belong together"):
        wb.check(wall_map, plan, after=plan)


def same_as_command(command: Path, folder: Path, map_file: Path, plan: bytes, state: wb.State, reaction: float) -> None:
    files = {name: folder / f"{name}.json" for name in ("plan", "state", "new", "report")}
    files["plan"].write_bytes(plan)
    files["state"].write_text(json.dumps(state.to_dict()))

    def run(*words: Any) -> int:
        return subprocess.run([str(command), *[str(word) for word in words]], capture_output=True).returncode

    options = ["--reaction", reaction, "--no-timing", "--time-limit", 1e6, "--json", files["new"]]
    assert run("revise", map_file, files["plan"], "--state", files["state"], *options) in (0, 1)
    map = wb.Map.open(map_file)
    new = wb.revise(map, plan, state, reaction=reaction, seconds=math.inf)
    assert new.to_json() == files["new"].read_bytes()
    continuity = ["--after", files["plan"], "--state", files["state"]]
    assert run("check", map_file, files["new"], *continuity, "--json", files["report"]) in (0, 1)
    report = json.loads(files["report"].read_text())
    found = wb.check(map, new, after=plan, state=state)
    assert [violation.message for violation in found] == [violation["message"] for violation in report["violations"]]
    if new.solved:
        assert found == []


def test_same_as_the_command(command: Path, plan_file: PlanFile, tmp_path: Path) -> None:
    path = DATA / "berlin-adlershof.tif"
    rules = {"removals": 2, "breach_time": 10}
    asked = wb.Mission.ground_and_air((130, 104), (466, 105), **rules).to_dict()
    asked["agents"][1]["speed"] = 2
    plan = plan_file(path, asked)
    document = json.loads(plan)
    breach = document["removed"][0]
    end = document["after"]["makespan"]
    ground = document["agents"][0]["path"]
    x, y, t = ground[len(ground) // 2]
    for state, reaction in [
        (wb.State(1, breach["cleared_at"], failed=[wb.Opening(breach["obstacle"], breach["cleared_at"])]), 0),
        (wb.State(1, end / 4, [wb.AgentState("air", 0, doing="lost")]), 2),
        (wb.State(1, t - 20, found=[wb.Found([(int(x), int(y))])]), 0),
        (wb.State(1, t - 2, found=[wb.Found([(int(x), int(y))])]), 30),
        (wb.State(1, end / 2), 0),
    ]:
        same_as_command(command, tmp_path, path, plan, state, reaction)


def test_edited_map_keeps_ids(wall_map: wb.Map, mission: wb.Mission) -> None:
    tower = wb.Attributes(source_id=4711, name="tower", weight=2)
    edited = wall_map.with_edits([wb.MapEdit.add([(30, 4), (30, 5)], tower), wb.MapEdit.free([(20, 0)])])
    wall, built = edited.obstacles
    assert (wall.id, wall.cells, built.name, built.source_id, built.weight) == (1, 17, "tower", 4711, 2.0)
    assert edited.labels[4, 30] == 2 and edited.labels[0, 20] == 0
    assert wall_map.labels[4, 30] == 0
    assert edited.digest != wall_map.digest
    plan = wb.plan(edited, mission)
    assert wb.check(edited, plan) == [] and wb.check(wall_map, plan) != []
    gone = edited.with_edits([wb.MapEdit.remove(1)])
    assert [obstacle.cells for obstacle in gone.obstacles] == [0, 2]
    assert gone.with_edits([wb.MapEdit.extend(2, [(31, 4)])]).obstacles[1].cells == 3
    with pytest.raises(wb.InputError, match="no obstacle 1 to remove"):
        gone.with_edits([wb.MapEdit.remove(1)])
    with pytest.raises(wb.InputError):
        gone.with_edits([wb.MapEdit.free([(40, 0)])])
