#include "render/name_places.hpp"

#include <algorithm>
#include <array>

#include "render/palette.hpp"
#include "render/xml_text.hpp"

namespace waybreaker::render {
namespace {

constexpr double baseline = 0.36;      // of a letter's height, below its middle
constexpr double letter_width = 0.62;  // of its height: as most are, or less
constexpr std::size_t most_letters = 12;

bool overlap(const Rectangle& a, const Rectangle& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

// Right, left, below, above.
std::array<Rectangle, 4> boxes(const Name& name, double pixels) {
    const auto [x, y] = name.at;
    const double width = name.width;
    const double clear = name.clear;
    const double middle = y - pixels / 2;
    return {{{x + clear, middle, width, pixels},
             {x - clear - width, middle, width, pixels},
             {x - width / 2, y + clear, width, pixels},
             {x - width / 2, y - clear - pixels, width, pixels}}};
}

Name joined(const std::vector<std::string>& ids, Point at, double pixels) {
    Name name{at, "", 0, 0};
    std::size_t letters = 0;
    for (const std::string& id : ids) {
        if (!name.text.empty()) name.text += ", ";
        letters += std::min(id.size(), most_letters) + (name.text.empty() ? 0 : 2);
        name.text += xml_text(id, most_letters);
    }
    name.width = letter_width * pixels * double(letters);
    return name;
}

}  // namespace

std::vector<Name> names_at_places(const Mission& mission, const Layout& layout) {
    struct Place {
        Cell at;
        std::vector<std::string> ids = {};
        bool is_start = false;
        bool is_goal = false;
    };
    std::vector<Place> places;
    for (const Agent& agent : mission.agents) {
        for (const bool goal : {false, true}) {
            const Cell at = goal ? agent.goal : agent.start;
            auto place = std::ranges::find(places, at, &Place::at);
            if (place == places.end()) place = places.insert(place, Place{.at = at});
            (goal ? place->is_goal : place->is_start) = true;
            if (std::ranges::find(place->ids, agent.id) == place->ids.end()) place->ids.push_back(agent.id);
        }
    }
    std::vector<Name> names;
    for (const Place& place : places) {
        names.push_back(joined(place.ids, layout.at(place.at), size::small_text * layout.unit));
        const bool has_both = place.is_start && place.is_goal;
        names.back().clear = ((has_both ? size::start_at_goal : size::breach_label) + 4) * layout.unit;
    }
    return names;
}

std::vector<Point> name_places(const std::vector<Name>& names, double pixels) {
    std::vector<Rectangle> taken;
    for (const Name& name : names) {
        const double side = 1.4 * name.clear;  // of a square about as large as the sign
        taken.push_back({name.at.x - side / 2, name.at.y - side / 2, side, side});
    }
    std::vector<Point> places;
    for (const Name& name : names) {
        const std::array<Rectangle, 4> tried = boxes(name, pixels);
        const auto* const free = std::ranges::find_if(tried, [&](const Rectangle& box) {
            return std::ranges::none_of(taken, [&](const Rectangle& other) { return overlap(box, other); });
        });
        const Rectangle box = free == tried.end() ? tried[0] : *free;
        taken.push_back(box);
        places.push_back({box.x, box.y + (0.5 + baseline) * pixels});
    }
    return places;
}

}  // namespace waybreaker::render
