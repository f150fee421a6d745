"""Plans missions on which a vehicle crosses a map and an aircraft opens the way.

>>> import numpy, waybreaker
>>> wall = numpy.zeros((20, 40), dtype=bool)
>>> wall[:18, 20] = True
>>> mission = waybreaker.Mission.ground_and_air((4, 4), (36, 4), removals=1)
>>> waybreaker.plan(waybreaker.Map.from_array(wall), mission).status
'solved'

Cells are counted from the upper-left one, (0, 0): x to the right, y down. Lengths are in cells, times in the units that
speeds are in: at speed 1, a cell takes one. Arrays are indexed [y, x]. Bad input raises InputError, a ValueError.
"""

from ._core import InputError, __version__
from ._map import Attributes, Map, MapEdit, Obstacle, Place
from ._mission import Agent, Aircraft, Cell, Limits, Method, Mission, Rules, Vehicle
from ._plan import Breach, Decision, Halt, IfFailed, Itinerary, Moment, Order, Outcome, Plan, Revision
from ._planner import Violation, check, front, plan, revise
from ._state import AgentState, Found, Opening, State

__all__ = [
    "Agent",
    "AgentState",
    "Aircraft",
    "Attributes",
    "Breach",
    "Cell",
    "Decision",
    "Found",
    "Halt",
    "IfFailed",
    "InputError",
    "Itinerary",
    "Limits",
    "Map",
    "MapEdit",
    "Method",
    "Mission",
    "Moment",
    "Obstacle",
    "Opening",
    "Order",
    "Outcome",
    "Place",
    "Plan",
    "Revision",
    "Rules",
    "State",
    "Vehicle",
    "Violation",
    "__version__",
    "check",
    "front",
    "plan",
    "revise",
]
