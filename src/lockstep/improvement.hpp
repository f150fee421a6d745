// Makes routes shorter by large neighbourhood search (Li, Chen, Harabor, Stuckey, Koenig: MAPF-LNS, IJCAI 2021): takes
// those of a few vehicles away, plans these one after the other past all the rest, keeps what is better.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lockstep/occupancy.hpp"

namespace waybreaker::lockstep {

// Aim of a plan: the sum of all arrivals, or the last one and then the sum.
enum class Aim { sum, last };

// Until so many tries in a row have gained nothing, nobody is later than if it were alone, or `due`. `left` holds each
// vehicle's distances to its goal; none of the routes meets another. Of so many words and times together, at most.
std::vector<Route> improved(const Lattice& lattice, Meeting meeting, std::span<const std::vector<std::uint32_t>> left,
                            std::vector<Route> routes, Aim aim, std::size_t most_failures, std::size_t most_words,
                            const std::function<bool()>& due);

}  // namespace waybreaker::lockstep
