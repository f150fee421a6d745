# waybreaker in Python: draw a map, plan a mission, see which wall to break and the way through.
import numpy as np
import waybreaker as wb

walls = np.zeros((4, 9), dtype=bool)  # rows, columns; every cell free
walls[:3, 4] = True

mission = wb.Mission(
    [wb.Vehicle((0, 1), (8, 1), "rover", ready_at=5), wb.Aircraft((0, 1), (0, 1), "drone")], wb.Rules(removals=1)
)
plan = wb.plan(wb.Map.from_array(walls), mission)

for wall in plan.removed:
    print(f"break wall {wall.obstacle} from ({wall.at[0]}, {wall.at[1]})")
print("drive", *(f"({x:g}, {y:g})" for x, y in plan["rover"].path))
print(f"{plan.status}: there at {plan.before.makespan:g} before, at {plan.makespan:g} after")
