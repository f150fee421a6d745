// The error of a mission whose agent has no room where it is to start or to end.
#pragma once

#include <optional>
#include <string>

#include "waybreaker/error.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker {

struct Misplaced {
    std::string agent;     // its id
    std::string what_for;  // "the ground agent's start"
    Cell at;
    ObstacleId obstacle;          // that it lies in; none if there is only too little room
    std::string reason;           // "lies inside obstacle 2"
    std::optional<Cell> nearest;  // where there is room
    std::string remedy;           // "a free cell near it is", or that there is none
};

// Thrown by validate (mission.hpp). Its parts are for those who know places by other words than cells.
class PlaceError : public InputError {
  public:
    explicit PlaceError(Misplaced agent);
    Misplaced misplaced;
};

}  // namespace waybreaker
