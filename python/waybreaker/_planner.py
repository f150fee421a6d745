"""Planning and checking."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple, Union

from . import _core
from ._map import Map
from ._mission import AnyMission, Limits, document_of
from ._plan import Plan


def plan(
    map: Map,
    mission: AnyMission,
    *,
    seconds: Optional[float] = None,
    expansions: Optional[int] = None,
    gap: Optional[float] = None,
    threads: int = 1,
) -> Plan:
    """Plans a mission, as ``waybreaker plan`` does.

    ``mission`` is a :class:`Mission`, or the mission document as a dict. ``seconds``, ``expansions`` and ``gap``
    replace its limits (:class:`Limits`); without any it takes at most 10 s. ``threads`` (0: one a core) plan the
    vehicles of a team with aircraft side by side. No plan is no error: see :attr:`Plan.status`.

    Other Python threads run meanwhile, and KeyboardInterrupt ends it. Raises InputError if the document is none, or
    the mission cannot be put on the map.
    """
    text = document_of(mission, Limits(seconds, expansions, gap))
    return Plan(map, _core.plan(map._core, text, _threads(threads)))


def front(
    map: Map,
    mission: AnyMission,
    *,
    seconds: Optional[float] = None,
    expansions: Optional[int] = None,
    gap: Optional[float] = None,
    threads: int = 1,
) -> list[Plan]:
    """What each further removal gains: the plans for 0, 1, 2, ... removals, up to the last that gains.

    At most as many as the mission allows; the first has what it forces. ``seconds`` are those of all plans
    together. The document of the last one is that of ``waybreaker plan --removals auto``, and lists all of them as
    ``front``. The rest as for :func:`plan`.
    """
    text = document_of(mission, Limits(seconds, expansions, gap))
    return [Plan(map, step) for step in _core.front(map._core, text, _threads(threads))]


@dataclass(frozen=True)
class Violation:
    """What is wrong with a plan.

    ``rule`` is the word of ``waybreaker check --json``. ``agent`` and ``obstacle`` say whose it is, ``place``
    where, in cells, ``time`` when, in units of time; None where that is not known.
    """

    rule: str
    message: str
    agent: Optional[str]
    obstacle: Optional[int]
    place: Optional[Tuple[float, float]]
    time: Optional[float]


def check(
    map: Map,
    plan: Union[Plan, Mapping[str, Any], bytes, str],
    *,
    tolerance: float = 1e-6,
    ignore_digest: bool = False,
) -> list[Violation]:
    """Judges a plan from the map alone, without the planner's geometry; empty if it is valid.

    ``plan`` is a :class:`Plan`, or a plan file as dict or text. Numbers may be off by ``tolerance``, a share of
    themselves. With ``ignore_digest`` another map will do, if only the plan holds on it. Raises InputError if the
    document is no plan.
    """
    if isinstance(plan, Plan):
        data = plan.to_json()
    elif isinstance(plan, (bytes, str)):
        data = plan.encode() if isinstance(plan, str) else plan
    else:
        data = json.dumps(plan).encode()
    report = json.loads(_core.check(map._core, data, tolerance, ignore_digest))
    return [_violation(violation) for violation in report["violations"]]


def _violation(document: dict[str, Any]) -> Violation:
    place = document["place"]
    return Violation(
        rule=document["rule"],
        message=document["message"],
        agent=document["agent"],
        obstacle=document["obstacle"],
        place=(place[0], place[1]) if place else None,
        time=document["time"],
    )


def _threads(threads: int) -> int:
    if not 0 <= threads <= 1024:
        raise _core.InputError("threads must be from 0 to 1024; 0 is one a core")
    return threads
