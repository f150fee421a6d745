"""GeoTIFFs by other programs, as rasterio writes them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import rasterio
from rasterio.transform import from_origin

import waybreaker as wb

UTM = "EPSG:32633"


def written(path: Path, cells: Any, **profile: Any) -> Path:
    cells = np.asarray(cells)
    bands = cells if cells.ndim == 3 else cells[np.newaxis]
    settings = {"crs": UTM, "transform": from_origin(390000, 5820000, 2, 2), **profile}
    count, height, width = bands.shape
    with rasterio.open(path, "w", "GTiff", width, height, count, dtype=bands.dtype, **settings) as file:
        file.write(bands)
    return path


CELLS = np.array([[0, 5, 5], [0, 0, 9]], dtype=np.uint16)


def test_labels(tmp_path: Path) -> None:
    map = wb.Map.open(written(tmp_path / "a.tif", CELLS))
    assert map.labels.tolist() == [[0, 1, 1], [0, 0, 2]]
    assert (map.name, map.cell_size) == ("a.tif", 2.0)
    assert map.place and map.place.transform == (390000, 2, 0, 5820000, 0, -2)


def test_mask_is_its_connected_sets(tmp_path: Path) -> None:
    cells = np.array([[255, 0, 255], [0, 255, 0]], dtype=np.uint8)
    path = written(tmp_path / "a.tif", cells)
    assert len(wb.Map.open(path).obstacles) == 3
    assert len(wb.Map.open(path, connectivity=8).obstacles) == 1


def test_no_data_is_free(tmp_path: Path) -> None:
    map = wb.Map.open(written(tmp_path / "a.tif", CELLS, nodata=9))
    assert map.blocked.sum() == 2


def test_transparent_is_free(tmp_path: Path) -> None:
    alpha = np.array([[255, 255, 0], [255, 255, 255]], dtype=np.uint16)
    path = written(tmp_path / "a.tif", np.stack([CELLS, alpha]), photometric="minisblack", alpha="yes")
    assert wb.Map.open(path).blocked.sum() == 2


def test_feet(tmp_path: Path) -> None:
    path = written(tmp_path / "a.tif", CELLS, crs="EPSG:2263", transform=from_origin(980000, 200000, 10, 10))
    assert wb.Map.open(path).cell_size == pytest.approx(3.048, abs=1e-5)


def test_without_a_place(tmp_path: Path) -> None:
    with pytest.warns(rasterio.errors.NotGeoreferencedWarning):
        path = written(tmp_path / "a.tif", CELLS, crs=None, transform=None)
    with pytest.warns(rasterio.errors.NotGeoreferencedWarning):
        map = wb.Map.open(path)
    assert map.place is None and map.cell_size is None


def test_metres_without_a_coordinate_system(tmp_path: Path) -> None:
    map = wb.Map.open(written(tmp_path / "a.tif", CELLS, crs=None))
    assert map.place is None and map.cell_size == 2.0


@pytest.mark.parametrize(
    "error, cells, profile",
    [
        ("2 bands", np.stack([CELLS, CELLS]), {}),
        ("type float32", CELLS.astype(np.float32), {}),
        ("negative obstacle id -3 at cell 2,1", np.array([[0, 0, 1], [0, 0, -3]], dtype=np.int16), {}),
        ("in degrees", CELLS, {"crs": "EPSG:4326", "transform": from_origin(13, 52, 1e-4, 1e-4)}),
        ("on the ground", CELLS, {"crs": "EPSG:3857", "transform": from_origin(1_500_000, 6_800_000, 2, 2)}),
        ("must be square", CELLS, {"transform": from_origin(390000, 5820000, 2, 3)}),
        ("not north-up", CELLS, {"transform": rasterio.Affine(2, 0.5, 390000, 0, -2, 5820000)}),
    ],
)
def test_refused(error: str, cells: Any, profile: dict[str, Any], tmp_path: Path) -> None:
    path = written(tmp_path / "a.tif", cells, **profile)
    with pytest.raises(wb.InputError, match=error):
        wb.Map.open(path)


def test_damaged(tmp_path: Path) -> None:
    path = written(tmp_path / "a.tif", np.arange(10_000, dtype=np.uint16).reshape(100, 100))
    path.write_bytes(path.read_bytes()[:5000])
    with pytest.raises(wb.InputError, match="damaged"):
        wb.Map.open(path)
    path.write_bytes(b"II*\0")
    with pytest.raises(wb.InputError, match="damaged"):
        wb.Map.open(path)


def test_metadata_that_cannot_be_understood(tmp_path: Path) -> None:
    path = written(tmp_path / "a.tif", CELLS)
    with rasterio.open(path, "r+") as file:
        file.update_tags(WAYBREAKER_NAMES="five Town hall")
    with pytest.raises(wb.InputError, match="WAYBREAKER_NAMES is no obstacle's number"):
        wb.Map.open(path)
