"""Missions as data: each class here is a part of the mission document ``waybreaker-mission/1``."""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass, field
from typing import Any, Literal, Mapping, Optional, Sequence, Tuple, Union

Cell = Tuple[int, int]
"""Column and row of a cell, counted from the upper-left one: x to the right, y down."""

Document = Mapping[str, Any]
"""A JSON object as :mod:`json` gives it."""

FORMAT = "waybreaker-mission/1"


@dataclass(frozen=True)
class Vehicle:
    """A ground agent: a disc that drives straight from bend to bend.

    ``start`` and ``goal`` are cells. ``speed`` is in cells per unit of time, ``radius`` in cells (by default half a
    cell, or what the map was made for). ``corners`` is ``"none"``, or ``"cut"`` or ``"squeeze"`` for a point that
    passes one or two blocked corners. It stands at its start until ``ready_at``, in units of time; or comes there on
    its ``approach``, points ``[x, y, t]`` that end at its start then. Its arrival counts ``weight`` times in the
    flowtime (1), as so many people or beds. It may itself breach at most ``breaches`` obstacles, for itself or for
    others (None: none), with its disc at most ``reach`` cells from each (None: 1). A breach takes it ``breach_time``
    for each obstacle and ``breach_time_per_cell`` for each cell (None: as the rules say). ``can_breach`` says which
    obstacles it may breach at all (None: any): ``{"most_cells": 60, "only": [17, "barrier"]}``, by their size, or by
    their ids and tags.
    """

    start: Cell
    goal: Cell
    id: str = "ground"
    speed: float = 1.0
    radius: Optional[float] = None
    corners: Optional[Literal["none", "cut", "squeeze"]] = None
    ready_at: Optional[float] = None
    approach: Optional[Sequence[Sequence[float]]] = None
    weight: Optional[float] = None
    breaches: Optional[int] = None
    breach_time: Optional[float] = None
    breach_time_per_cell: Optional[float] = None
    can_breach: Optional[Document] = None
    reach: Optional[float] = None

    @property
    def kind(self) -> Literal["ground"]:
        return "ground"


@dataclass(frozen=True)
class Aircraft:
    """An air agent: flies straight over everything and breaches at most ``breaches`` obstacles (None: no limit).

    ``start`` and ``goal`` are cells, but ``start`` may be any place between centres, ``speed`` is in cells per unit
    of time. ``ready_at``, ``approach`` and ``weight`` are as those of a vehicle. It flies at most ``range`` cells
    from start to goal, hovering counted, and for ``endurance`` units of time (None: any), less the share ``reserve``.
    Under way it has been in the air for ``flown`` units of time by ``ready_at``, which is gone from both. With
    ``recharge`` it may land at any of ``bases`` (None: its start and goal), cells, and takes off so many units of time
    later with a full battery; range and endurance are then from one landing to the next. ``breach_time``,
    ``breach_time_per_cell`` and ``can_breach`` are as those of a vehicle.
    """

    start: Tuple[float, float]
    goal: Cell
    id: str = "air"
    speed: float = 1.0
    breaches: Optional[int] = None
    ready_at: Optional[float] = None
    approach: Optional[Sequence[Sequence[float]]] = None
    weight: Optional[float] = None
    range: Optional[float] = None
    endurance: Optional[float] = None
    reserve: Optional[float] = None
    flown: Optional[float] = None
    recharge: Optional[float] = None
    bases: Optional[Sequence[Cell]] = None
    breach_time: Optional[float] = None
    breach_time_per_cell: Optional[float] = None
    can_breach: Optional[Document] = None

    @property
    def kind(self) -> Literal["air"]:
        return "air"


Agent = Union[Vehicle, Aircraft]


@dataclass(frozen=True)
class Rules:
    """What every plan keeps to. None stands for the default of docs/contract.md, section 6.

    ``removals``: how many obstacles may go. ``budget``: what they may weigh together, ``budget_m2``: or cover, in
    square metres. ``protect``: numbers of obstacles that stay, tags (``"amenity=school"``) or names (``"name=St.
    Mary*"``); ``force``: numbers of those that must go; ``opened``: those that open by themselves, each
    ``{"obstacle": number, "at": time}``. Of a mission under way, ``failed`` are numbers of obstacles whose breach has
    failed, each once for each time; one may be tried again ``retries`` times. ``breach_time`` and
    ``breach_time_per_cell`` are in units of time, as is ``rubble``, which a vehicle takes longer for each removed
    obstacle that it drives through; ``separation`` of vehicles is in cells, ``minimise_demolition`` a share of the
    objective, 0 to 1. ``zones``: what agents keep out of, GeoJSON in cells as in docs/crews.md. Without
    ``collisions`` vehicles may be anywhere at once, and one that is not at its goal at the time ``unreached`` counts as
    if it arrived then.
    """

    removals: Optional[int] = None
    budget: Optional[float] = None
    budget_m2: Optional[float] = None
    protect: Optional[Sequence[Union[int, str]]] = None
    force: Optional[Sequence[int]] = None
    opened: Optional[Sequence[Mapping[str, float]]] = None
    failed: Optional[Sequence[int]] = None
    retries: Optional[int] = None
    breach_time: Optional[float] = None
    breach_time_per_cell: Optional[float] = None
    rubble: Optional[float] = None
    timing: Optional[Literal["enforce", "ignore"]] = None
    objective: Optional[Literal["makespan", "flowtime", "ground-makespan"]] = None
    minimise_demolition: Optional[float] = None
    separation: Optional[float] = None
    at_goal: Optional[Literal["stay", "leave"]] = None
    zones: Optional[Mapping[str, Any]] = None
    collisions: Optional[bool] = None
    unreached: Optional[float] = None


