// Mission store: live missions, what was reported of them and what came of it, in an SQLite file for one server, or in
// a PostgreSQL database for several. What a call has added is there after kill -9 and power cuts once the call has
// returned.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "service/limits.hpp"
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

// A mission, and how far its last report has brought it.
struct MissionSummary {
    MissionRecord mission;
    std::uint64_t sequence = 0;
    int revision = 0;
    double now = 0;
    std::string status = {};
};

// The turn to revise a mission: while it lasts nobody else revises that mission, on any server of the store.
class Turn {
  public:
    virtual ~Turn() = default;
    // Adds what came of a report, as the last act of the turn. False if the mission is gone. Throws Problem if it
    // cannot be stored, or the turn has lasted too long and has been given to another.
    virtual bool add(const ReportRecord& report) = 0;
};

// Thread-safe. Calls throw Problem if the store cannot be read or written; then nothing has changed, but that a change
// whose answer got lost may have been made.
class MissionStore : public MapArchive {
  public:
    virtual bool in_memory() const { return false; }
    // Whether other servers may change it meanwhile.
    virtual bool is_shared() const { return false; }

    virtual std::size_t count() = 0;
    // By id, without their requests.
    virtual std::vector<MissionSummary> missions() = 0;
    virtual std::optional<MissionSummary> mission(const std::string& id) = 0;

    // False if `most` missions are live already. Throws Problem if another map has its map's id.
    virtual bool add(const MissionRecord& mission, const ArchivedMap& map, const ReportRecord& first,
                     std::size_t most) = 0;
    // With its map, if no other mission is on that and nobody has sent it. False if there is no such mission.
    virtual bool remove(const std::string& mission) = 0;
    // Waits until it is free. The store must outlive it.
    virtual std::unique_ptr<Turn> turn(const std::string& mission) = 0;

    virtual std::optional<ReportRecord> report(const std::string& mission, std::uint64_t sequence) = 0;
    // The report that the plan of that revision came of.
    virtual std::optional<ReportRecord> planned(const std::string& mission, int revision) = 0;
    // Those of higher sequence, in order, without their plans.
    virtual std::vector<ReportRecord> reports_after(const std::string& mission, std::uint64_t sequence) = 0;
};

using Log = std::function<void(const std::string& line)>;

// Opens or begins the store: a file, a database by its URL, postgresql://..., or, empty, one in memory. Throws
// InputError, with the remedy, if it cannot be had.
std::unique_ptr<MissionStore> open_store(const std::string& where, const ServiceLimits& limits, const Log& log);

}  // namespace waybreaker::service
