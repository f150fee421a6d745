"""Maps: grids of cells, and the obstacles that they are blocked by."""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Literal, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Transform = Tuple[float, float, float, float, float, float]
"""GDAL's affine transform, from columns and rows of cell corners to the map's coordinates."""


@dataclass(frozen=True)
class Obstacle:
    """Blocked cells that are removed together.

    ``id`` counts from 1 in the order of a row-by-row scan. ``bounds`` are the first and last column and row that it has
    cells in: left, top, right, bottom. ``weight`` is what its removal counts for against a budget, ``breach_time`` how
    long its breach takes beside what a mission says, in units of time. ``source_id`` (0: unknown) and ``name`` (empty:
    unknown) say who it is in the source, such as its OpenStreetMap id.
    """

    id: int
    cells: int
    bounds: Tuple[int, int, int, int]
    destructible: bool
    source_id: int
    weight: float
    breach_time: float
    name: str


@dataclass(frozen=True)
class Attributes:
    """What :meth:`Map.from_labels` can know of a label; the members are those of :class:`Obstacle`."""

    destructible: bool = True
    source_id: int = 0
    weight: float = 1.0
    breach_time: float = 0.0
    name: str = ""


@dataclass(frozen=True)
class MapEdit:
    """A change of a map (:meth:`Map.with_edits`): :meth:`remove`, :meth:`add`, :meth:`extend` and :meth:`free` make one."""

    kind: Literal["remove", "add", "extend", "free"]
    obstacle: int = 0
    cells: Tuple[Tuple[int, int], ...] = ()
    attributes: Attributes = Attributes()

    @staticmethod
    def remove(obstacle: int) -> MapEdit:
        """All cells of the obstacle are free then, and it is gone: it keeps its id, and has no cells."""
        return MapEdit("remove", obstacle)

    @staticmethod
    def add(cells: Iterable[Tuple[int, int]], attributes: Attributes = Attributes()) -> MapEdit:
        """A new obstacle has these cells, at least one, whatever they were. Its id is the one after the last."""
        return MapEdit("add", 0, _cells(cells), attributes)

    @staticmethod
    def extend(obstacle: int, cells: Iterable[Tuple[int, int]]) -> MapEdit:
        """The obstacle has these cells as well, whatever they were."""
        return MapEdit("extend", obstacle, _cells(cells))

    @staticmethod
    def free(cells: Iterable[Tuple[int, int]]) -> MapEdit:
        """These cells are free. An obstacle that has lost all its cells is gone."""
        return MapEdit("free", 0, _cells(cells))


@dataclass(frozen=True)
class Place:
    """Where a map lies on earth: its coordinate system as well-known text, and the transform of its cells."""

    crs: str
    transform: Transform


