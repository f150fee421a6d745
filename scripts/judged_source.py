"""An OpenStreetMap extract, read by libosmium: features, areas that lack members, and of what it has data. For
scripts/judge-ground."""
import osmium
from osgeo import ogr

from judged_rules import is_area, is_line

KEYS = {"highway", "waterway", "railway", "man_made", "barrier", "natural", "landuse", "leisure", "military", "access",
        "amenity", "aeroway", "power", "historic", "wetland", "area:highway", "building"}
TELLS_NOTHING = {"type", "source", "created_by", "note", "area"}


class Feature:
    """What one feature is to the vehicle: kind, width in metres, geometry in degrees, and its number in the source."""

    def __init__(self, number, tags, shape, rules, kind="line"):
        self.number, self.tags, self.shape = number, tags, shape
        self.line = kind == "line"
        self.kind, self.width = rules.kind(tags, kind)
        self.box = shape.GetEnvelope()


class Cut:
    """An area some of whose outline the source does not have: the lines that are there."""

    def __init__(self, number, tags, lines):
        self.number, self.tags, self.lines = number, tags, lines


def line_of(places):
    line = ogr.Geometry(ogr.wkbLineString)
    for place in places:
        line.AddPoint_2D(*place)
    return line


def polygon_of(places):
    ring = ogr.Geometry(ogr.wkbLinearRing)
    for place in places:
        ring.AddPoint_2D(*place)
    ring.CloseRings()
    polygon = ogr.Geometry(ogr.wkbPolygon)
    polygon.AddGeometry(ring)
    return polygon


def moved(shape, projection):
    shape = shape.Clone()
    shape.Transform(projection)
    return shape


class Reader(osmium.SimpleHandler):
    def __init__(self, rules):
        super().__init__()
        self.rules = rules
        self.wkb = osmium.geom.WKBFactory()
        self.features = []
        self.lines = {}  # of all ways
        self.rings = {}  # tags of closed ways that may be areas
        self.whole = set()  # ways that lack no node
        self.assembled = set()
        self.relations = []
        self.nodes = [180.0, 90.0, -180.0, -90.0]

    def add(self, number, tags, shape, kind):
        feature = Feature(number, tags, shape, self.rules, kind)
        if feature.kind:
            self.features.append(feature)

    def node(self, node):
        if not node.location.valid():
            return
        place = (node.location.lon, node.location.lat)
        self.nodes = [*map(min, self.nodes[:2], place), *map(max, self.nodes[2:], place)]
        if "barrier" in node.tags:
            point = ogr.Geometry(ogr.wkbPoint)
            point.AddPoint_2D(*place)
            self.add(node.id, {tag.k: tag.v for tag in node.tags}, point, "point")

    def way(self, way):
        places = [(node.lon, node.lat) for node in way.nodes if node.location.valid()]
        if len(places) < 2:
            return
        self.lines[way.id] = places
        if len(places) == len(way.nodes):
            self.whole.add(way.id)
        tags = {tag.k: tag.v for tag in way.tags}
        closed = len(way.nodes) > 3 and way.nodes[0].ref == way.nodes[-1].ref
        if KEYS.isdisjoint(tags):
            return
        if closed and is_area(tags):
            self.rings[way.id] = tags
        if not closed or is_line(tags):
            self.add(way.id, tags, line_of(places), "line")

    def area(self, area):
        number = area.orig_id() if area.from_way() else -area.orig_id()
        self.assembled.add(number)
        tags = {tag.k: tag.v for tag in area.tags}
        no_rings = area.num_rings()[0] == 0  # they cross themselves
        if no_rings or KEYS.isdisjoint(tags) or (area.from_way() and not is_area(tags)):
            return
        shape = ogr.CreateGeometryFromWkb(bytes.fromhex(self.wkb.create_multipolygon(area)))
        self.add(number, tags, shape, "area")

    def relation(self, relation):
        if relation.tags.get("type") not in ("multipolygon", "boundary"):
            return
        ways = [member.ref for member in relation.members if member.type == "w"]
        self.relations.append((relation.id, {tag.k: tag.v for tag in relation.tags}, ways))

    def add_rings_of_relations(self):
        """Closed ways that bound a relation are areas of their own where they say something else than it."""
        said = {}
        for _, tags, ways in self.relations:
            for way in ways:
                said.setdefault(way, []).append(tags)
        for number, tags in self.rings.items():
            around = said.get(number, [])
            if number in self.assembled or len(self.lines[number]) < 4:
                continue
            kinds = [self.rules.kind(one, "area")[0] for one in around]
            silent = any(TELLS_NOTHING.issuperset(one) for one in around)
            if not silent and self.rules.kind(tags, "area")[0] not in kinds:
                self.add(number, tags, polygon_of(self.lines[number]), "area")

    def cut(self):
        """Areas that lack members."""
        return [Cut(-number, tags, [line_of(self.lines[way]) for way in ways if way in self.lines])
                for number, tags, ways in self.relations
                if -number not in self.assembled and not self.whole.issuperset(ways)]


class Source:
    """What matters to a vehicle in an extract; `box`: west, south, east and north of its data in degrees."""

    def __init__(self, path, rules):
        stated = osmium.io.Reader(path).header().box()
        reader = Reader(rules)
        reader.apply_file(path, locations=True)
        reader.add_rings_of_relations()
        self.features = reader.features
        self.cut_waters = [cut for cut in reader.cut() if rules.kind(cut.tags, "area")[0] == "water"]
        self.box = reader.nodes
        if stated.valid():
            low, high = stated.bottom_left, stated.top_right
            around = [*(x - 1 for x in self.box[:2]), *(x + 1 for x in self.box[2:])]  # some state half the world
            self.box = [*map(max, around[:2], (low.lon, low.lat)), *map(min, around[2:], (high.lon, high.lat))]

    def hull(self):
        """Around all lines of the features; None of a source without any."""
        points = ogr.Geometry(ogr.wkbMultiPoint)
        for feature in self.features:
            for place in feature.shape.GetPoints() or [] if feature.line else []:
                point = ogr.Geometry(ogr.wkbPoint)
                point.AddPoint_2D(*place[:2])
                points.AddGeometry(point)
        hull = points.ConvexHull()
        return hull if hull.GetGeometryName() == "POLYGON" else None
