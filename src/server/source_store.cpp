#include "server/source_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "geo/sent_source.hpp"
#include "mapfile/digest.hpp"
#include "server/problem.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

constexpr std::chrono::hours longest_unused{1};
constexpr std::size_t digest_characters = 16;

std::string id_of(const std::string& bytes, const std::string& name) {
    const std::string digest = mapfile::sha256_digest(mapfile::sha256_digest(bytes) + " " + name);
    return "source-" + digest.substr(digest.find(':') + 1, digest_characters);
}

Problem no_such_source() {
    return {not_found, "there is no source of that name; POST /api/v1/sources sends one", "source-not-found"};
}

geo::Extract extract_of(const std::string& name, const std::shared_ptr<const std::string>& bytes,
                        const StopToken& stop) {
    const geo::SentSource source(name, bytes, stop);
    const auto require_time = [&stop] {
        if (stop.stop_requested()) throw Problem(unprocessable, "reading the source took too long", "import-too-long");
    };
    try {
        geo::Extract extract = geo::read_extract(source.path());
        require_time();
        return extract;
    } catch (const InputError& error) {
        require_time();
        throw Problem(unprocessable, source.named(error.what()), "source-unreadable");
    }
}

}  // namespace

void SourceStore::forget_expired() {
    const Clock::time_point now = Clock::now();
    std::erase_if(slots_, [now](const auto& entry) { return now - entry.second.used > longest_unused; });
}

std::size_t SourceStore::bytes_held() const {
    std::size_t bytes = 0;
    for (const auto& [id, slot] : slots_) bytes += slot.source->bytes->size();
    return bytes;
}

SharedSource SourceStore::existing(const std::string& id) {
    const std::scoped_lock lock(mutex_);
    forget_expired();
    const auto slot = slots_.find(id);
    if (slot == slots_.end()) return nullptr;
    slot->second.used = Clock::now();
    return slot->second.source;
}

// Forgets others until there is room for so many bytes.
std::unique_ptr<MapStore::Reservation> SourceStore::make_room(std::size_t bytes) {
    const std::size_t most = limits_.memory / 4;
    if (bytes > most) {
        throw Problem(
            too_large,
            fmt::format("the source has {} MB, all sources together may have {} MB (a quarter of --max-memory)",
                        bytes >> 20U, most >> 20U),
            "source-too-large");
    }
    {
        const std::scoped_lock lock(mutex_);
        while (bytes_held() + bytes > most) {
            slots_.erase(std::ranges::min_element(slots_, {}, [](const auto& entry) { return entry.second.used; }));
        }
    }
    auto room = std::make_unique<MapStore::Reservation>(maps_, true);
    room->admit(bytes);
    return room;
}

SourceStore::Added SourceStore::add(std::string bytes, const std::string& name, const StopToken& stop) {
    const std::string id = id_of(bytes, name);
    const std::scoped_lock reading(reading_);
    if (const SharedSource known = existing(id)) {
        if (*known->bytes == bytes && known->name == name) return {id, known, false};
        throw Problem(unprocessable, "another source has the id " + id + " here; delete it first");
    }
    bytes.shrink_to_fit();
    auto room = make_room(bytes.size());
    const auto shared = std::make_shared<const std::string>(std::move(bytes));
    geo::Extract extract = extract_of(name, shared, stop);
    const auto source =
        std::make_shared<const StoredSource>(StoredSource{name, shared, std::move(extract), std::move(room)});
    const std::scoped_lock lock(mutex_);
    slots_[id] = {source, Clock::now()};
    return {id, source, true};
}

SharedSource SourceStore::find(const std::string& id) {
    SharedSource source = existing(id);
    if (!source) throw no_such_source();
    return source;
}

void SourceStore::remove(const std::string& id) {
    const std::scoped_lock lock(mutex_);
    if (slots_.erase(id) == 0) throw no_such_source();
}

std::string source_json(const std::string& id, const StoredSource& source) {
    using Json = nlohmann::ordered_json;
    const geo::Extract& extract = source.extract;
    Json places = Json::array();
    for (const geo::NamedPlace& place : extract.places) places.push_back({{"name", place.name}, {"at", place.at}});
    return Json{{"id", id},
                {"name", source.name},
                {"bytes", source.bytes->size()},
                {"bounds", extract.bounds},
                {"buildings", extract.buildings},
                {"columns", extract.columns},
                {"rows", extract.rows},
                {"built", extract.built},
                {"densest", {{"center", extract.densest}, {"size", extract.side}}},
                {"places", std::move(places)}}
               .dump(-1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

}  // namespace waybreaker::server
