// Numbers of XML elements and attributes, read strictly.
#pragma once

#include <optional>
#include <string>

#include "authors/xml_element.hpp"
#include "core/in_quotes.hpp"
#include "core/number.hpp"
#include "core/range.hpp"

namespace waybreaker::authors {

// Node is an XmlFile::Element or an XmlFile::Attribute.
template <class Node>
std::string described(const Node& node) {
    return std::string(node.tag()).append(" is ").append(in_quotes(node.trimmed_text()));
}

// Throws InputError unless it is a whole number from `least` to `most`.
template <class Node>
int whole_number_of(const Node& node, int least, int most) {
    const std::optional<int> value = number<int>(node.trimmed_text());
    if (value && *value >= least && *value <= most) return *value;
    throw node.error(described(node) + ", but must be a number from " + std::to_string(least) + " to " +
                     std::to_string(most));
}

// The same of any number.
template <class Node>
double number_of(const Node& node, double least, double most) {
    const std::optional<double> value = number<double>(node.trimmed_text());
    if (value && *value >= least && *value <= most) return *value;
    throw node.error(described(node) + ", but must be a number from " + number_text(least) + " to " +
                     number_text(most));
}

}  // namespace waybreaker::authors
