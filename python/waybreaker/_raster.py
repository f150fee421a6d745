"""GeoTIFFs, read by rasterio: cells and metadata items as src/geotiff reads them by GDAL."""

from __future__ import annotations

import math
import re
import zlib
from dataclasses import dataclass, field
from typing import Any, Callable, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ._core import InputError

# As in src/geotiff/raster_place.cpp.
SQUARE_TOLERANCE = 1e-3
MOST_STRETCH = 0.01

Transform = Tuple[float, float, float, float, float, float]
Part = NDArray[np.float64]
Feature = Tuple[str, str, str, str, List[Part]]
"""What surrounds the obstacles: kind, type, name, shape ("line", "area", "point"), parts of shape (n, 2) in cells."""


@dataclass(frozen=True)
class Raster:
    labels: NDArray[np.uint32]
    items: dict[str, str] = field(default_factory=dict)
    cell_size: float = 1.0
    crs: str = ""
    transform: Optional[Transform] = None
    background: List[Feature] = field(default_factory=list)

    @staticmethod
    def inflate(digits: str, most: int) -> bytes:
        """What was deflated; empty if it is no such text, or more than ``most`` bytes."""
        try:
            stream = zlib.decompressobj()
            data = stream.decompress(bytes.fromhex(digits), most)
        except (ValueError, zlib.error):
            return b""
        return data if stream.eof else b""


def _rasterio() -> Any:
    try:
        import rasterio
        import rasterio.warp
    except ImportError as error:
        raise ImportError(
            "GeoTIFF maps need rasterio: 'pip install rasterio', or on Debian 'apt install python3-rasterio'; "
            "'waybreaker map convert city.tif city.map' makes a map that needs nothing"
        ) from error
    return rasterio


def read_raster(data: bytes, name: str) -> Raster:
    """The cells of a GeoTIFF of one band of up to 32-bit integers, what it says of them, and where they lie."""
    rasterio = _rasterio()
    try:
        with rasterio.MemoryFile(data) as memory, memory.open(driver="GTiff") as file:
            cell_size, crs, transform = _place(file, name)
            items = file.tags()
            background: List[Feature] = []
            if transform:
                size = file.width, file.height
                background = _background(items.get("WAYBREAKER_BACKGROUND", ""), crs, transform, size, name)
            return Raster(_labels(file, name), items, cell_size, crs, transform, background)
    except (rasterio.errors.RasterioError, rasterio.errors.RasterioIOError) as error:
        raise InputError(f"{name}: is no GeoTIFF map, or damaged: {error}") from error


def _labels(file: Any, name: str) -> NDArray[np.uint32]:
    from rasterio.enums import ColorInterp, MaskFlags

    transparent = file.count == 2 and file.colorinterp[1] == ColorInterp.alpha
    if file.count != 1 and not transparent:
        raise InputError(
            f"{name}: has {file.count} bands, a label map has one; pick one with 'gdal_translate -b 1'"
        )
    if file.dtypes[0] not in ("uint8", "uint16", "int16", "uint32", "int32"):
        raise InputError(f"{name}: has cells of type {file.dtypes[0]}, obstacle ids are integers of up to 32 bits")
    cells = file.read(1)
    if file.nodata is not None:
        cells[cells == file.nodata] = 0
    if MaskFlags.per_dataset in file.mask_flag_enums[0]:
        cells[file.read_masks(1) == 0] = 0
    if cells.min() < 0:
        y, x = np.argwhere(cells < 0)[0]
        raise InputError(
            f"{name}: has the negative obstacle id {cells[y, x]} at cell {x},{y}; ids start at 1, 0 is free"
        )
    return np.ascontiguousarray(cells, dtype=np.uint32)


def _place(file: Any, name: str) -> Tuple[float, str, Optional[Transform]]:
    """The side of a cell in metres, the coordinate system as well-known text, and GDAL's transform."""
    if file.transform.is_identity:
        return 1.0, "", None
    west, side, skew_x, north, skew_y, down = transform = file.transform.to_gdal()
    if not all(map(math.isfinite, transform)):
        raise InputError(f"{name}: has a georeference that is not a number; give it one with 'gdal_edit.py -a_ullr'")
    if skew_x != 0 or skew_y != 0 or side <= 0 or down >= 0:
        raise InputError(f"{name}: is rotated or not north-up; straighten it with 'gdalwarp -r near'")
    if abs(side + down) > SQUARE_TOLERANCE * side:
        raise InputError(
            f"{name}: has cells of {side:.6g} x {-down:.6g}, cells must be square; resample it with "
            "'gdalwarp -r near -tr'"
        )
    if not file.crs:
        return side, "", None
    if file.crs.is_geographic:
        raise InputError(
            f"{name}: has cells in degrees, which are not square on the ground; project it with "
            "'gdalwarp -r near -t_srs EPSG:326ZZ', ZZ being its UTM zone"
        )
    cell_size = side * file.crs.linear_units_factor[1]
    crs = file.crs.to_wkt()
    _require_true_lengths(lon_lat_of(crs, transform), cell_size, file.width, file.height, name)
    return cell_size, crs, transform


