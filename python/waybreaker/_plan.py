"""Plans, as data."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._map import Map
from ._mission import Cell, Mission
from ._state import Found

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Status = Literal["solved", "no_plan", "not_found", "limit_reached", "stopped"]


@dataclass(frozen=True)
class Outcome:
    """The mission at one stage: without removal, or as planned. None where there is no path.

    ``makespan`` is when the last agent reaches its goal, ``flowtime`` the sum of when each does,
    ``ground_makespan`` when the last vehicle does, in units of time. ``lengths`` of the agents' paths, in cells, by
    their ids.
    """

    makespan: Optional[float]
    flowtime: Optional[float]
    ground_makespan: Optional[float]
    lengths: dict[str, Optional[float]]


@dataclass(frozen=True)
class IfFailed:
    """Plan B: what a mission comes to if a breach fails when it is tried.

    ``objective`` is in units of time, None where there is no plan then. ``removed`` are the ids of all obstacles that
    are removed then.
    """

    objective: Optional[float]
    removed: Tuple[int, ...]


@dataclass(frozen=True)
class Breach:
    """An obstacle that an aircraft removes.

    ``obstacle`` is its id, ``at`` the cell from which ``by`` breaches it. It is gone at ``cleared_at``; a vehicle
    first touches it at ``entered_at`` (None: never). ``area_m2`` is known where the map knows how large a cell is,
    ``saves``, what the objective would lose if it had to stay, with ``explain``; ``if_failed``, of plan files made with
    ``--plan-b``.
    """

    obstacle: int
    cells: int
    at: Cell
    by: str
    cleared_at: float
    entered_at: Optional[float]
    area_m2: Optional[float]
    saves: Optional[float]
    name: str
    if_failed: Optional[IfFailed] = None


@dataclass(frozen=True, eq=False)
class Itinerary:
    """An agent's path in time.

    ``path`` has shape (n, 2): x and y, in cells, of each point at which it turns, waits or breaches; ``times``, of
    shape (n,), is when it is there, in units of time. Both are read-only. The same point twice is a wait.
    """

    id: str
    kind: Literal["ground", "air"]
    speed: float
    start: Cell
    goal: Cell
    path: NDArray[np.float64]
    times: NDArray[np.float64]

    @property
    def arrives_at(self) -> float:
        """When it is at its goal, in units of time."""
        return float(self.times[-1])

    def at(self, time: float) -> NDArray[np.float64]:
        """Where it is at that time, of shape (2,), in cells; at its goal from its arrival on."""
        return np.array([np.interp(time, self.times, self.path[:, axis]) for axis in (0, 1)])


@dataclass(frozen=True)
class Moment:
    """An agent has got to that point of its path, counted from 0, or that share of the move to the next one."""

    agent: str
    point: int
    fraction: float


@dataclass(frozen=True)
class Order:
    """The agent of ``after`` may not leave from there before that of ``before`` has got there.

    ``why`` is ``opening``: ``obstacle`` must be breached; or ``passing``: of two vehicles that could touch, one goes
    first. ``slack`` is how late the first may be until the second is put off, in units of time.
    """

    before: Moment
    after: Moment
    why: Literal["opening", "passing"]
    obstacle: Optional[int]
    slack: float


@dataclass(frozen=True)
class Decision:
    """Up to that point of its path an agent keeps to the plan before; it is there at ``time``, in units of time."""

    agent: str
    point: int
    time: float


@dataclass(frozen=True)
class Halt:
    """An agent must stop before it gets to that point of its path in the plan before, at time ``by``."""

    agent: str
    point: int
    by: float


@dataclass(frozen=True)
class Revision:
    """What a plan says of itself that was made while the mission was under way.

    ``number`` is 1 for the first one. ``sequence`` is the last report that it knows, made at ``now``, in units of time;
    paths begin then. ``status`` is what has become of the plan before: ``kept``, nothing better was found than the rest
    of it; ``revised``, the rest is another one; ``no_plan``, none was found, and ``reason`` may say why; ``broken``,
    agents are bound to meet what is in their way unless they stop, as ``halts`` says. ``supersedes`` is the SHA-256 of
    the document of the plan before. ``decided`` says where each agent stops to keep to that, ``found`` what was found
    since the mission began.
    """

    number: int
    sequence: int
    now: float
    status: Literal["kept", "revised", "no_plan", "broken"]
    reason: str
    supersedes: str
    decided: Tuple[Decision, ...]
    halts: Tuple[Halt, ...]
    found: Tuple[Found, ...]


class Plan:
    """What :func:`plan` gives: who is where when, and what is removed. It never changes."""

    def __init__(self, map: Map, core: _core.Plan) -> None:
        self._map = map
        self._core = core
        self._document: dict[str, Any] = json.loads(core.json(True))
        document = self._document
        agents = document["mission"]["agents"]
        aircraft = [agent["id"] for agent in agents if agent["kind"] == "air"]
        self.status: Status = document["status"]
        """``solved``; ``no_plan``: there is none; ``not_found``, ``limit_reached``, ``stopped``: the search ended."""
        self.before = _outcome(document["before"], agents)
        """The mission without removal; of a team, each agent as if it were alone."""
        self.after = _outcome(document["after"], agents)
        """The plan itself."""
        bound = document["bound"] or {}
        self.bound: Optional[float] = next((value for key, value in bound.items() if key != "gap"), None)
        """Proven: no plan with that many removals has a smaller objective. None where the method proves nothing."""
        self.gap: Optional[float] = bound.get("gap")
        """The objective / bound - 1: 0.01 is one percent."""
        self.limit_reached: bool = document.get("limit_reached", False)
        """Whether a limit ended the search, so that a better plan may exist."""
        self.removed = tuple(_breach(breach, aircraft) for breach in document["removed"])
        """What is removed, in the order of the flight."""
        self.agents = tuple(_itinerary(agent) for agent in document["agents"])
        """The path of each agent, in the order of the mission; empty unless solved."""
        self.orders = tuple(_order(order) for order in document.get("orders", ()))
        """What waits for what: who keeps them meets nobody and nothing that stands, whatever comes late."""
        self.revision: Optional[Revision] = _revision(document.get("revision"))
        """Of a plan that revises another: which, why, and where agents decide."""
        self.seconds: float = document["seconds"]["total"]
        """How long planning took."""

    @property
    def map(self) -> Map:
        """The map that it was made for; of a revision, the one that the mission began on."""
        return self._map

    @property
    def mission(self) -> Mission:
        """The mission that was planned, without its limits, all defaults there."""
        return Mission.from_dict(self._document["mission"])

    @property
    def solved(self) -> bool:
        """Whether there is a plan."""
        return self.status == "solved"

    @property
    def makespan(self) -> Optional[float]:
        """When the last agent reaches its goal, in units of time; None unless solved."""
        return self.after.makespan if self.solved else None

    @property
    def flowtime(self) -> Optional[float]:
        """The sum over agents of when each reaches its goal, in units of time; None unless solved."""
        return self.after.flowtime if self.solved else None

    def __getitem__(self, id: str) -> Itinerary:
        """The path of the agent of that id. Raises KeyError if the plan has none."""
        for agent in self.agents:
            if agent.id == id:
                return agent
        raise KeyError(id)

    def to_json(self, *, timing: bool = False) -> bytes:
        """The plan file, ``waybreaker-plan/1``: equal to the byte to that of ``waybreaker plan --json --no-timing``.

        With ``timing`` it has the measured seconds, which differ each time.
        """
        return self._core.json(timing)

    def to_dict(self, *, timing: bool = False) -> dict[str, Any]:
        """What :func:`json.loads` makes of the plan file."""
        document: dict[str, Any] = json.loads(self.to_json(timing=timing))
        return document

    def to_svg(self) -> str:
        """A picture: the map, what is removed, the paths before and after."""
        return self._core.svg()

    def to_geojson(self) -> dict[str, Any]:
        """A GeoJSON FeatureCollection in longitude and latitude: paths, breaches and what is removed.

        Raises InputError if the map does not say where it lies on earth, ImportError without rasterio.
        """
        collection: dict[str, Any] = json.loads(self._core.geojson(self._map.to_lon_lat()))
        return collection

    def to_geodataframe(self) -> Any:
        """The same as a geopandas.GeoDataFrame, in WGS84. Raises ImportError without geopandas."""
        try:
            import geopandas
        except ImportError as error:
            raise ImportError(
                "to_geodataframe() needs geopandas: 'pip install geopandas', or on Debian "
                "'apt install python3-geopandas'; to_geojson() does without"
            ) from error
        return geopandas.GeoDataFrame.from_features(self.to_geojson()["features"], crs="EPSG:4326")

    def plot(self, ax: Optional[Axes] = None) -> Axes:
        """Draws it with matplotlib, in cells, y down. Raises ImportError without matplotlib."""
        from ._plot import draw

        return draw(self, ax)

    def _repr_svg_(self) -> str:
        return self.to_svg()

    def _repr_html_(self) -> str:
        svg = self.to_svg()
        return svg[svg.index("<svg") :]

    def __repr__(self) -> str:
        if not self.solved:
            return f"<waybreaker.Plan: {self.status}>"
        before = f" instead of {self.before.makespan:.6g}" if self.before.makespan is not None else ""
        gap = f", gap {self.gap:.2%}" if self.gap is not None else ""
        return f"<waybreaker.Plan: makespan {self.makespan:.6g}{before}, {len(self.removed)} removed{gap}>"


def _outcome(document: dict[str, Any], agents: list[dict[str, Any]]) -> Outcome:
    if "routes" in document:
        lengths = {route["id"]: route["length"] for route in document["routes"]}
    else:
        lengths = {agent["id"]: document[agent["kind"]]["length"] for agent in agents}
    return Outcome(document["makespan"], document["flowtime"], document["ground_makespan"], lengths)


def _cell(document: Any) -> Cell:
    x, y = document
    return x, y


def _if_failed(document: Optional[dict[str, Any]]) -> Optional[IfFailed]:
    if document is None:
        return None
    return IfFailed(document["objective"], tuple(document["removed"]))


def _breach(document: dict[str, Any], aircraft: list[str]) -> Breach:
    return Breach(
        obstacle=document["obstacle"],
        cells=document["cells"],
        at=_cell(document["at"]),
        by=document.get("by", aircraft[0]),
        cleared_at=document["cleared_at"],
        entered_at=document["entered_at"],
        area_m2=document.get("area_m2"),
        saves=document.get("saves"),
        name=document.get("name", ""),
        if_failed=_if_failed(document.get("if_failed")),
    )


def _read_only(values: NDArray[np.float64]) -> NDArray[np.float64]:
    values = np.ascontiguousarray(values)
    values.setflags(write=False)
    return values


def _moment(fields: dict[str, Any]) -> Moment:
    return Moment(fields["agent"], fields["point"], fields.get("fraction", 0.0))


def _revision(fields: Optional[dict[str, Any]]) -> Optional[Revision]:
    if fields is None:
        return None
    return Revision(
        number=fields["number"],
        sequence=fields["sequence"],
        now=fields["now"],
        status=fields["status"],
        reason=fields.get("reason", ""),
        supersedes=fields.get("supersedes", ""),
        decided=tuple(Decision(**decision) for decision in fields["decided"]),
        halts=tuple(Halt(**halt) for halt in fields.get("halts", ())),
        found=tuple(Found(**found) for found in fields.get("found", ())),
    )


def _order(fields: dict[str, Any]) -> Order:
    return Order(
        before=_moment(fields["before"]),
        after=_moment(fields["after"]),
        why=fields["why"],
        obstacle=fields.get("obstacle"),
        slack=fields["slack"],
    )


def _itinerary(document: dict[str, Any]) -> Itinerary:
    points = np.array(document["path"], dtype=np.float64).reshape(-1, 3)
    return Itinerary(
        id=document["id"],
        kind=document["kind"],
        speed=document["speed"],
        start=_cell(document["start"]),
        goal=_cell(document["goal"]),
        path=_read_only(points[:, :2]),
        times=_read_only(points[:, 2]),
    )
