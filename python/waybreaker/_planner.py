"""Planning and checking."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple, Union

from . import _core
from ._map import Map
from ._mission import AnyMission, Limits, document_of
from ._plan import Plan
from ._state import AnyState, state_document

AnyPlan = Union[Plan, Mapping[str, Any], bytes, str]
"""A plan, or a plan file as dict or text."""

USUAL_SECONDS = 10.0
"""As the command has it."""


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


def revise(
    map: Map,
    plan: AnyPlan,
    state: AnyState,
    *,
    reaction: float = 0.0,
    seconds: Optional[float] = None,
    threads: int = 1,
) -> Plan:
    """Plans the rest of a mission anew, from what has happened to its plan, as ``waybreaker revise`` does.

    ``map`` is the one that the mission began on. ``plan`` is the plan that holds, a revision as well: a :class:`Plan`,
    or a plan file as dict or text. ``state`` is a :class:`State`, or the state document as a dict. Agents keep to the
    old plan until they know of the new one, ``reaction`` units of time after ``state.now``. ``seconds`` is how long to
    plan at most (None: 10; ``math.inf``: no limit), ``threads`` is as for :func:`plan`.

    What agents are bound to do stays; the rest is planned anew, with a bound, and the old rest is kept if nothing
    better is found. :attr:`Plan.revision` says what has become of the old plan. No plan is no error: see :attr:`Plan.status`.
    A state that the plan knows already gives the plan again. Raises InputError if a document is none, the plan is for
    another map, or the state cannot be one of the plan.
    """
    limit = USUAL_SECONDS if seconds is None else seconds
    text = state_document(state)
    return Plan(map, _core.revise(map._core, _bytes_of(plan), text, reaction, limit, _threads(threads)))


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
    plan: AnyPlan,
    *,
    after: Optional[AnyPlan] = None,
    state: Optional[AnyState] = None,
    tolerance: float = 1e-6,
    ignore_digest: bool = False,
) -> list[Violation]:
    """Judges a plan from the map alone, without the planner's geometry; empty if it is valid.

    ``plan`` is a :class:`Plan`, or a plan file as dict or text. Numbers may be off by ``tolerance``, a share of
    themselves. With ``ignore_digest`` another map will do, if only the plan holds on it. Raises InputError if the
    document is no plan.

    With ``after``, the plan before, and ``state``, from which :func:`revise` made this one, also judges whether it goes
    on from there: everybody keeps to what it was bound to do, nobody is forgotten, and what is open, failed or used up
    counts.
    """
    if (after is None) != (state is None):
        raise _core.InputError("after and state belong together: the plan before, and what had happened to it")
    continuity = None if after is None or state is None else (_bytes_of(after), state_document(state))
    report = json.loads(_core.check(map._core, _bytes_of(plan), tolerance, ignore_digest, continuity))
    return [_violation(violation) for violation in report["violations"]]


def _bytes_of(plan: AnyPlan) -> bytes:
    """The plan file."""
    if isinstance(plan, Plan):
        return plan.to_json()
    if isinstance(plan, (bytes, str)):
        return plan.encode() if isinstance(plan, str) else plan
    return json.dumps(plan).encode()


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
