#include "service/source_store.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "http/problem.hpp"
#include "mapfile/digest.hpp"
#include "service/extract_json.hpp"

namespace waybreaker::service {
namespace {

constexpr std::chrono::hours longest_unused{1};
constexpr std::size_t digest_characters = 16;

std::string id_of(const std::string& bytes, const std::string& name) {
    const std::string digest = mapfile::sha256_digest(mapfile::sha256_digest(bytes) + " " + name);
    return "source-" + digest.substr(digest.find(':') + 1, digest_characters);
}

http::Problem no_such_source() {
    return {http::not_found, "there is no source of that name; POST /api/v1/sources sends one", "source-not-found"};
}

}  // namespace

void SourceStore::forget_expired() {
    const Clock::time_point now = Clock::now();
    const std::scoped_lock lock(mutex_);
    std::erase_if(slots_, [now](const auto& entry) { return now - entry.second.used > longest_unused; });
}

bool SourceStore::forget_one() {
    const std::scoped_lock lock(mutex_);
    auto first = slots_.end();
    for (auto slot = slots_.begin(); slot != slots_.end(); ++slot) {
        if (slot->second.source.use_count() > 1) continue;  // an import reads it
        if (first == slots_.end() || slot->second.used < first->second.used) first = slot;
    }
    if (first == slots_.end()) return false;
    slots_.erase(first);
    return true;
}

SharedSource SourceStore::existing(const std::string& id) {
    forget_expired();
    const std::scoped_lock lock(mutex_);
    const auto slot = slots_.find(id);
    if (slot == slots_.end()) return nullptr;
    slot->second.used = Clock::now();
    return slot->second.source;
}

// Forgets others until there is room for so many bytes.
MemoryBudget::Share SourceStore::make_room(std::size_t bytes) {
    const std::size_t most = budget_.most(MemoryBudget::Use::source);
    if (bytes > most) {
        throw http::Problem(
            http::too_large,
            fmt::format("the source has {} MB, all sources together may have {} MB (a quarter of --max-memory)",
                        bytes >> 20U, most >> 20U),
            "source-too-large");
    }
    MemoryBudget::Share share(budget_, MemoryBudget::Use::source);
    while (!share.grow(bytes)) {
        if (forget_one()) continue;
        throw http::Problem(http::unavailable, "what others use leaves no memory for this map data; ask again",
                            "no-memory");
    }
    return share;
}

SourceStore::Added SourceStore::add(std::string bytes, const std::string& name, const StopToken& stop) {
    const std::string id = id_of(bytes, name);
    if (const SharedSource known = existing(id)) {
        if (known->bytes == bytes && known->name == name) return {id, known, false};
        throw http::Problem(http::unprocessable, "another source has the id " + id + " here; delete it first");
    }
    bytes.shrink_to_fit();
    MemoryBudget::Share memory = make_room(bytes.size());
    city::Extract extract = importer_.extract(name, bytes, stop);
    const auto source = std::make_shared<const StoredSource>(
        StoredSource{name, std::move(bytes), std::move(extract), std::move(memory)});
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
    Json json{{"id", id}, {"name", source.name}, {"bytes", source.bytes.size()}};
    json.update(extract_json(source.extract));
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace waybreaker::service
