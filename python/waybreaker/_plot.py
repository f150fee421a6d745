"""Pictures of plans by matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._plan import Plan

BLOCKED = (0.80, 0.80, 0.78)
REMOVED = (0.94, 0.62, 0.46)
FREE = (1.0, 1.0, 1.0)
GROUND = "#1f5fa8"
AIR = "#b3421a"


def draw(plan: Plan, ax: Optional[Axes]) -> Axes:
    """The map in grey, what is removed in orange, vehicles in blue, aircraft in red and dashed, breaches as crosses."""
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError(
            "plot() needs matplotlib: 'pip install matplotlib', or on Debian 'apt install python3-matplotlib'; "
            "to_svg() does without"
        ) from error
    if ax is None:
        _, ax = pyplot.subplots()
    labels = plan._core.map.labels  # with what was found on the way
    picture = np.where((labels != 0)[..., np.newaxis], BLOCKED, FREE)
    picture[np.isin(labels, [breach.obstacle for breach in plan.removed])] = REMOVED
    ax.imshow(picture, interpolation="nearest")
    for agent in plan.agents:
        flies = agent.kind == "air"
        ax.plot(*agent.path.T, color=AIR if flies else GROUND, linestyle="--" if flies else "-", label=agent.id)
    if plan.removed:
        x, y = zip(*(breach.at for breach in plan.removed))
        ax.plot(x, y, "x", color=AIR, label="breach")
    if plan.agents:
        ax.legend()
    ax.set_title(repr(plan).strip("<>").removeprefix("waybreaker.Plan: "))
    return ax
