#include "service/route.hpp"

#include "service/map_store.hpp"

namespace waybreaker::service {

std::optional<std::string> Route::id_in(const std::string& asked) const {
    const std::size_t place = path.find("{id}");
    if (place == std::string::npos) return asked == path ? std::optional(std::string()) : std::nullopt;
    const std::string before = path.substr(0, place);
    const std::string after = path.substr(place + 4);
    if (asked.size() < path.size() - 4 || !asked.starts_with(before) || !asked.ends_with(after)) return std::nullopt;
    const std::string id = asked.substr(place, asked.size() - (path.size() - 4));
    return MapStore::is_id(id) ? std::optional(id) : std::nullopt;
}

}  // namespace waybreaker::service
