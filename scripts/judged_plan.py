"""What a map and plans on it owe to their source. For scripts/judge-ground."""
import json
import math
from pathlib import Path

import numpy as np
from osgeo import ogr

from judged_cut import parts
from judged_ground import SCALE, points_along, shrunk
from judged_rules import deck

YARD = 6  # metres between a road and what can be removed that trucks may cross
STEP = 0.1  # metres between points of paths


def share(part, whole):
    return 100.0 if whole == 0 else 100 * float(part) / whole


class Judgement:
    def __init__(self, ground, rules, raw):
        self.ground = g = ground
        self.rules = rules
        self.diagonal = diagonal = g.cell * math.sqrt(2)
        edge = 0 if raw else math.ceil(diagonal / 2 / (g.cell / SCALE)) + 1
        self.public = g.shapes("way", "pier")
        self.ways = g.painted([self.opened(f, s) for f, s in self.public if f.line or "bridge" in f.tags
                               or f.kind == "pier"])
        water = g.painted(g.waters())
        self.shut = g.painted([s for _, s in g.shapes("closed")])
        self.deep_water = (shrunk(water, edge) | g.fine(g.sea())) & ~self.ways & g.known
        below = g.painted([s.Buffer(diagonal) for _, s in g.shapes("underpass") if s.Length() <= 100])
        lines = g.painted([g.strip(f, s, g.cell) for f, s in g.shapes("forbidden") if f.line])
        areas = g.painted([s for f, s in g.shapes("forbidden") if not f.line])
        cliffs = g.painted([g.strip(f, s, g.cell) for f, s in g.shapes("cliff")])
        self.forbidden = ((shrunk(lines, edge) & ~below) | shrunk(areas, edge) | shrunk(cliffs, edge)) & ~self.ways
        self.forbidden |= shrunk(self.shut, edge)
        self.crossable = self.ways | below
        self.beyond = shrunk(~g.painted([g.data]), edge)
        self.bars = self.barred()
        self.beside_bars = g.painted([ogr.CreateGeometryFromWkt(f"POINT({x} {y})").Buffer(
            max(width / 2, rules.breadth / 2 + diagonal) + diagonal) for (x, y), width in self.bars.items()])
        self.wild = self.off_roads() if rules.truck else None

    def reach(self, f):
        """How far from its line points can lie in cells that a way opens: those whose centres it covers, those that it
        touches, and what a vehicle wider than a cell comes over there."""
        driven = self.rules.breadth / 2 + self.diagonal / 2 if self.rules.breadth > self.ground.cell else 0
        return max(f.width / 2, driven + self.diagonal / 2) + self.diagonal / 2

    def opened(self, f, shape):
        return shape.Buffer(self.reach(f) if f.line else self.diagonal / 2)

    def barred(self):
        """Points that bar public ways: where, and how wide the widest of these is."""
        places = {}
        for f, shape in self.ground.shapes("bars"):
            places[shape.GetPoint_2D()] = 0
        for f, shape in self.ground.shapes("way", "underpass"):
            for place in shape.GetPoints() or [] if f.line else []:
                if place[:2] in places:
                    places[place[:2]] = max(places[place[:2]], f.width)
        return {place: width for place, width in places.items() if width and self.ground.inside(*place)}

    def off_roads(self):
        """Where no road, car park or yard is."""
        g = self.ground
        roads = g.painted([self.opened(f, s) for f, s in g.shapes("way", "underpass", "paved")])
        houses = g.painted([s.Buffer(g.cell) if f.line else s for f, s in g.shapes("house")]) | self.beside_bars
        yards = g.metres_to(roads) + g.metres_to(houses) <= YARD + self.diagonal
        return ~(roads | yards | houses)

    def of_map(self):
        """For each thing required of a map how many points there are, and which share is as it should be."""
        g = self.ground
        lasting, free = g.fine(g.lasting), g.fine(g.labels == 0)
        points, open_ones = self.public_ways()
        places = np.array(list(self.bars), float).reshape(-1, 2)
        barred = int((g.at(g.labels, places[:, 0], places[:, 1]) != 0).sum())
        result = {"water": (int(self.deep_water.sum()), (self.deep_water & lasting).sum(), "blocked"),
                  "ways": (points, open_ones, "free"),
                  "no data": (int(self.beyond.sum()), (self.beyond & ~free).sum(), "blocked"),
                  "barred ways": (len(places), barred, "blocked")}
        if self.wild is not None:
            result["off roads"] = (int(self.wild.sum()), (self.wild & ~free).sum(), "blocked")
        return {what: (count, share(good, count), word) for what, (count, good, word) in result.items()}

    def public_ways(self):
        g = self.ground
        skip = self.shut | self.beside_bars | ~g.painted([g.data.Buffer(-self.diagonal)])
        count = free = 0
        for f, shape in g.shapes("way"):
            if not f.line or shape.Length() == 0:
                continue
            x, y = points_along(shape, 1.0)
            seen = g.inside(x, y) & ~g.at(skip, x, y)
            count += int(seen.sum())
            free += int((g.at(g.labels, x[seen], y[seen]) == 0).sum())
        return count, free

    def of_plan(self, path):
        """How much of its ground paths lies where it must not: in metres and, of lines and points, in numbers."""
        g = self.ground
        plan = json.loads(Path(path).read_text(encoding="utf-8"))
        removed = np.isin(g.labels, [one["obstacle"] for one in plan.get("removed", [])])
        sums = dict.fromkeys(("m in water", "m on forbidden ground", "m without data", "m off roads", "lines crossed",
                              "bridges entered from their sides", "barred ways passed", "ends in water"), 0)
        for agent in plan["agents"]:
            if agent["kind"] != "ground" or not agent.get("path"):
                continue
            cells = np.array(agent["path"], float)
            x = g.bounds[0] + (cells[:, 0] + 0.5) * g.cell
            y = g.bounds[3] - (cells[:, 1] + 0.5) * g.cell
            line = ogr.Geometry(ogr.wkbLineString)
            for one in zip(x, y):
                line.AddPoint_2D(*one)
            along = points_along(line, STEP)
            for what, where in (("m in water", self.deep_water), ("m on forbidden ground", self.forbidden),
                                ("m without data", self.beyond)):
                sums[what] += STEP * int(g.at(where, *along).sum())
            if self.wild is not None:
                opened = g.metres_to(g.fine(removed)) <= YARD if removed.any() else np.zeros_like(self.wild)
                sums["m off roads"] += STEP * int(g.at(self.wild & ~opened, *along).sum())
            sums["lines crossed"] += self.lines_crossed(line)
            sums["bridges entered from their sides"] += self.sides_crossed(line)
            sums["barred ways passed"] += self.bars_passed(line, removed)
            sums["ends in water"] += int(g.at(self.deep_water, x[[0, -1]], y[[0, -1]]).sum())
        return sums

    def lines_crossed(self, path):
        crossed = 0
        for f, shape in self.ground.shapes("water", "cliff", "forbidden"):
            if not f.line or not shape.Intersects(path):
                continue
            ends = np.array([part.GetPoint_2D(0) for part in parts(shape.Intersection(path))])
            crossed += int((~self.ground.at(self.crossable, ends[:, 0], ends[:, 1])).sum())
        return crossed

    def sides_crossed(self, path):
        """Where it gets on or off a bridge but at its ends, and where no other way joins or passes below."""
        crossed = 0
        for f, shape in self.public:
            if not f.line or not deck(f.tags) or not shape.Intersects(path.Buffer(f.width)):
                continue
            side = shape.Buffer(self.reach(f) + self.ground.cell / 4).Boundary()
            ends = [shape.GetPoint_2D(i) for i in (0, shape.GetPointCount() - 1)]
            for part in parts(side.Intersection(path)):
                if part.IsEmpty():
                    continue
                x, y = part.GetPoint_2D(0)
                at_end = any(math.hypot(x - a, y - b) < self.reach(f) + 2 * self.diagonal for a, b in ends)
                crossed += not at_end and not self.joined(part, f)
        return crossed

    def joined(self, point, bridge):
        ways = self.public + self.ground.shapes("underpass")
        return any(f is not bridge and shape.Distance(point) <= self.reach(f) + self.diagonal for f, shape in ways)

    def bars_passed(self, path, removed):
        g = self.ground
        passed = 0
        for (x, y), width in self.bars.items():
            near = max(width / 2 - self.diagonal / 2, g.cell / 4)
            open_now = g.at(removed, np.array([x]), np.array([y]))[0]
            passed += not open_now and path.Distance(ogr.CreateGeometryFromWkt(f"POINT({x} {y})")) < near
        return passed
