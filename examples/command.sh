#!/usr/bin/env bash
# waybreaker on the command line: draw a map, plan a mission, see which wall to break and the way through. Needs jq.
set -euo pipefail

cat >wall.map <<'END'
type octile
height 4
width 9
map
....@....
....@....
....@....
.........
END
cat >mission.json <<'END'
{
  "format": "waybreaker-mission/1",
  "agents": [
    {"id": "rover", "kind": "ground", "start": [0, 1], "goal": [8, 1], "ready_at": 5},
    {"id": "drone", "kind": "air", "start": [0, 1], "goal": [0, 1]}
  ],
  "rules": {"removals": 1}
}
END
waybreaker plan wall.map --mission mission.json --json plan.json >table.txt

jq -r '(.removed[] | "break wall \(.obstacle) from (\(.at[0]), \(.at[1]))"),
    "drive" + ([.agents[0].path[] | " (\(.[0]), \(.[1]))"] | add),
    "\(.status): there at \(.before.makespan * 1e4 | round / 1e4) before, at \(.after.makespan) after"' plan.json
