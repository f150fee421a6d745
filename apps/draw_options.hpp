// What is drawn when missions are rehearsed, as options of commands.
#pragma once

#include <vector>

#include "commands.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/rehearse.hpp"

namespace waybreaker::apps {

// Their defaults are what `options` says. Returns them.
std::vector<CLI::Option*> add_draws(CLI::App& command, RehearsalOptions& options);

// How what is left is planned where something fails: as the plan was, or with proof where that way knows no missions
// under way.
Method method_of_revisions(Method method);

}  // namespace waybreaker::apps