class Map:
    """A grid of ``width`` x ``height`` cells and its obstacles. It never changes; threads may share it.

    Made by :meth:`open`, :meth:`from_array`, :meth:`from_labels` or :meth:`from_movingai`.
    """

    def __init__(self, core: _core.Map, place: Optional[Place] = None) -> None:
        self._core = core
        self._place = place

    @staticmethod
    def from_movingai(
        text: Union[str, bytes],
        name: str = "map",
        *,
        cell_size: Optional[float] = None,
        connectivity: int = 4,
    ) -> Map:
        """The map of a MovingAI file's text: ``.``, ``G``, ``S`` and ``E`` are free.

        ``name`` is how plan files and errors call it. ``cell_size`` is the side of a cell in metres, None if unknown.
        Obstacles are the sets of blocked cells that are connected by 4 or 8 neighbours. Raises InputError, with the
        line, if the text is no such map.
        """
        data = text.encode() if isinstance(text, str) else text
        return Map(_core.Map.from_movingai(data, name, _digest(data), cell_size, connectivity))

    @staticmethod
    def from_array(
        blocked: ArrayLike,
        name: str = "array",
        *,
        cell_size: Optional[float] = None,
        connectivity: int = 4,
    ) -> Map:
        """The map of an array of shape (height, width), bool or integers: what is not 0 is blocked.

        It equals that of the MovingAI file with the same cells; the rest as for :meth:`from_movingai`.
        """
        cells = np.asarray(blocked)
        if cells.ndim != 2 or cells.size == 0 or cells.dtype.kind not in "biu":
            raise _core.InputError(
                "blocked must be an array of height x width, of bool or integers; "
                f"this one has shape {cells.shape} and type {cells.dtype}"
            )
        return Map.from_movingai(_movingai(cells != 0), name, cell_size=cell_size, connectivity=connectivity)

    @staticmethod
    def from_labels(
        labels: ArrayLike,
        attributes: Optional[Mapping[int, Attributes]] = None,
        name: str = "labels",
        *,
        cell_size: Optional[float] = None,
    ) -> Map:
        """The map of an array of shape (height, width) of labels, 0 to 2**32 - 1: 0 is free, each other an obstacle.

        Obstacles are numbered anew, in scan order. ``attributes`` says what is known of a label. Raises InputError if
        a label, weight or time is out of range.
        """
        cells = np.asarray(labels)
        if cells.ndim != 2 or cells.size == 0 or cells.dtype.kind not in "iu":
            raise _core.InputError(
                "labels must be an array of height x width, of integers; "
                f"this one has shape {cells.shape} and type {cells.dtype}"
            )
        if cells.min() < 0 or cells.max() >= 2**32:
            raise _core.InputError("labels must be from 0 to 4294967295")
        exact = np.ascontiguousarray(cells, dtype=np.uint32)
        known = dict(attributes or {})
        present = np.union1d(exact, [0])
        ranks = {int(label): rank for rank, label in enumerate(present)}
        strange = sorted(set(known) - (set(ranks) - {0}))
        if strange:
            raise _core.InputError(f"attributes has label {strange[0]}, which no cell has")
        dense = np.searchsorted(present, exact).astype(np.uint32)
        listed = [(ranks[label], _described(attributes)) for label, attributes in known.items()]
        return Map(_core.Map.from_labels(dense, listed, name, cell_size))

    @staticmethod
    def open(path: Union[str, os.PathLike[str]], *, connectivity: int = 4) -> Map:
        """The map in a file: a MovingAI map, or a GeoTIFF of labels or a mask, which needs rasterio.

        Raises InputError on other files, and where the cells of a GeoTIFF are not square on the ground; ImportError
        without rasterio.
        """
        data = Path(path).read_bytes()
        name = str(path)
        if data[:4] in (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"):
            from ._raster import read_raster

            raster = read_raster(data, name)
            place = Place(raster.crs, raster.transform) if raster.transform else None
            core = _core.Map.from_raster(
                raster.labels,
                raster.items,
                raster.cell_size,
                raster.crs,
                raster.transform,
                raster.inflate,
                raster.background,
                Path(path).name,
                _digest(data),
                connectivity,
            )
            return Map(core, place)
        if not data.removeprefix(b"\xef\xbb\xbf").startswith(b"type"):
            raise _core.InputError(
                f"{name}: is neither a MovingAI map nor a GeoTIFF; "
                "'waybreaker map convert' makes one of the other formats that the command reads"
            )
        return Map.from_movingai(data, Path(path).name, connectivity=connectivity)

    @property
    def width(self) -> int:
        """Number of columns."""
        return self._core.width

    @property
    def height(self) -> int:
        """Number of rows."""
        return self._core.height

    @property
    def name(self) -> str:
        """How plan files call it: the name of its file, without folders."""
        return self._core.source

    @property
    def cell_size(self) -> Optional[float]:
        """The side of a cell in metres; None if unknown."""
        return self._core.cell_size

    @property
    def digest(self) -> str:
        """``sha256:...`` of the file's bytes; of a map from labels, of these and what is known of its obstacles."""
        return self._core.digest

    @property
    def title(self) -> str:
        """What people call it; empty if its file does not say."""
        return self._core.title

    @property
    def attribution(self) -> str:
        """Whom its data is from; empty if its file does not say."""
        return self._core.attribution

    @property
    def place(self) -> Optional[Place]:
        """Where it lies on earth, if its file says so."""
        return self._place

    @property
    def labels(self) -> NDArray[np.uint32]:
        """Read-only, of shape (height, width): the id of the obstacle at each cell, 0 where it is free. Not copied."""
        return self._core.labels

    @property
    def blocked(self) -> NDArray[np.bool_]:
        """Of shape (height, width): whether each cell is blocked. A new array."""
        blocked: NDArray[np.bool_] = self.labels != 0
        return blocked

    @property
    def obstacles(self) -> list[Obstacle]:
        """All obstacles: ``obstacles[0]`` has id 1."""
        return [Obstacle(*obstacle) for obstacle in self._core.obstacles]

    def with_edits(self, edits: Iterable[MapEdit]) -> Map:
        """The map with its obstacles changed, one edit after the other; this one stays as it is.

        All other obstacles keep their ids. Rows that stay the same are shared. The digest is made of that of this map
        and of the edits. Raises InputError for cells off the map, for obstacles that are not there, and for attributes out
        of range.

        >>> level = Map.from_labels([[0, 7, 0], [0, 7, 9]])
        >>> level.with_edits([MapEdit.remove(1), MapEdit.add([(0, 1)])]).labels.tolist()
        [[0, 0, 0], [3, 0, 2]]
        """
        kinds = ("remove", "add", "extend", "free")
        listed = [
            (kinds.index(edit.kind), edit.obstacle, edit.cells, _described(edit.attributes)) for edit in edits
        ]
        return Map(self._core.with_edits(listed), self._place)

    def to_movingai(self) -> bytes:
        """Its cells as a MovingAI file, with nothing that else is known of it."""
        return _movingai(self.blocked)

    def to_lon_lat(self) -> Callable[[float, float], Tuple[float, float]]:
        """The function that gives longitude and latitude (WGS84, degrees) of a point in cells.

        Raises InputError if the map does not say where it lies, ImportError without rasterio.
        """
        if self._place is None:
            raise _core.InputError(f"{self.name}: the map does not say where it lies on earth")
        from ._raster import lon_lat_of

        return lon_lat_of(self._place.crs, self._place.transform)

    def __repr__(self) -> str:
        size = f", {self.cell_size:g} m a cell" if self.cell_size else ""
        return f"<waybreaker.Map {self.name!r}: {self.width} x {self.height} cells{size}>"

    def __reduce__(self) -> Any:
        raise TypeError("a waybreaker.Map cannot be pickled; open its file again")


def _described(a: Attributes) -> Tuple[bool, int, float, float, str]:
    return a.destructible, a.source_id, a.weight, a.breach_time, a.name


def _cells(cells: Iterable[Tuple[int, int]]) -> Tuple[Tuple[int, int], ...]:
    return tuple((int(x), int(y)) for x, y in cells)


def _digest(data: bytes) -> str:
    return "sha256:" + hashlib.sha256(data).hexdigest()


def _movingai(blocked: NDArray[np.bool_]) -> bytes:
    height, width = blocked.shape
    rows = np.full((height, width + 1), ord("\n"), dtype=np.uint8)
    rows[:, :width] = np.where(blocked, ord("@"), ord("."))
    return f"type octile\nheight {height}\nwidth {width}\nmap\n".encode() + rows.tobytes()
