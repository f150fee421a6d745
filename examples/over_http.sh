#!/usr/bin/env bash
# waybreaker over HTTP: send a map, plan a mission, see which wall to break and the way through. Needs curl and jq.
set -euo pipefail
server=${1:-http://localhost:8080} # waybreaker serve

map=$(curl -sf "$server/api/v1/maps" -H 'Content-Type: application/octet-stream' --data-binary @- <<'END' | jq -r .id
type octile
height 4
width 9
map
....@....
....@....
....@....
.........
END
)
plan=$(curl -sf "$server/api/v1/maps/$map/plan" -H 'Content-Type: application/json' --data-binary @- <<'END'
{
  "mission": {
    "format": "waybreaker-mission/1",
    "agents": [
      {"id": "rover", "kind": "ground", "start": [0, 1], "goal": [8, 1], "ready_at": 5},
      {"id": "drone", "kind": "air", "start": [0, 1], "goal": [0, 1]}
    ],
    "rules": {"removals": 1}
  }
}
END
)
jq -r '(.removed[] | "break wall \(.obstacle) from (\(.at[0]), \(.at[1]))"),
    "drive" + ([.agents[0].path[] | " (\(.[0]), \(.[1]))"] | add),
    "\(.status): there at \(.before.makespan * 1e4 | round / 1e4) before, at \(.after.makespan) after"' <<<"$plan"
