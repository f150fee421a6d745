"""A map, and the features of its source around it in its own coordinates. For scripts/judge-ground."""
import math

import numpy as np
from osgeo import gdal, ogr, osr

from judged_cut import Evidence, closed, parts
from judged_source import moved

SCALE = 4  # points along a cell's side
EDGE = 25  # metres from the edge of the data, where coastlines break off


def profile_of(path):
    """Whom a map was made for; None of those that do not say it."""
    return gdal.Open(str(path)).GetMetadataItem("WAYBREAKER_PROFILE")


def polygon_around(box):
    west, south, east, north = box
    return ogr.CreateGeometryFromWkt(
        f"POLYGON(({west} {south},{east} {south},{east} {north},{west} {north},{west} {south}))")


class Ground:
    def __init__(self, path, source):
        data = gdal.Open(str(path))
        self.labels = data.ReadAsArray()
        self.transform = data.GetGeoTransform()
        self.cell = self.transform[1]
        self.rows, self.columns = self.labels.shape
        listed = data.GetMetadataItem("WAYBREAKER_OBSTACLES").split(",")
        self.lasting = np.array([False] + [text.startswith("!") for text in listed])[self.labels]
        self.utm = osr.SpatialReference(data.GetProjection())
        wgs84 = osr.SpatialReference()
        wgs84.ImportFromEPSG(4326)
        for system in (self.utm, wgs84):
            system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        west, north = self.transform[0], self.transform[3]
        east, south = west + self.columns * self.cell, north - self.rows * self.cell
        self.bounds = (west, east, south, north)
        corners = [osr.CoordinateTransformation(self.utm, wgs84).TransformPoint(x, y)
                   for x in (west - 60, east + 60) for y in (south - 60, north + 60)]
        box = [f(c[i] for c in corners) for i in (0, 1) for f in (min, max)]
        forth = osr.CoordinateTransformation(wgs84, self.utm)

        def near(shape):
            around = shape.GetEnvelope()
            return around[0] <= box[1] and around[1] >= box[0] and around[2] <= box[3] and around[3] >= box[2]

        self.near = [(f, moved(f.shape, forth)) for f in source.features if near(f.shape)]
        self.data = polygon_around(source.box)
        self.data.Segmentize(0.001)
        self.data.Transform(forth)
        self.known = self.painted([self.data.Buffer(-EDGE)])
        self.undecided = []  # waters whose wet side nobody can tell
        self.cut_waters = self.closed_waters(source, forth)

    def closed_waters(self, source, forth):
        if not source.cut_waters:
            return []
        window = polygon_around([self.bounds[i] for i in (0, 2, 1, 3)])
        hull = source.hull()
        edges = [self.data, moved(hull, forth)] if hull else [self.data]
        evidence = Evidence(source.features, forth)
        waters = []
        for cut in source.cut_waters:
            lines = [moved(line, forth) for line in cut.lines]
            water = next((w for w in (closed(lines, edge, evidence) for edge in edges) if w), None)
            if water is None and any(line.Intersects(window) for line in lines):
                self.undecided.append(cut.number)
            if water is not None and water.Intersects(window):
                waters.append(water)
        return waters

    def shapes(self, *kinds):
        return [(f, shape) for f, shape in self.near if f.kind in kinds]

    def painted(self, shapes):
        """Which points lie within one of the shapes."""
        store = ogr.GetDriverByName("Memory").CreateDataSource("")
        layer = store.CreateLayer("", self.utm, ogr.wkbUnknown)
        for shape in shapes:
            feature = ogr.Feature(layer.GetLayerDefn())
            feature.SetGeometry(shape)
            layer.CreateFeature(feature)
        raster = self.raster()
        gdal.RasterizeLayer(raster, [1], layer, burn_values=[1])
        return raster.ReadAsArray().astype(bool)

    def raster(self, kind=gdal.GDT_Byte):
        raster = gdal.GetDriverByName("MEM").Create("", self.columns * SCALE, self.rows * SCALE, 1, kind)
        west, _, _, north = self.bounds
        raster.SetGeoTransform((west, self.cell / SCALE, 0, north, 0, -self.cell / SCALE))
        raster.SetProjection(self.utm.ExportToWkt())
        return raster

    def metres_to(self, marked):
        """From each point to the nearest marked one."""
        near, far = self.raster(), self.raster(gdal.GDT_Float32)
        near.GetRasterBand(1).WriteArray(marked.astype(np.uint8))
        gdal.ComputeProximity(near.GetRasterBand(1), far.GetRasterBand(1),
                              ["VALUES=1", "DISTUNITS=PIXEL", "NODATA=1e9"])
        return far.ReadAsArray() * (self.cell / SCALE)

    def fine(self, cells):
        return np.kron(cells, np.ones((SCALE, SCALE), bool))

    def strip(self, f, shape, least=0.0):
        return shape.Buffer(max(f.width, least) / 2, 8) if f.line else shape

    def waters(self):
        """Areas, and strips of rivers where no area shows them."""
        areas = [shape for f, shape in self.shapes("water") if not f.line] + self.cut_waters
        strips = []
        for f, shape in self.shapes("water"):
            if not f.line:
                continue
            for area in areas if "width" not in f.tags else []:
                if shape.Intersects(area):
                    shape = shape.Difference(area)
            strips += [self.strip(f, part, self.cell) for part in parts(shape) if part.Length() >= f.width]
        return areas + strips

    def sea(self):
        """By the nearest coastline: the water lies to its right."""
        ends = []
        for _, shape in self.shapes("coast"):
            points = np.array(shape.GetPoints())[:, :2]
            ends.append(np.hstack([points[:-1], points[1:]]))
        blank = np.zeros((self.rows, self.columns), bool)
        if not ends:
            return blank
        a = np.vstack(ends)
        a = a[np.hypot(a[:, 2] - a[:, 0], a[:, 3] - a[:, 1]) > 0]
        west, _, _, north = self.bounds
        x = west + (np.arange(self.columns) + 0.5) * self.cell
        half = self.cell / math.sqrt(2)
        for row in range(self.rows):
            y = north - (row + 0.5) * self.cell
            dx, dy = a[:, 2] - a[:, 0], a[:, 3] - a[:, 1]
            px, py = x[:, None] - a[:, 0], y - a[:, 1]
            t = np.clip((px * dx + py * dy) / (dx * dx + dy * dy), 0, 1)
            distance = np.hypot(px - t * dx, py - t * dy)
            side = (dx * py - dy * px) / np.hypot(dx, dy)  # above 0: to the left
            nearest = distance.min(axis=1)
            among = np.where(distance <= nearest[:, None] + 1e-6, np.abs(side), -1)
            left = side[np.arange(len(x)), among.argmax(axis=1)]
            blank[row] = (left < 0) & (nearest > half)
        return blank

    def at(self, raster, x, y):
        scale = raster.shape[0] // self.rows
        columns = ((x - self.bounds[0]) / self.cell * scale).astype(int)
        rows = ((self.bounds[3] - y) / self.cell * scale).astype(int)
        return raster[np.clip(rows, 0, raster.shape[0] - 1), np.clip(columns, 0, raster.shape[1] - 1)]

    def inside(self, x, y):
        west, east, south, north = self.bounds
        return (x > west) & (x < east) & (y > south) & (y < north)


def points_along(line, step):
    """Points of a line, as arrays of x and y."""
    points = np.array(line.GetPoints())[:, :2]
    xs, ys = [], []
    for a, b in zip(points[:-1], points[1:]):
        count = max(int(math.hypot(*(b - a)) / step), 1)
        t = (np.arange(count) + 0.5) / count
        xs.append(a[0] + t * (b[0] - a[0]))
        ys.append(a[1] + t * (b[1] - a[1]))
    return np.concatenate(xs), np.concatenate(ys)


def shrunk(raster, points):
    """Without what lies within so many points of the edge, along rows, columns and diagonals."""
    for _ in range(points):
        padded = np.pad(raster, 1, constant_values=True)
        raster = (padded[1:-1, 1:-1] & padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] & padded[1:-1, 2:])
    return raster
