# waybreaker in Python: make a map, plan a mission, print which wall to break and the way through.
import numpy as np
import waybreaker as wb

walls = np.zeros((20, 40), dtype=bool)  # rows, columns; every cell free
walls[:18, 20] = True

mission = wb.Mission.ground_and_air(start=(4, 4), goal=(36, 4), removals=1)
plan = wb.plan(wb.Map.from_array(walls), mission)

for wall in plan.removed:
    print(f"break wall {wall.obstacle} from ({wall.at[0]}, {wall.at[1]})")
print("drive", *(f"({x:g}, {y:g})" for x, y in plan["ground"].path))
print(f"{plan.before.makespan:g} cells before, {plan.makespan:g} after")
