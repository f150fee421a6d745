"""usage: plan.py MAP MISSION: the plan file, by the Python package."""
import json
import sys
from pathlib import Path

import waybreaker

map_file, mission = map(Path, sys.argv[1:])
city = waybreaker.Map.from_movingai(map_file.read_text(), map_file.name)
sys.stdout.buffer.write(waybreaker.plan(city, json.loads(mission.read_text())).to_json())