@dataclass(frozen=True)
class Method:
    """How the mission is planned. None stands for the default: the exact choice, with a proven bound."""

    select: Optional[Literal["exact", "hits", "greedy", "none"]] = None
    flight: Optional[Literal["optimal", "nearest"]] = None
    planner: Optional[Literal["optimal", "theta", "lazy-theta", "astar", "jps", "dijkstra", "bfs"]] = None
    heuristic: Optional[Literal["euclidean", "octile", "chebyshev", "manhattan", "zero"]] = None
    weight: Optional[float] = None
    tie_break: Optional[Literal["g-max", "g-min"]] = None
    moves: Optional[Literal[4, 8]] = None
    bound: Optional[bool] = None
    explain: Optional[bool] = None

    @staticmethod
    def paper(removals: int = 1) -> Method:
        """What the paper fixes of the method; with it go ``Rules(timing="ignore")``.

        The flight is exact past one obstacle, and by the paper's rule past more.
        """
        return Method(select="hits", flight="optimal" if removals == 1 else "nearest", planner="theta")


@dataclass(frozen=True)
class Limits:
    """What ends planning early.

    ``seconds`` for the whole call (None: the command's 10 s; ``math.inf``: no limit), ``expansions`` of each search,
    ``gap``, a share from 0 to 1: the plan is good enough if it is proven to be no more than that above the best one.
    """

    seconds: Optional[float] = None
    expansions: Optional[int] = None
    gap: Optional[float] = None


@dataclass(frozen=True)
class Mission:
    """Who must go where, and what a plan has to keep to.

    One vehicle and one aircraft, or a team: any number of vehicles and aircraft, each with an ``id`` of its own.
    ``time_unit="s"``: a unit of time is a second.

    >>> Mission.ground_and_air((4, 4), (36, 4), removals=1).rules.removals
    1
    """

    agents: Sequence[Agent]
    rules: Rules = field(default_factory=Rules)
    method: Method = field(default_factory=Method)
    limits: Limits = field(default_factory=Limits)
    time_unit: Optional[Literal["s"]] = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "agents", tuple(self.agents))

    @staticmethod
    def ground_and_air(start: Cell, goal: Cell, **rules: Any) -> Mission:
        """The paper's mission: a vehicle and an aircraft that start and end together; `rules` are those of Rules."""
        return Mission([Vehicle(start, goal), Aircraft(start, goal)], Rules(**rules))

    def to_dict(self) -> dict[str, Any]:
        """The mission document; what is None is left out."""
        document: dict[str, Any] = {"format": FORMAT}
        document["agents"] = [agent_document(agent) for agent in self.agents]
        for name in ("rules", "method", "limits"):
            members = _members(getattr(self, name))
            if members:
                document[name] = members
        if self.time_unit is not None:
            document["time_unit"] = self.time_unit
        return document

    @staticmethod
    def from_dict(document: Document) -> Mission:
        """The mission of a document, such as the copy that each plan holds.

        Raises ValueError if a member has no place in these classes.
        """
        if document.get("overlays"):
            raise ValueError("overlays are for the command: 'waybreaker map overlay' makes a map of them")
        agents = [agent_of(agent) for agent in document.get("agents", ())]
        limits = dict(document.get("limits", {}))
        if "seconds" in limits and limits["seconds"] is None:
            limits["seconds"] = float("inf")
        return Mission(
            agents,
            _made(Rules, document.get("rules", {})),
            _made(Method, document.get("method", {})),
            _made(Limits, limits),
            document.get("time_unit"),
        )


AnyMission = Union[Mission, Document]
"""A mission, or the mission document as a dict."""


def agent_document(agent: Agent) -> dict[str, Any]:
    """As mission documents have it."""
    return {"id": agent.id, "kind": agent.kind, **_members(agent)}


def agent_of(document: Document) -> Agent:
    """The agent of its part of a mission document."""
    cells = {"start": tuple(document.get("start", ())), "goal": tuple(document.get("goal", ()))}
    members = {name: value for name, value in document.items() if name != "kind"}
    agent: Agent = _made(Aircraft if document.get("kind") == "air" else Vehicle, {**members, **cells})
    return agent


def _made(part: Any, members: Document) -> Any:
    known = {member.name for member in dataclasses.fields(part)}
    unknown = sorted(set(members) - known)
    if unknown:
        raise ValueError(f"{part.__name__} has no member '{unknown[0]}'; it has {', '.join(sorted(known))}")
    return part(**members)


def _members(part: Any) -> dict[str, Any]:
    members = {member.name: getattr(part, member.name) for member in dataclasses.fields(part)}
    return {name: _plain(value) for name, value in members.items() if value is not None}


def _plain(value: Any) -> Any:
    """As JSON has it: also of numpy's numbers."""
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if isinstance(value, Mapping):
        return {name: _plain(item) for name, item in value.items()}
    if hasattr(value, "item"):
        return value.item()
    return value


def document_of(mission: AnyMission, limits: Limits) -> str:
    """The text of a mission document, its limits replaced where others are given."""
    document = mission.to_dict() if isinstance(mission, Mission) else dict(mission)
    given = _members(limits)
    if given:
        document["limits"] = {**document.get("limits", {}), **given}
    if document.get("limits", {}).get("seconds") == float("inf"):
        document["limits"] = {**document["limits"], "seconds": None}
    return json.dumps(document, allow_nan=False, default=_plain_or_error)


def _plain_or_error(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a mission document holds no {type(value).__name__}")
