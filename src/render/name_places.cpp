#include "render/name_places.hpp"

#include <algorithm>
#include <array>

#include "render/palette.hpp"
#include "render/xml_text.hpp"

namespace waybreaker::render {
namespace {

constexpr double baseline = 0.36;          // of a letter's height, below its middle
constexpr double letter_width = 0.62;      // of its height: as most are, or less
constexpr std::size_t most_letters = 12;   // of one name
constexpr std::size_t most_together = 30;  // of those at one place: less than half of the picture

bool overlap(const Rectangle& a, const Rectangle& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool inside(const Rectangle& box, const Rectangle& window) {
    return box.x >= window.x && box.y >= window.y && box.x + box.width <= window.x + window.width &&
           box.y + box.height <= window.y + window.height;
}

// Right, left, below, above; then the corners between.
std::array<Rectangle, 8> boxes(const Name& name, double away, double pixels) {
    const auto [x, y] = name.at;
    const double width = name.width;
    const double right = x + away;
    const double left = x - away - width;
    const double below = y + away;
    const double above = y - away - pixels;
    const double middle = y - pixels / 2;
    const double centred = x - width / 2;
    const auto box = [&](double from, double top) { return Rectangle{from, top, width, pixels}; };
    return {box(right, middle), box(left, middle), box(centred, below), box(centred, above),
            box(right, below),  box(left, below),  box(right, above),   box(left, above)};
}

// Of a square about as large as the sign.
Rectangle box_of(Point at, double clear) {
    const double side = 1.4 * clear;
    return {at.x - side / 2, at.y - side / 2, side, side};
}

Name joined(const std::vector<std::string>& ids, Point at, double pixels) {
    Name name{at, "", 0, 0};
    std::size_t letters = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (letters > most_together) {
            const std::string rest = ", +" + std::to_string(ids.size() - i);
            name.text += rest;
            letters += rest.size();
            break;
        }
        if (i > 0) name.text += ", ";
        letters += std::min(ids[i].size(), most_letters + 1) + (i > 0 ? 2 : 0);
        name.text += xml_text(ids[i], most_letters);
    }
    name.width = text_width(letters, pixels);
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

double text_width(std::size_t letters, double pixels) {
    return letter_width * pixels * double(letters);
}

std::vector<std::optional<Point>> name_places(const std::vector<Name>& names, const std::vector<Mark>& others,
                                              double pixels, Rectangle window) {
    std::vector<Rectangle> taken;
    for (const Name& name : names) taken.push_back(box_of(name.at, name.clear));
    for (const Mark& mark : others) taken.push_back(box_of(mark.at, mark.clear));
    const auto is_free = [&](const Rectangle& box) {
        return inside(box, window) &&
               std::ranges::none_of(taken, [&](const Rectangle& other) { return overlap(box, other); });
    };
    std::vector<std::optional<Point>> places;
    for (const Name& name : names) {
        std::optional<Point>& place = places.emplace_back();
        for (const double farther : {1.0, 1.7, 2.4}) {
            const std::array<Rectangle, 8> tried = boxes(name, farther * name.clear, pixels);
            const auto* const box = std::ranges::find_if(tried, is_free);
            if (box == tried.end()) continue;
            taken.push_back(*box);
            place = Point{box->x, box->y + (0.5 + baseline) * pixels};
            break;
        }
    }
    return places;
}

}  // namespace waybreaker::render
