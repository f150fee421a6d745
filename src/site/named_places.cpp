#include "site/named_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace waybreaker::site {
namespace {

// U+00C0 to U+017F; '?' stays as it is.
constexpr std::string_view latin =
    "aaaaaa?ceeeeiiiidnooooo?ouuuuy??aaaaaa?ceeeeiiiidnooooo?ouuuuy?y"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiii??jjkk?lllllll"
    "lllnnnnnn???oooooo??rrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
constexpr char32_t first_latin = 0xC0;
static_assert(latin.size() == 0x180 - first_latin);

// The next character, which goes; what is no UTF-8 is taken byte by byte.
char32_t take_character(std::string_view& text) {
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : byte(0) >= 0xC0 ? 2 : 1;
    char32_t character = byte(0);
    if (length > 1 && length <= text.size()) {
        character = byte(0) & (0xFFU >> (length + 1));
        for (std::size_t i = 1; i < length; ++i) character = (character << 6U) | (byte(i) & 0x3FU);
    }
    text.remove_prefix(std::min(length, text.size()));
    return character;
}

void append_utf8(char32_t character, std::string& text) {
    if (character < 0x80) {
        text += char(character);
    } else if (character < 0x800) {
        text += {char(0xC0U | (character >> 6U)), char(0x80U | (character & 0x3FU))};
    } else if (character < 0x10000) {
        text += {char(0xE0U | (character >> 12U)), char(0x80U | ((character >> 6U) & 0x3FU)),
                 char(0x80U | (character & 0x3FU))};
    } else {
        text += {char(0xF0U | (character >> 18U)), char(0x80U | ((character >> 12U) & 0x3FU)),
                 char(0x80U | ((character >> 6U) & 0x3FU)), char(0x80U | (character & 0x3FU))};
    }
}

char32_t small_letter(char32_t c) {
    const bool capital = (c >= 'A' && c <= 'Z') || (c >= 0x391 && c <= 0x3A9) || (c >= 0x410 && c <= 0x42F);
    if (capital) return c + 32;
    return c >= 0x400 && c <= 0x40F ? c + 80 : c;
}

struct Entry {
    std::string plain;
    NamedPlace place;
    int rank = 0;     // what stands for others of its name: the least
    double size = 0;  // then the largest
};

double length_of(std::span<const Point> line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    }
    return length;
}

Point half_way(std::span<const Point> line) {
    double left = length_of(line) / 2;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double step = std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
        if (step > 0 && left <= step) {
            const double share = left / step;
            return {line[i - 1].x + share * (line[i].x - line[i - 1].x),
                    line[i - 1].y + share * (line[i].y - line[i - 1].y)};
        }
        left -= step;
    }
    return line.back();
}

Point middle(std::span<const Point> points) {
    const auto [left, right] = std::ranges::minmax(points, {}, &Point::x);
    const auto [top, bottom] = std::ranges::minmax(points, {}, &Point::y);
    return {(left.x + right.x) / 2, (top.y + bottom.y) / 2};
}

Entry entry_of(const Background::Feature& feature) {
    using Kind = Background::Kind;
    constexpr std::array<int, background_kinds.size()> ranks{0, 3, 4, 5, 1};  // a street first, then a place
    const auto& part = *std::ranges::max_element(feature.parts, {},
                                                 [](const std::vector<Point>& points) { return length_of(points); });
    const bool line = feature.shape == Background::Shape::line;
    std::string what =
        feature.kind == Kind::place ? feature.type : std::string(background_kinds[std::size_t(feature.kind)]);
    std::ranges::replace(what, '_', ' ');
    return {plain_text(feature.name),
            {feature.name, std::move(what), line ? half_way(part) : middle(part)},
            ranks[std::size_t(feature.kind)],
            length_of(part)};
}

// The names of an obstacle: of a section those of what it is a part of.
std::vector<std::string_view> names_of(const Annotations& annotations, ObstacleId id) {
    std::vector<std::string_view> names;
    const Sections& sections = annotations.sections;
    if (!sections.empty() && !sections.parts[id.value].empty()) {
        for (const std::uint32_t one : sections.parts[id.value]) names.emplace_back(sections.structures[one].name);
    } else {
        names.push_back(annotations.name_of(id));
    }
    std::erase(names, "");
    return names;
}

class Index {
  public:
    Index(const Map& map, const Annotations& annotations) : map_(map) {
        for (const Background::Feature& feature : annotations.background.features) {
            const bool there = !feature.name.empty() && !feature.parts.empty() &&
                               std::ranges::none_of(feature.parts, &std::vector<Point>::empty);
            if (there) add(entry_of(feature));
        }
        constexpr int obstacles = 2;
        for (const Obstacle& obstacle : map.obstacles()) {
            for (const std::string_view name : names_of(annotations, obstacle.id)) {
                const Point at((obstacle.bounds.min.x + obstacle.bounds.max.x) / 2.0,
                               (obstacle.bounds.min.y + obstacle.bounds.max.y) / 2.0);
                add({plain_text(name),
                     {std::string(name), "obstacle " + std::to_string(obstacle.id.value), at},
                     obstacles,
                     double(obstacle.cells)});
            }
        }
    }

    template <class Holds>
    std::vector<NamedPlace> those_that(Holds holds) const {
        std::vector<NamedPlace> found;
        for (const auto& [plain, entry] : entries_) {
            if (holds(plain)) found.push_back(entry.place);
        }
        return found;
    }

  private:
    void add(Entry entry) {
        Point& at = entry.place.at;
        at.x = std::clamp(at.x, 0.0, map_.width() - 1.0);
        at.y = std::clamp(at.y, 0.0, map_.height() - 1.0);
        const auto [known, is_new] = entries_.try_emplace(entry.plain, entry);
        const Entry& other = known->second;
        if (is_new || std::pair(entry.rank, -entry.size) >= std::pair(other.rank, -other.size)) return;
        known->second = std::move(entry);
    }

    const Map& map_;
    std::map<std::string, Entry> entries_;  // by plain name
};

}  // namespace

std::string plain_text(std::string_view text) {
    std::string plain;
    while (!text.empty()) {
        const char32_t c = take_character(text);
        const bool accent = c >= 0x300 && c <= 0x36F;  // a mark on the letter before
        if (accent) continue;
        const bool known = c >= first_latin && c < first_latin + latin.size() && latin[c - first_latin] != '?';
        if (known) {
            plain += latin[c - first_latin];
        } else if (c == 0xDF) {
            plain += "ss";
        } else if (c == 0xC6 || c == 0xE6) {
            plain += "ae";
        } else if (c == 0x152 || c == 0x153) {
            plain += "oe";
        } else {
            append_utf8(small_letter(c), plain);
        }
    }
    return plain;
}

PlacesFound places_called(std::string_view text, const Map& map, const Annotations& annotations) {
    using How = PlacesFound::How;
    const std::string wanted = plain_text(text);
    const Index index(map, annotations);
    PlacesFound found{How::exactly, index.those_that([&](const std::string& name) { return name == wanted; })};
    if (!found.places.empty()) return found;
    found = {How::begins, index.those_that([&](const std::string& name) { return name.starts_with(wanted); })};
    if (!found.places.empty()) return found;
    return {How::contains,
            index.those_that([&](const std::string& name) { return name.find(wanted) != std::string::npos; })};
}

}  // namespace waybreaker::site
