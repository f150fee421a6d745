// Which of the user's filters have matched anything yet, to tell a misspelt filter from one that matches rarely.
#pragma once

#include <string>
#include <vector>

#include "city/obstacle_choice.hpp"
#include "city/premises.hpp"
#include "city/tag_set.hpp"

namespace waybreaker::city {

class FilterUse {
  public:
    explicit FilterUse(const ObstacleChoice& choice);

    // Takes note of an obstacle.
    void see(const TagSet& obstacle);
    // Takes note of what may protect the buildings there.
    void see(const Premises& premises);
    bool all_used() const { return unused_.empty(); }
    // Throws InputError that names the first filter that matched nothing; `source` is all that was seen.
    void require_all(const std::string& source) const;

  private:
    struct Filter {
        std::string option;
        TagFilter tag;
        bool number = false;  // what is wanted is a number above 0 there
    };
    std::vector<Filter> unused_;
};

}  // namespace waybreaker::city
