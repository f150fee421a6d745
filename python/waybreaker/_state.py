"""What has happened to a plan, as data: each class here is a part of the state document ``waybreaker-state/1``."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Literal, Optional, Sequence, Tuple, Union

from ._mission import Agent, Cell, Document, _made, _members, _plain_or_error, agent_document, agent_of

FORMAT = "waybreaker-state/1"


@dataclass(frozen=True)
class Opening:
    """An obstacle, by its number, that is open from ``at`` on, in units of time; or whose breach failed then."""

    obstacle: int
    at: float


@dataclass(frozen=True)
class Found:
    """Cells that turned out to be blocked, or free (``blocked=False``), other than the map says.

    Blocked ones are one new obstacle, which aircraft may breach if it is ``destructible``.
    """

    cells: Sequence[Cell]
    blocked: Optional[bool] = None
    destructible: Optional[bool] = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "cells", tuple((x, y) for x, y in self.cells))


@dataclass(frozen=True)
class AgentState:
    """What has happened to an agent of the plan.

    ``passed`` is the last point of its path, counted from 0, that it has left behind; ``at`` is where it is, in cells
    (None: where the plan has it by now). ``doing`` is ``"driving"`` (flying as well, and the default), ``"waiting"``,
    ``"breaching"``, ``"stopped"`` or ``"lost"``: who has stopped blocks its cells, who is lost nothing, and neither
    takes any further part. It is to go to the cell ``goal`` from now on, if there is one. An aircraft has been in the
    air for ``flown`` units of time since its battery was full (None: as planned).
    """

    id: str
    passed: int
    at: Optional[Tuple[float, float]] = None
    doing: Optional[Literal["driving", "waiting", "breaching", "stopped", "lost"]] = None
    goal: Optional[Cell] = None
    flown: Optional[float] = None


@dataclass(frozen=True)
class State:
    """What has happened to a plan by ``now``, in units of time on its clock.

    ``sequence`` numbers reports upwards from 1; one that the plan knows already changes nothing. ``agents`` that are
    not named are where the plan has them. ``opened`` are obstacles that are open, whoever opened them, or will be at
    that time; ``failed`` are breaches that left their obstacle standing; ``joined`` are new agents.

    >>> State(1, 42.5, [AgentState("air", 0, doing="lost")]).to_dict()["agents"]
    [{'id': 'air', 'passed': 0, 'doing': 'lost'}]
    """

    sequence: int
    now: float
    agents: Sequence[AgentState] = ()
    opened: Sequence[Opening] = ()
    failed: Sequence[Opening] = ()
    found: Sequence[Found] = ()
    joined: Sequence[Agent] = ()

    def __post_init__(self) -> None:
        for name in ("agents", "opened", "failed", "found", "joined"):
            object.__setattr__(self, name, tuple(getattr(self, name)))

    def to_dict(self) -> dict[str, Any]:
        """The state document; what is empty is left out."""
        document: dict[str, Any] = {"format": FORMAT, **_members(State(self.sequence, self.now))}
        for name in ("agents", "opened", "failed", "found"):
            document[name] = [_members(part) for part in getattr(self, name)]
        document["joined"] = [agent_document(agent) for agent in self.joined]
        return {name: value for name, value in document.items() if value != []}

    @staticmethod
    def from_dict(document: Document) -> State:
        """The state of a document. Raises ValueError if a member has no place in these classes."""
        parts = {"agents": AgentState, "opened": Opening, "failed": Opening, "found": Found}
        members = {name: value for name, value in document.items() if name != "format"}
        for name, part in parts.items():
            members[name] = [_made(part, _with_tuples(item)) for item in members.get(name, ())]
        members["joined"] = [agent_of(agent) for agent in members.get("joined", ())]
        state: State = _made(State, members)
        return state


AnyState = Union[State, Document]
"""A state, or the state document as a dict."""


def _with_tuples(members: Document) -> dict[str, Any]:
    """Places and cells are lists in documents."""
    places = ("at", "goal")
    return {
        name: tuple(value) if name in places and isinstance(value, list) else value for name, value in members.items()
    }


def state_document(state: AnyState) -> str:
    """The text of a state document."""
    document = state.to_dict() if isinstance(state, State) else dict(state)
    return json.dumps(document, allow_nan=False, default=_plain_or_error)
