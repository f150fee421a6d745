"""Maps of text, arrays, labels and files."""

from __future__ import annotations

import pickle
import sys
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from conftest import DATA
from numpy.typing import NDArray

import waybreaker as wb


def test_array_and_text_are_one_map(wall: NDArray[np.bool_]) -> None:
    map = wb.Map.from_array(wall)
    assert (map.width, map.height) == (40, 20)
    assert np.array_equal(map.blocked, wall)
    assert map.labels.dtype == np.uint32 and map.labels.max() == 1
    same = wb.Map.from_movingai(map.to_movingai())
    assert same.digest == map.digest
    assert wb.Map.from_array(wall.astype(np.uint8) * 7).digest == map.digest
    assert wb.Map.from_array(np.asfortranarray(wall)).digest == map.digest


def test_labels_outlive_their_map_and_cannot_be_written(wall: NDArray[np.bool_]) -> None:
    labels = wb.Map.from_array(wall).labels
    assert labels.sum() == wall.sum()
    with pytest.raises(ValueError):
        labels[0, 0] = 1


def test_obstacles(wall: NDArray[np.bool_]) -> None:
    wall[5, 30] = True
    first, second = wb.Map.from_array(wall).obstacles
    assert (first.id, first.cells, first.bounds) == (1, 18, (20, 0, 20, 17))
    assert (second.id, second.cells, second.bounds, second.destructible) == (2, 1, (30, 5, 30, 5), True)


def test_connectivity() -> None:
    cells = np.eye(5, dtype=bool)
    assert len(wb.Map.from_array(cells).obstacles) == 5
    assert len(wb.Map.from_array(cells, connectivity=8).obstacles) == 1
    with pytest.raises(wb.InputError, match="4 or 8"):
        wb.Map.from_array(cells, connectivity=6)


def test_labels_are_numbered_anew_and_described() -> None:
    labels = np.array([[0, 4_000_000_000, 0, 7], [0, 0, 0, 7], [3, 0, 0, 0]])
    attributes = {7: wb.Attributes(destructible=False, name="water"), 3: wb.Attributes(weight=2.5, breach_time=4)}
    map = wb.Map.from_labels(labels, attributes, cell_size=2)
    assert map.labels.tolist() == [[0, 1, 0, 2], [0, 0, 0, 2], [3, 0, 0, 0]]
    plain, water, heavy = map.obstacles
    assert plain.destructible and not water.destructible
    assert (water.name, heavy.weight, heavy.breach_time) == ("water", 2.5, 4.0)
    assert map.cell_size == 2.0


def test_equal_label_maps_have_equal_digests() -> None:
    digest = wb.Map.from_labels([[0, 7], [3, 3]]).digest
    assert wb.Map.from_labels([[0, 1], [9, 9]]).digest == digest
    assert wb.Map.from_labels([[0, 1], [1, 1]]).digest != digest
    assert wb.Map.from_labels([[0, 7], [3, 3]], {7: wb.Attributes(weight=2)}).digest != digest


def test_one_label_of_two_pieces_is_one_obstacle() -> None:
    assert len(wb.Map.from_labels([[1, 0, 1]]).obstacles) == 1


@pytest.mark.parametrize(
    "labels", [[[-1, 0]], [[2**32, 0]], [[0.5, 0.0]], [1, 2], np.zeros((0, 3), dtype=int), [[[1]]]]
)
def test_bad_labels(labels: Any) -> None:
    with pytest.raises(ValueError, match="labels must be"):
        wb.Map.from_labels(labels)


def test_attributes_of_no_label() -> None:
    with pytest.raises(wb.InputError, match="label 9, which no cell has"):
        wb.Map.from_labels([[1, 0]], {9: wb.Attributes()})
    with pytest.raises(wb.InputError, match="weight"):
        wb.Map.from_labels([[1, 0]], {1: wb.Attributes(weight=-1)})


@pytest.mark.parametrize("blocked", [[1, 0], [["a"]], np.zeros((2, 2)), np.zeros((0, 2), dtype=bool)])
def test_bad_arrays(blocked: Any) -> None:
    with pytest.raises(wb.InputError, match="blocked must be an array of height x width"):
        wb.Map.from_array(blocked)


def test_too_large() -> None:
    with pytest.raises(wb.InputError):
        wb.Map.from_array(np.zeros((1, 40000), dtype=bool))
    with pytest.raises(wb.InputError):
        wb.Map.from_labels(np.zeros((1, 40000), dtype=np.uint32))


def test_cell_size() -> None:
    assert wb.Map.from_array([[0]]).cell_size is None
    for size in (0, -1, float("nan"), float("inf"), 1e9):
        with pytest.raises(wb.InputError, match="cell_size"):
            wb.Map.from_array([[0]], cell_size=size)


def test_text_that_is_no_map() -> None:
    with pytest.raises(wb.InputError, match="^town.map:"):
        wb.Map.from_movingai("type octile\nheight 2\nwidth 2\nmap\n..\n.", "town.map")
    with pytest.raises(wb.InputError):
        wb.Map.from_movingai("")


def test_other_files(tmp_path: Path) -> None:
    file = tmp_path / "town.png"
    file.write_bytes(b"\x89PNG")
    with pytest.raises(wb.InputError, match="waybreaker map convert"):
        wb.Map.open(file)
    with pytest.raises(FileNotFoundError):
        wb.Map.open(tmp_path / "none.map")


def test_no_pickle(wall_map: wb.Map) -> None:
    with pytest.raises(TypeError, match="open its file again"):
        pickle.dumps(wall_map)


def test_city() -> None:
    map = wb.Map.open(DATA / "monaco.tif")
    assert map.cell_size and map.place and "OpenStreetMap" in map.attribution
    assert map.title.startswith("monaco")
    longitude, latitude = map.to_lon_lat()(map.width / 2, map.height / 2)
    assert 7.3 < longitude < 7.5 and 43.7 < latitude < 43.8
    assert any(not obstacle.destructible for obstacle in map.obstacles)
    assert any(obstacle.name for obstacle in map.obstacles)
    assert len(map.obstacles) == map.labels.max()


def test_city_without_rasterio(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in [name for name in sys.modules if name.split(".")[0] == "rasterio"]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(cast("dict[str, Any]", sys.modules), "rasterio", None)
    with pytest.raises(ImportError, match="python3-rasterio"):
        wb.Map.open(DATA / "monaco.tif")


def test_map_without_a_place(wall_map: wb.Map) -> None:
    with pytest.raises(wb.InputError, match="where it lies"):
        wall_map.to_lon_lat()


def test_repr(wall: NDArray[np.bool_]) -> None:
    assert repr(wb.Map.from_array(wall, "town", cell_size=2.5)) == (
        "<waybreaker.Map 'town': 40 x 20 cells, 2.5 m a cell>"
    )
