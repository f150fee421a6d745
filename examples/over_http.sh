#!/usr/bin/env bash
# waybreaker over HTTP: send a map, plan a mission, print which wall to break and the way through. Needs curl and jq.
set -euo pipefail
server=${1:-http://localhost:8080} # waybreaker serve

row=....................T................... # every cell free but for a wall
map=$({
    printf '%s\n' 'type octile' 'height 20' 'width 40' map
    for y in {0..19}; do ((y < 18)) && echo "$row" || echo "${row/T/.}"; done
} | curl -sf "$server/api/v1/maps" -H 'Content-Type: application/octet-stream' --data-binary @- | jq -r .id)

curl -sf "$server/api/v1/maps/$map/plan" -H 'Content-Type: application/json' \
    -d '{"mission": {"start": [4, 4], "goal": [36, 4]}, "options": {"removals": 1}}' |
    jq -r '(.removed[] | "break wall \(.obstacle) from (\(.at[0]), \(.at[1]))"),
        "drive" + ([.agents[0].path[] | " (\(.[0]), \(.[1]))"] | add),
        "\(.before.makespan * 1e4 | round / 1e4) cells before, \(.after.makespan) after"'
