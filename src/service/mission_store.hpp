// Mission store: live missions, what was reported of them and what came of it, in an SQLite database. What a call has
// added is there after kill -9 and power cuts once the call has returned.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "service/map_archive.hpp"

namespace waybreaker::service {

struct MissionRecord {
    std::string id = {};
    std::string map = {};      // as the client names it
    std::string archive = {};  // the map's id in the archive
    std::string digest = {};   // of the map's file
    std::string request = {};  // the body that it began with
};

// A report and what came of it; the first one, of sequence 0, is the mission's beginning.
struct ReportRecord {
    std::uint64_t sequence = 0;
    int revision = 0;  // of the plan that holds from then on
    double now = 0;    // units of time
    std::string status = {};
    std::string state = {};  // waybreaker-state/1
    std::string plan = {};   // the plan document; empty if none came of it
    std::string event = {};  // a JSON object: what clients that listen learn of it
};

// Thread-safe. Calls throw Problem if the database cannot be read or written; then nothing has changed.
class MissionStore : public MapArchive {
  public:
    // Opens or begins the file; no other process can open it until it is closed. Empty: in memory. Throws InputError,
    // with the remedy, if it is a file of something else, of another version, damaged, or in use; it is unchanged then.
    explicit MissionStore(const std::string& path);

    bool in_memory() const { return path_.empty(); }

    // All missions, each with its last report, but without request, state, plan and event.
    std::vector<std::pair<MissionRecord, ReportRecord>> missions();
    MissionRecord mission(const std::string& id);

    void add(const MissionRecord& mission, const ArchivedMap& map, const ReportRecord& first);
    void add(const std::string& mission, const ReportRecord& report);
    // With its map, if no other mission is on that.
    void remove(const std::string& mission);

    std::optional<ReportRecord> report(const std::string& mission, std::uint64_t sequence);
    // The report that the plan of that revision came of.
    std::optional<ReportRecord> planned(const std::string& mission, int revision);
    // Those of higher sequence, in order, without their plans.
    std::vector<ReportRecord> reports_after(const std::string& mission, std::uint64_t sequence);

    bool holds(const std::string& id) const override;
    std::vector<std::string> sent() const override;
    std::optional<ArchivedMap> read(const std::string& id) override;

  private:
    template <class Act>
    auto guarded(Act act);
    void begin();
    void list_archive();
    std::vector<ReportRecord> select(const char* plan, const char* where, const std::string& mission,
                                     std::int64_t number);
    void insert(const std::string& mission, const ReportRecord& report);

    std::string path_;
    std::mutex mutex_;
    SQLite::Database sql_;
    mutable std::mutex archive_mutex_;      // so that asking for ids waits for no disk
    std::map<std::string, bool> archived_;  // whether it was sent
};

}  // namespace waybreaker::service
