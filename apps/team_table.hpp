// The agents of a plan as a table: of a team each one's figures, of all missions who waits where and for what.
#pragma once

#include <string>

#include "io/plan_json.hpp"
#include "plan_table.hpp"

namespace waybreaker::apps {

// Each agent of a team, and all together: if each were alone, and as planned.
std::string team_table(const Plan& plan, const io::PlanContext& context, const TableStyle& style);

// Where ground agents wait, and how long; of an explained plan, and where there is rubble, also for what. Empty if none
// does.
std::string waits(const Plan& plan, const io::PlanContext& context);

}  // namespace waybreaker::apps
