"""What tests share: the command to compare with, and maps."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any, Callable, Mapping

import numpy as np
import pytest
from numpy.typing import NDArray

import waybreaker as wb

PROJECT = Path(__file__).resolve().parents[2]
DATA = PROJECT / "data"


@pytest.fixture(scope="session")
def command() -> Path:
    """The command; tests that need it are skipped where it is not built, unless WAYBREAKER_COMMAND names it."""
    named = os.environ.get("WAYBREAKER_COMMAND")
    path = Path(named) if named else PROJECT / "build/release/apps/waybreaker"
    if not path.exists() and not named:
        pytest.skip("the command is not built: build/release/apps/waybreaker")
    return path


PlanFile = Callable[..., bytes]


@pytest.fixture
def plan_file(command: Path, tmp_path: Path) -> PlanFile:
    """Plans a mission document on a map file by the command, and gives the bytes of its plan file."""

    def run(map_file: Path, mission: Mapping[str, Any], *options: str) -> bytes:
        mission_file = tmp_path / "mission.json"
        mission_file.write_text(json.dumps({**mission, "limits": {"seconds": None}}))  # a busy machine changes nothing
        plan = ["plan", str(map_file), "--mission", str(mission_file), "--no-timing", "--json", "-", *options]
        return subprocess.run([str(command), *plan], check=True, stdout=subprocess.PIPE).stdout

    return run


@pytest.fixture
def wall() -> NDArray[np.bool_]:
    """20 rows of 40 cells; a wall with a passage at its lower end."""
    cells = np.zeros((20, 40), dtype=bool)
    cells[:18, 20] = True
    return cells


@pytest.fixture
def wall_map(wall: NDArray[np.bool_]) -> wb.Map:
    return wb.Map.from_array(wall)


@pytest.fixture
def through_the_wall() -> wb.Mission:
    return wb.Mission.ground_and_air((4, 4), (36, 4), removals=1)
