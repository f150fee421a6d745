#include "http/message.hpp"

#include <algorithm>

#include "http/header_list.hpp"

namespace waybreaker::http {
namespace {

// Names are case-insensitive (RFC 9110, 5.1).
auto is_named(std::string_view name) {
    return [name](const Fields::Field& field) { return same_word(field.first, name); };
}

}  // namespace

std::optional<std::string> Fields::find(std::string_view name) const {
    std::optional<std::string> joined;
    for (const Field& field : fields_) {
        if (is_named(name)(field)) joined = joined ? *joined + ", " + field.second : field.second;
    }
    return joined;
}

std::string Fields::get(std::string_view name) const {
    return find(name).value_or("");
}

std::size_t Fields::count(std::string_view name) const {
    return std::size_t(std::count_if(fields_.begin(), fields_.end(), is_named(name)));
}

void Fields::add(std::string name, std::string value) {
    fields_.emplace_back(std::move(name), std::move(value));
}

void Fields::set(std::string name, std::string value) {
    remove(name);
    add(std::move(name), std::move(value));
}

void Fields::remove(std::string_view name) {
    std::erase_if(fields_, is_named(name));
}

Body::Body(std::string bytes) {
    const auto owner = std::make_shared<const std::string>(std::move(bytes));
    bytes_ = *owner;
    owner_ = owner;
    own_ = true;
}

}  // namespace waybreaker::http
