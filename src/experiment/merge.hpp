// Merge: the shards of one experiment become one file of results, if none is missing.
#pragma once

#include <span>
#include <string>

namespace waybreaker::experiment {

// Writes `output`, which must not exist: the file a run without shards would have written. Throws InputError, and
// writes nothing, unless the shards are all of one experiment and one version, each there once and complete.
void merge(std::span<const std::string> shards, const std::string& output);

}  // namespace waybreaker::experiment
