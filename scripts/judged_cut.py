"""Waters that the edge of the data cuts: banks and edge make faces, streets and rivers tell which are wet. For
scripts/judge-ground."""
from collections import Counter

from osgeo import ogr

from judged_rules import has, tunnel

REACH = 200  # metres from its edge that banks end before it, and a share of the shorter side of small data
SHARE = 0.15
TOLD = 0.95  # of the banks that must have water on one side and none on the other


def parts(shape):
    return [shape.GetGeometryRef(i).Clone() for i in range(shape.GetGeometryCount())] or [shape]


def together(shapes, kind=ogr.wkbMultiLineString):
    all_of_them = ogr.Geometry(kind)
    for shape in shapes:
        all_of_them.AddGeometry(shape)
    return all_of_them


def middles(features, projection):
    """Points in the middle of the segments of lines."""
    points = ogr.Geometry(ogr.wkbMultiPoint)
    for feature in features:
        places = feature.shape.GetPoints() or []
        for a, b in zip(places[:-1], places[1:]):
            point = ogr.Geometry(ogr.wkbPoint)
            point.AddPoint_2D((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
            points.AddGeometry(point)
    points.Transform(projection)
    return points


class Evidence:
    """What tells wet from dry."""

    def __init__(self, features, projection):
        lines = [f for f in features if f.line]
        self.streets = middles([f for f in lines if f.kind == "way" and not has(f.tags, "bridge")
                                and not has(f.tags, "tunnel")], projection)
        self.rivers = middles([f for f in lines if f.tags.get("waterway") in ("river", "canal")
                               and not tunnel(f.tags)], projection)


def extended(lines, edge):
    """Loose ends within the data, taken to its edge; None if one ends in the midst."""
    box = edge.GetEnvelope()
    reach = min(REACH, SHARE * min(box[1] - box[0], box[3] - box[2]))
    ends = Counter(line.GetPoint_2D(i) for line in lines for i in (0, line.GetPointCount() - 1))
    added = []
    for (x, y), count in ends.items():
        point = ogr.CreateGeometryFromWkt(f"POINT({x} {y})")
        if count % 2 == 0 or not edge.Contains(point):
            continue
        ring = edge.GetGeometryRef(0)
        if point.Distance(ring) > reach:
            return None
        where = min((foot(x, y, *ring.GetPoint_2D(i), *ring.GetPoint_2D(i + 1))
                     for i in range(ring.GetPointCount() - 1)), key=lambda at: (at[0] - x) ** 2 + (at[1] - y) ** 2)
        line = ogr.Geometry(ogr.wkbLineString)
        line.AddPoint_2D(x, y)
        line.AddPoint_2D(where[0] + 0.01 * (where[0] - x), where[1] + 0.01 * (where[1] - y))
        added.append(line)
    return added


def foot(x, y, ax, ay, bx, by):
    """The point of a segment next to another."""
    square = (bx - ax) ** 2 + (by - ay) ** 2
    t = min(max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / square, 0), 1) if square else 0
    return ax + t * (bx - ax), ay + t * (by - ay)


def closed(lines, edge, evidence):
    """The water between banks and edge, without what lies next to the lines that were only guessed; None if nobody can
    tell which side is wet."""
    added = extended(lines, edge)
    if not lines or added is None:
        return None
    ring = ogr.ForceToLineString(edge.GetGeometryRef(0).Clone())
    faces = together(lines + added).Union(ring).Polygonize()
    faces = [face for face in parts(faces)
             if face.GetGeometryName() == "POLYGON" and edge.Contains(face.PointOnSurface())]
    banks = together(lines).Intersection(edge)

    def count(face, points):
        return sum(1 for part in parts(face.Intersection(points)) if not part.IsEmpty())

    streets = [count(face, evidence.streets) for face in faces]
    rivers = [count(face, evidence.rivers) for face in faces]
    for wet in ([f for f, s, r in zip(faces, streets, rivers) if r > 0 and s <= r / 10],
                [f for f, s in zip(faces, streets) if s == 0]):
        if not wet:
            continue
        water = together(wet, ogr.wkbMultiPolygon).UnionCascaded()
        if banks.Intersection(water.Boundary().Buffer(0.1)).Length() >= TOLD * banks.Length():
            for line in added:
                water = water.Difference(line.Buffer(line.Length()))
            return water
    return None
