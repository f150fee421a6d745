"""What a feature of OpenStreetMap is to a vehicle, by the rules of docs/data.md. For scripts/judge-ground."""
import re

WIDTHS = {"motorway": 10.5, "motorway_link": 6, "trunk": 8, "trunk_link": 6, "primary": 8, "primary_link": 5.5,
          "secondary": 6, "secondary_link": 5.5, "tertiary": 7, "tertiary_link": 5.5, "unclassified": 6.5,
          "residential": 7, "living_street": 5.25, "road": 6.5, "service": 5, "track": 2.25, "pedestrian": 3,
          "cycleway": 2.5, "footway": 2, "bridleway": 2, "path": 1, "steps": 1.5}
FAST = {"motorway", "motorway_link", "trunk", "trunk_link"}
SOFT = {"pedestrian", "cycleway", "footway", "bridleway", "path"}
TRACKS = {"rail", "light_rail", "narrow_gauge", "subway", "funicular", "preserved"}
PASSAGES = {"building_passage", "covered", "arcade", "colonnade", "avalanche_protector"}
AIRFIELD = {"runway": 45, "taxiway": 15}
CLIFFS = {"retaining_wall": 0.5, "city_wall": 2, "ditch": 1}
WATER = {"natural": {"water", "mud"}, "wetland": {"tidalflat"}, "waterway": {"riverbank", "dock"},
         "landuse": {"reservoir", "basin", "salt_pond", "aquaculture"}, "leisure": {"swimming_pool"}}
PAVED = {"amenity": {"parking", "parking_space", "fuel", "bus_station", "loading_dock", "weighbridge"},
         "landuse": {"garages", "depot"}}
TANKS = {"storage_tank", "silo", "bunker_silo", "gasometer", "tower", "water_tower", "communications_tower",
         "cooling_tower", "chimney", "kiln", "lighthouse", "windmill"}
# Points in ways, in the order of PROFILES.
PROFILES = ("rover", "truck", "walker")
GATES = {"gate", "lift_gate", "swing_gate", "sliding_gate", "sliding_beam", "hampshire_gate", "bump_gate", "entrance",
         "coupure", "toll_booth", "border_control", "sally_port", "sump_buster"}
BARRED = {**{kind: (False, False, False) for kind in GATES},
          **{kind: (False, True, False) for kind in ("wicket_gate", "bollard", "block", "planter", "jersey_barrier",
                                                     "tank_trap", "cycle_barrier", "height_restrictor")},
          **{kind: (True, True, False) for kind in ("motorcycle_barrier", "kissing_gate", "stile", "horse_stile",
                                                    "turnstile", "full-height_turnstile", "step", "log", "debris",
                                                    "chain", "rope")},
          "cattle_grid": (False, False, True), "bus_trap": (True, False, False)}
# Closed ways with one of these keys are areas, but for these values; with one of ONLY only for those.
AREAS = {"amenity": (), "area:highway": (), "boundary": (), "building": (), "landuse": (), "place": (), "tourism": (),
         "leisure": ("slipway", "track"), "historic": ("citywalls",), "military": ("trench",),
         "natural": ("coastline", "cliff", "tree_row", "ridge", "arete", "valley", "gully", "earth_bank"),
         "man_made": ("embankment", "pipeline", "breakwater", "groyne", "dyke", "cutline", "goods_conveyor", "yes"),
         "aeroway": ("taxiway", "jet_bridge"), "shop": (), "office": (), "public_transport": ("stop_position",)}
ONLY = {"waterway": {"riverbank", "dock", "boatyard", "dam", "fuel"}, "power": {"plant", "substation", "generator"},
        "railway": {"station", "platform", "roundhouse", "turntable"}, "highway": {"services", "rest_area", "platform"}}
LINES = {"highway", "railway", "barrier", "waterway", "natural", "man_made", "aeroway", "historic"}

UNITS = {"": 1, "m": 1, "cm": 0.01, "ft": 0.3048, "'": 0.3048, "t": 1, "kg": 0.001, "lbs": 0.00045359237,
         "st": 0.90718474}


def number(text, default=0.0):
    found = re.match(r"\s*([-+]?[0-9]*\.?[0-9]+)", text or "")
    return float(found.group(1)) if found else default


