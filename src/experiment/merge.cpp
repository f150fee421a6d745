#include "experiment/merge.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "experiment/database.hpp"
#include "experiment/results.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

namespace fs = std::filesystem;

// By number of the shard.
std::map<std::uint32_t, std::string> checked(std::span<const std::string> shards) {
    std::map<std::uint32_t, std::string> found;
    std::string digest;
    std::string version;
    std::uint32_t count = 0;
    for (const std::string& path : shards) {
        Results results(path);
        if (found.empty()) {
            digest = results.experiment().digest;
            version = results.version();
            count = results.shard().count;
        }
        if (results.experiment().digest != digest) {
            throw InputError(path, 0, "holds another experiment than " + found.begin()->second);
        }
        if (results.version() != version) {
            throw InputError(path, 0,
                             fmt::format("was made by waybreaker {}, {} by {}: their results do not belong "
                                         "together",
                                         results.version(), found.begin()->second, version));
        }
        const Shard shard = results.shard();
        if (shard.count != count) {
            throw InputError(
                path, 0, fmt::format("is one of {} shards, {} one of {}", shard.count, found.begin()->second, count));
        }
        if (const std::size_t missing = results.missing(); missing > 0) {
            throw InputError(path, 0,
                             fmt::format("is not complete, {} results are missing: run shard {}/{} again", missing,
                                         shard.index, count));
        }
        const auto [entry, is_new] = found.emplace(shard.index, path);
        if (!is_new) throw InputError(path, 0, fmt::format("is shard {}, and so is {}", shard.index, entry->second));
    }
    for (std::uint32_t index = 1; index <= count; ++index) {
        if (!found.contains(index)) throw InputError(fmt::format("shard {}/{} is missing", index, count));
    }
    return found;
}

void copy(Database& to, const std::string& shard, bool first) {
    SQLite::Statement attach(to.sql(), "ATTACH ? AS shard");
    attach.bind(1, shard);
    attach.exec();
    {
        SQLite::Transaction transaction(to.sql());
        if (first) {
            make_tables(to.sql());
            for (const char* table : {"experiment", "sets", "maps", "configurations"}) {
                to.sql().exec(fmt::format("INSERT INTO main.{0} SELECT * FROM shard.{0}", table));
            }
            to.sql().exec("UPDATE experiment SET value = '1' WHERE key IN ('shard', 'shards')");
        }
        for (const char* table : {"missions", "results"}) {
            to.sql().exec(fmt::format("INSERT INTO main.{0} SELECT * FROM shard.{0}", table));
        }
        transaction.commit();
    }
    attach.reset();
    to.sql().exec("DETACH shard");
}

}  // namespace

void merge(std::span<const std::string> shards, const std::string& output) {
    if (fs::exists(output)) throw InputError(output, 0, "exists: give a new name");
    const std::map<std::uint32_t, std::string> found = checked(shards);
    const std::string part = output + ".part";
    fs::remove(part);
    try {
        Database database(part, Access::create);
        database.guarded([&] {
            for (const auto& [index, path] : found) copy(database, path, index == 1);
        });
    } catch (...) {
        fs::remove(part);
        throw;
    }
    fs::rename(part, output);
}

}  // namespace waybreaker::experiment
