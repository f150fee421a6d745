// The tags of one feature, without GDAL.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "city/obstacle_choice.hpp"

namespace waybreaker::city {

class TagSet {
  public:
    // Of letters in keys.
    enum class Case { matters, ignored };

    TagSet() = default;
    // Of several with one key the first counts.
    explicit TagSet(std::vector<std::pair<std::string, std::string>> tags, Case letters = Case::matters)
        : tags_(std::move(tags)), letters_(letters) {}

    // Null if there is no such tag.
    const std::string* find(std::string_view key) const;
    // Whether there is one that does not say no.
    bool says(std::string_view key) const;
    bool is(std::string_view key, std::string_view value) const;
    bool matches(const TagFilter& filter) const;
    // A filter for the key "*" matches anything.
    bool matches_any(const std::vector<TagFilter>& filters) const;
    // The number a tag begins with ("12 m").
    std::optional<double> number(std::string_view key) const;

  private:
    std::vector<std::pair<std::string, std::string>> tags_;
    Case letters_ = Case::matters;
};

// The number a text begins with.
std::optional<double> leading_number(const std::string& text);

}  // namespace waybreaker::city