def measure(text):
    """In metres or tonnes; None if nobody can tell."""
    found = re.fullmatch(r"([0-9]*\.?[0-9]+) *([a-z']*)(?:([0-9.]+)\")?", text or "")
    if not found or found.group(2) not in UNITS:
        return None
    return float(found.group(1)) * UNITS[found.group(2)] + float(found.group(3) or 0) * 0.0254


def has(tags, key):
    return tags.get(key, "no").lower() not in ("no", "false", "0")


def is_area(tags):
    """Whether a closed way is an area; it can be a line as well."""
    if tags.get("area") in ("yes", "no"):
        return tags["area"] == "yes"
    return any(tags.get(key, "no") != "no" and tags[key] not in but for key, but in AREAS.items()) or any(
        tags.get(key) in values for key, values in ONLY.items())


def is_line(tags):
    if tags.get("area") in ("yes", "no"):
        return tags["area"] == "no"
    said = (key for key in LINES if tags.get(key, "no") != "no")
    return not is_area(tags) or any(
        tags[key] in AREAS[key] if key in AREAS else tags[key] not in ONLY.get(key, ()) for key in said)


class Rules:
    """Of one profile: `kind` says what a feature is to it, and how wide its line is.

    way, underpass: public ways. pier, paved: open as well. forbidden, closed (no way leads across), cliff, water and
    coast: never passable. house: can be removed. bars: a point that closes its way.
    """

    def __init__(self, profile):
        self.profile = profile
        self.truck = profile == "truck"
        self.wheels = profile != "walker"
        self.breadth = {"rover": 0.8, "truck": 2.55, "walker": 0.6}[profile]
        self.modes = ("hgv", "motor_vehicle", "vehicle") if self.truck else ("foot",)

    def said(self, tags):
        return next((tags[mode] for mode in self.modes if mode in tags), None)

    def shut_out(self, tags):
        return (self.said(tags) or tags.get("access")) in ("no", "private")

    def invited(self, tags):
        return self.said(tags) in ("yes", "designated", "permissive", "official")

    def too_big(self, tags):
        if not self.truck:
            return False
        most = {"maxwidth": 2.55, "maxwidth:physical": 2.55, "maxheight": 4, "maxheight:physical": 4, "maxweight": 40,
                "maxweight:hgv": 40, "maxweightrating": 40, "maxweightrating:hgv": 40}
        said = ((measure(tags[key]), need) for key, need in most.items() if key in tags)
        return any(allowed is not None and allowed < need for allowed, need in said)

    def drives(self, tags, highway):
        if highway == "steps":
            ramp = has(tags, "ramp:wheelchair") or has(tags, "ramp:stroller")
            return not self.wheels or (self.profile == "rover" and ramp)
        return highway not in (SOFT if self.truck else FAST) or self.invited(tags)

    def unusable(self, tags):
        return (tags.get("bridge") in ("collapsed", "abandoned") or tags.get("impassable") == "yes"
                or (self.wheels and tags.get("ford") == "stepping_stones") or self.too_big(tags))

    def kind(self, tags, shape):
        if shape == "point":
            return self.point(tags), 0
        if elsewhere(tags):
            return ("house" if shape == "area" and house(tags) else None), 0
        if tags.get("highway") in WIDTHS:
            return self.way(tags, shape == "line")
        return self.area(tags) if shape == "area" else self.line(tags)

    def point(self, tags):
        kind = tags.get("barrier")
        if kind not in BARRED:
            return None
        if tags.get("locked") == "yes" or self.shut_out(tags) or self.too_big(tags):
            return "bars"
        if self.invited(tags) or (kind == "height_restrictor" and "maxheight" in tags):
            return "opens"
        return "bars" if BARRED[kind][PROFILES.index(self.profile)] else "opens"

    def way(self, tags, line):
        highway = tags["highway"]
        lanes = number(tags.get("lanes"))
        width = max(measured(tags, lanes * 3.25 if lanes >= 1 else WIDTHS[highway], 40), self.breadth)
        passage = tags.get("tunnel") in PASSAGES
        if not self.drives(tags, highway) or self.shut_out(tags):
            private = tags.get("access") in ("no", "private")
            fast = highway in FAST and not self.drives(tags, highway)
            if (fast or private) and line and not has(tags, "tunnel"):
                return "forbidden", width
            steps = highway == "steps" and line and not has(tags, "tunnel") and number(tags.get("layer")) >= 0
            return ("cliff" if steps else None), width
        if self.unusable(tags):
            return None, 0
        below = (tunnel(tags) or number(tags.get("layer")) < 0) and not passage
        return ("underpass" if below else "way"), width

    def line(self, tags):
        if tags.get("man_made") == "pier":
            return self.pier(tags)
        if tunnel(tags):
            return None, 0
        if tags.get("natural") == "coastline":
            return "coast", 0
        if not has(tags, "covered"):
            if tags.get("waterway") in ("river", "canal"):
                return "water", measured(tags, 12, 500)
            if tags.get("waterway") in ("stream", "drain", "ditch") and self.wheels:
                width = measured(tags, 0, 500)
                if width >= 2:
                    return "water", width
        if tags.get("natural") == "cliff":
            return "cliff", measured(tags, 1, 500)
        if tags.get("barrier") in CLIFFS:
            low = 0 < (measure(tags.get("height")) or 0) <= 0.5 and tags["barrier"] == "retaining_wall"
            climbed = low and not self.wheels
            return (None if climbed else "cliff"), measured(tags, CLIFFS[tags["barrier"]], 500)
        if tags.get("historic") == "citywalls" and not has(tags, "barrier"):
            return "cliff", measured(tags, 2, 500)
        if tags.get("railway") in TRACKS:
            return "forbidden", measured(tags, 4, 500)
        if tags.get("aeroway") in AIRFIELD:
            return "forbidden", measured(tags, AIRFIELD[tags["aeroway"]], 500)
        if tags.get("man_made") == "pipeline" and tags.get("location") == "overground":
            return "forbidden", measured(tags, 1, 500)
        return ("house" if has(tags, "barrier") else None), 0

    def pier(self, tags):
        if self.truck or self.shut_out(tags):
            return None, 0
        lanes = number(tags.get("lanes"))
        return "pier", measured(tags, lanes * 3.25 if lanes >= 1 else 3, 40)

    def area(self, tags):
        if tags.get("man_made") == "pier":
            return self.pier(tags)
        if tunnel(tags):
            return None, 0
        if tags.get("landuse") == "military" or has(tags, "military") or tags.get("amenity") == "prison":
            return "closed", 0
        if not has(tags, "covered") and any(tags.get(key) in values for key, values in WATER.items()):
            return "water", 0
        if house(tags) or tags.get("man_made") in TANKS:
            return "house", 0
        surface = number(tags.get("layer")) >= 0
        if self.truck and surface and not self.shut_out(tags) and self.paved(tags):
            return "paved", 0
        building = has(tags, "building")
        if tags.get("natural") == "glacier" or tags.get("aeroway") in AIRFIELD or (
                tags.get("power") == "substation" and not building):
            return "forbidden", 0
        if tags.get("access") in ("no", "private") and not building and not has(tags, "boundary") and surface:
            return "forbidden", 0
        return ("house" if has(tags, "barrier") else None), 0

    def paved(self, tags):
        highway = tags.get("area:highway")
        return (highway in WIDTHS and self.drives(tags, highway)) or any(
            tags.get(key) in values for key, values in PAVED.items())


def elsewhere(tags):
    """Indoors, on a roof or under the ground."""
    return (has(tags, "indoor") or tags.get("parking") in ("underground", "rooftop", "multi-storey")
            or tags.get("location") in ("underground", "indoor", "roof", "rooftop"))


def house(tags):
    """A building that stands on the ground and bars the way."""
    return (has(tags, "building") and tags["building"] not in ("roof", "carport", "canopy", "bridge")
            and number(tags.get("layer")) >= 0 and "underground" not in (tags.get("location"), tags.get("parking")))


def tunnel(tags):
    return has(tags, "tunnel") and tags["tunnel"] not in PASSAGES


def measured(tags, usual, most):
    width = number(tags.get("width"))
    return width if 0 < width <= most else usual


def deck(tags):
    """Whether a way lies on a bridge that is entered at its ends."""
    return (has(tags, "bridge") and tags["bridge"] not in ("boardwalk", "low_water_crossing")
            and number(tags.get("layer")) >= 0)
