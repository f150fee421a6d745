"""Planning beside other threads, and its end by a signal."""

from __future__ import annotations

import _thread
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import waybreaker as wb

HOUR = 3600.0


def maze(seed: int, size: int) -> wb.Map:
    cells = np.random.default_rng(seed).random((size, size)) < 0.35
    cells[:3, :3] = cells[-3:, -3:] = False
    return wb.Map.from_array(cells)


def across(size: int, removals: int) -> wb.Mission:
    return wb.Mission.ground_and_air((1, 1), (size - 2, size - 2), removals=removals)


def test_two_threads_give_what_one_gives() -> None:
    maps = [maze(seed, 40) for seed in range(8)]
    mission = across(40, 2)
    alone = [wb.plan(map, mission, expansions=20000).to_json() for map in maps]
    with ThreadPoolExecutor(2) as pool:
        together = list(pool.map(lambda map: wb.plan(map, mission, expansions=20000).to_json(), maps))
    assert together == alone


def test_one_map_in_two_threads() -> None:
    map = maze(3, 40)
    missions = [across(40, removals) for removals in (0, 1, 2, 1, 0, 2)]
    with ThreadPoolExecutor(2) as pool:
        together = list(pool.map(lambda mission: wb.plan(map, mission, expansions=20000).to_json(), missions))
    assert together[0] == together[4] and together[1] == together[3] and together[2] == together[5]


# A mission that keeps its planner busy for far longer than any test lasts.
ENDLESS = maze(1, 400), across(400, 12)


def interrupted_by(raise_signal: threading.Timer) -> None:
    """Plans without an end until KeyboardInterrupt; the watchdog's limit fails the test where that does not come."""
    raise_signal.start()
    with pytest.raises(KeyboardInterrupt):
        wb.plan(*ENDLESS, seconds=HOUR)


def test_keyboard_interrupt_ends_planning() -> None:
    interrupted_by(threading.Timer(0.5, lambda: _thread.interrupt_main()))


def test_other_threads_run_meanwhile() -> None:
    ticks = 0
    done = threading.Event()

    def tick() -> None:
        nonlocal ticks
        while not done.is_set():
            ticks += 1
            if ticks == 100:
                _thread.interrupt_main()
            time.sleep(0.001)

    ticker = threading.Thread(target=tick)
    ticker.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            wb.plan(*ENDLESS, seconds=HOUR)  # ends only if the other thread has counted to a hundred
    finally:
        done.set()
        ticker.join()
    assert ticks >= 100


def test_planning_goes_on_after_an_interrupt(wall_map: wb.Map, through_the_wall: wb.Mission) -> None:
    interrupted_by(threading.Timer(0.1, lambda: _thread.interrupt_main()))
    assert wb.plan(wall_map, through_the_wall).solved


def test_errors_leave_other_threads_alone(wall_map: wb.Map, through_the_wall: wb.Mission) -> None:
    with ThreadPoolExecutor(2) as pool:
        bad = pool.submit(wb.plan, wall_map, wb.Mission.ground_and_air((20, 4), (36, 4)))
        good = pool.submit(wb.plan, wall_map, through_the_wall)
        with pytest.raises(wb.InputError):
            bad.result()
        assert good.result().solved
