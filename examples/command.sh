#!/usr/bin/env bash
# waybreaker on the command line: make a map, plan a mission, print which wall to break and the way through. Needs jq.
set -euo pipefail

row=....................T................... # every cell free but for a wall
printf '%s\n' 'type octile' 'height 20' 'width 40' map >wall.map
for y in {0..19}; do ((y < 18)) && echo "$row" || echo "${row/T/.}"; done >>wall.map

waybreaker plan wall.map --start 4,4 --goal 36,4 --removals 1 --json plan.json >table.txt

jq -r '(.removed[] | "break wall \(.obstacle) from (\(.at[0]), \(.at[1]))"),
    "drive" + ([.agents[0].path[] | " (\(.[0]), \(.[1]))"] | add),
    "\(.before.makespan * 1e4 | round / 1e4) cells before, \(.after.makespan) after"' plan.json