def _require_true_lengths(
    to_lon_lat: Callable[[float, float], Tuple[float, float]], cell_size: float, width: int, height: int, name: str
) -> None:
    """Refuses coordinate systems that stretch lengths, in the middle of the map or at a corner."""
    right, low = width - 1, height - 1
    for x, y in ((right / 2, low / 2), (0, 0), (right, 0), (0, low), (right, low)):
        across = _metres(to_lon_lat(x - 0.5, y), to_lon_lat(x + 0.5, y))
        along = _metres(to_lon_lat(x, y - 0.5), to_lon_lat(x, y + 0.5))
        if max(abs(across / cell_size - 1), abs(along / cell_size - 1)) > MOST_STRETCH:
            raise InputError(
                f"{name}: has cells of {cell_size:.6g} m that are {across:.3g} x {along:.3g} m on the ground; project "
                "it with 'gdalwarp -r near -t_srs EPSG:326ZZ', ZZ being its UTM zone"
            )


def _metres(a: Tuple[float, float], b: Tuple[float, float]) -> float:
    """The distance between two places in degrees that lie close together, on the ellipsoid of WGS84."""
    equator, eccentricity_squared = 6378137.0, 0.00669437999014
    latitude = math.radians((a[1] + b[1]) / 2)
    bulge = 1 - eccentricity_squared * math.sin(latitude) ** 2
    across = equator / math.sqrt(bulge)
    along = across * (1 - eccentricity_squared) / bulge
    turned = math.radians(math.remainder(b[0] - a[0], 360))
    return math.hypot(across * math.cos(latitude) * turned, along * math.radians(b[1] - a[1]))


def lon_lat_of(
    crs: str, transform: Transform
) -> Callable[[float, float], Tuple[float, float]]:
    """The function that gives longitude and latitude of a point in cell units, in which centres are integers."""
    rasterio = _rasterio()
    system = rasterio.crs.CRS.from_wkt(crs)
    degrees = rasterio.crs.CRS.from_epsg(4326)
    west, across, skew_x, north, skew_y, down = transform

    def lon_lat(x: float, y: float) -> Tuple[float, float]:
        column, row = x + 0.5, y + 0.5
        east = west + column * across + row * skew_x
        up = north + column * skew_y + row * down
        longitudes, latitudes = rasterio.warp.transform(system, degrees, [east], [up])
        return longitudes[0], latitudes[0]

    return lon_lat


SHAPES = {"MULTILINESTRING": "line", "MULTIPOLYGON": "area", "MULTIPOINT": "point"}


def _background(
    text: str, crs: str, transform: Transform, size: Tuple[int, int], name: str
) -> List[Feature]:
    """Streets, water and others, of a table of them in longitude and latitude (src/geotiff/background_item.hpp)."""
    lines = text.split("\n") if text else []
    if lines and lines[0] != "WKT;kind;class;name":
        raise InputError(f"{name}: its metadata item WAYBREAKER_BACKGROUND does not begin with WKT;kind;class;name")
    shapes: List[Tuple[str, str, str, str]] = []
    parts: List[List[Part]] = []
    for number, line in enumerate(lines[1:], start=2):
        try:
            wkt, kind, type, called = line.split(";", 3)
            shape = SHAPES[wkt[: wkt.index("(")].strip()]
            parts.append([_points(part) for part in re.findall(r"[^()]*\d[^()]*", wkt[wkt.index("(") :])])
        except (KeyError, ValueError):
            raise InputError(
                f"{name}: line {number} of its metadata item WAYBREAKER_BACKGROUND is no feature; import the map anew"
            ) from None
        shapes.append((kind, type, called, shape))
    if not shapes:
        return []
    flat = np.concatenate([part for feature in parts for part in feature])
    cells = iter(np.split(_cells(flat, crs, transform), np.cumsum([len(p) for f in parts for p in f])[:-1]))
    placed = [[next(cells) for _ in feature] for feature in parts]
    features = [(*shape, _on_map(shape[3], feature, size)) for shape, feature in zip(shapes, placed)]
    return [feature for feature in features if feature[-1]]


def _points(text: str) -> Part:
    return np.array([[float(number) for number in point.split()] for point in text.strip(" ,").split(",")])


def _on_map(shape: str, parts: List[Part], size: Tuple[int, int]) -> List[Part]:
    """Parts that have something to show; rings close by themselves."""
    def seen(part: Part) -> bool:
        return bool(np.isfinite(part).all() and (part.max(0) >= -1).all() and (part.min(0) <= size).all())

    return [part[:-1] if shape == "area" else part for part in parts if seen(part)]


def _cells(lon_lats: Part, crs: str, transform: Transform) -> Part:
    """Points in cell units of points in degrees, of a map that is north-up."""
    rasterio = _rasterio()
    system = rasterio.crs.CRS.from_wkt(crs)
    degrees = rasterio.crs.CRS.from_epsg(4326)
    east, up = rasterio.warp.transform(degrees, system, lon_lats[:, 0], lon_lats[:, 1])
    west, across, _, north, _, down = transform
    cells: Part = np.column_stack(
        (-west / across + np.array(east) / across - 0.5, -north / down + np.array(up) / down - 0.5)
    )
    return cells
