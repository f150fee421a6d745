# A plan that meets the field: a breach fails, and the rest of the mission is planned anew.
import numpy as np
import waybreaker as wb


def show(plan: wb.Plan) -> None:
    print(f"there at {plan.after.ground_makespan:g}, breaks {len(plan.removed)}")


walls = np.zeros((4, 9), dtype=bool)  # rows, columns; every cell free
walls[:3, 4] = True
map = wb.Map.from_array(walls)
mission = wb.Mission(
    [wb.Vehicle((0, 1), (8, 1), "rover"), wb.Aircraft((0, 1), (0, 1), "drone")], wb.Rules(removals=1, breach_time=1)
)

plan = wb.plan(map, mission)
show(plan)

breach = plan.removed[0]
state = wb.State(1, breach.cleared_at, failed=[wb.Opening(breach.obstacle, breach.cleared_at)])
after = wb.revise(map, plan, state)
print(f"at {state.now:g} the breach of wall {breach.obstacle} has failed: {after.revision.status}")
show(after)
for violation in wb.check(map, after, after=plan, state=state):
    print(violation.message)
