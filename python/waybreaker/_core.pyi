from typing import Callable, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

__version__: str

class InputError(ValueError): ...

class Map:
    @staticmethod
    def from_movingai(
        bytes: bytes, name: str, digest: str, cell_size: Optional[float], connectivity: int
    ) -> Map: ...
    @staticmethod
    def from_labels(
        labels: NDArray[np.uint32],
        attributes: Sequence[Tuple[int, Tuple[bool, int, float, float, str]]],
        name: str,
        digest_of: Callable[[bytes], str],
        cell_size: Optional[float],
    ) -> Map: ...
    @staticmethod
    def from_raster(
        labels: NDArray[np.uint32],
        items: Mapping[str, str],
        cell_size: float,
        crs: str,
        transform: Optional[Sequence[float]],
        inflate: Callable[[str, int], bytes],
        background: Sequence[Tuple[str, str, str, str, Sequence[NDArray[np.float64]]]],
        name: str,
        digest: str,
        connectivity: int,
    ) -> Map: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def source(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def attribution(self) -> str: ...
    @property
    def digest(self) -> str: ...
    @property
    def cell_size(self) -> Optional[float]: ...
    @property
    def labels(self) -> NDArray[np.uint32]: ...
    @property
    def obstacles(
        self,
    ) -> List[Tuple[int, int, Tuple[int, int, int, int], bool, int, float, float, str]]: ...

class Plan:
    def json(self, timing: bool) -> bytes: ...
    def svg(self) -> str: ...
    def geojson(self, to_lon_lat: Callable[[float, float], Tuple[float, float]]) -> str: ...

def plan(map: Map, mission: str, threads: int) -> Plan: ...
def front(map: Map, mission: str, threads: int) -> List[Plan]: ...
def check(map: Map, plan: bytes, tolerance: float, ignore_digest: bool) -> str: ...
