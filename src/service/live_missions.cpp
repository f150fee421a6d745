#include "service/live_missions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <random>
#include <utility>

#include "http/problem.hpp"
#include "http/server_event.hpp"
#include "io/sha256.hpp"
#include "io/state_json.hpp"
#include "service/mission_revision.hpp"
#include "service/responses.hpp"

namespace waybreaker::service {
namespace {

http::Problem no_such_mission() {
    return {http::not_found, "there is no live mission of that name; GET /api/v1/missions lists those there are",
            "mission-not-found"};
}

http::Problem too_many(std::size_t most) {
    return {http::insufficient_storage, fmt::format("{} missions are live, as many as may be (--live-missions)", most)};
}

// Not guessed from others, nor used again after a restart without a store.
std::string new_id() {
    std::random_device random;
    return fmt::format("mission-{:08x}{:08x}", random(), random());
}

// The file that a map was read from, or would be if it were one.
ArchivedMap archived(const StoredMap& map) {
    // Of a ROS map, which is two, as it is sent in one piece.
    std::string bytes =
        map.file.ros && map.bytes.empty() ? map.file.ros->text + "\n...\n" + map.file.ros->image : map.bytes;
    std::string id = MapStore::id_of(bytes, map.connectivity);
    return {.id = std::move(id), .connectivity = map.connectivity, .bytes = std::move(bytes)};
}

std::string event_text(const ReportRecord& report) {
    return http::server_event("revision", report.event, std::to_string(report.sequence));
}

std::size_t size_of(const ReportRecord& report) {
    return report.state.size() + report.plan.size() + report.event.size();
}

}  // namespace

LiveMissions::LiveMissions(MissionStore& store, MapStore& maps, PlannerPool& planners, const ServiceLimits& limits,
                           MemoryBudget& budget)
    : store_(store),
      maps_(maps),
      planners_(planners),
      budget_(budget),
      seconds_(limits.seconds),
      most_(limits.live_missions) {
    if (store_.is_shared()) following_ = std::jthread([this](const std::stop_token& stop) { follow(stop); });
}

MissionSummary LiveMissions::summary(const std::string& id) const {
    if (std::optional<MissionSummary> found = store_.mission(id)) return *std::move(found);
    throw no_such_mission();
}

void LiveMissions::require_room() const {
    if (store_.count() >= most_) throw too_many(most_);
}

LiveMissions::SharedMemory LiveMissions::memory_of(std::size_t bytes) const {
    constexpr std::size_t beside = 4096;  // tables and indices
    const auto memory = std::make_shared<MemoryBudget::Share>(budget_, MemoryBudget::Use::mission);
    if (!store_.in_memory() || memory->grow(bytes + beside)) return memory;
    throw http::Problem(http::unavailable,
                        "live missions leave no memory for this; delete one, or start the server with a --store",
                        "no-memory");
}

LiveMissions::SharedMemory LiveMissions::memory_of_map(const ArchivedMap& map) {
    {
        const std::scoped_lock lock(memory_mutex_);
        if (SharedMemory known = map_memory_[map.id].lock()) return known;
    }
    SharedMemory memory = memory_of(map.bytes.size());
    const std::scoped_lock lock(memory_mutex_);
    std::erase_if(map_memory_, [](const auto& entry) { return entry.second.expired(); });
    map_memory_[map.id] = memory;
    return memory;
}

void LiveMissions::keep(const std::string& id, const SharedMemory& memory) {
    if (!store_.in_memory()) return;
    const std::scoped_lock lock(memory_mutex_);
    if (store_.mission(id)) memory_[id].push_back(memory);  // it may have been deleted meanwhile
}

LiveMissions::Begun LiveMissions::begin(const request::LiveRequest& request, const std::string& body,
                                        const SharedMap& map, const http::Worker& worker) {
    const ReportRecord first = first_plan({map, request.map, request, planners_, seconds_}, worker);
    if (worker.stop.stop_requested()) throw http::Problem(http::unavailable, "the time is up; ask again");
    const ArchivedMap archive = archived(*map);
    const MissionRecord mission{
        .id = new_id(), .map = request.map, .archive = archive.id, .digest = map->file.digest, .request = body};
    const SharedMemory map_memory = memory_of_map(archive);
    const SharedMemory memory = memory_of(body.size() + size_of(first));
    if (!store_.add(mission, archive, first, most_)) throw too_many(most_);
    keep(mission.id, map_memory);
    keep(mission.id, memory);
    return {{mission, first.sequence, first.revision, first.now, first.status}, first};
}

// The map as it was when the mission began, wherever it is to be had.
SharedMap LiveMissions::map_of(const MissionRecord& mission) {
    try {
        const SharedMap map = maps_.load(mission.map);
        if (map->file.digest == mission.digest) return map;
    } catch (const http::Problem& problem) {
        if (problem.kind() == "no-memory") throw;
    }
    return maps_.load(mission.archive);
}

std::optional<ReportRecord> LiveMissions::answered(const MissionSummary& last, const State& state) const {
    if (state.sequence > last.sequence) return std::nullopt;
    std::optional<ReportRecord> known = store_.report(last.mission.id, state.sequence);
    if (known && known->state == io::state_json(state).dump()) return known;
    const std::string why = known ? "another report has the sequence number {}; the last one is {}"
                                  : "the report has the sequence number {}, and {} is known already: what was found "
                                    "by then can change nothing";
    throw http::Problem(http::conflict, fmt::format(fmt::runtime(why), state.sequence, last.sequence));
}

ReportRecord LiveMissions::report(const std::string& id, const State& state, const http::Worker& worker) {
    const std::unique_ptr<Turn> turn = store_.turn(id);
    const MissionSummary last = summary(id);
    if (const auto before = answered(last, state)) return *before;
    const ReportRecord held = plan(id, last.revision);
    std::vector<State> since;
    for (const ReportRecord& one : store_.reports_after(id, held.sequence))
        since.push_back(io::parse_state(one.state, "a report"));
    const LiveTask task{map_of(last.mission), last.mission.map, request::parse_live_request(last.mission.request),
                        planners_, seconds_};
    const ReportRecord next = revised_plan(task, held, since, state, worker);
    if (worker.stop.stop_requested()) throw http::Problem(http::unavailable, "the time is up; report it again");
    const SharedMemory memory = memory_of(size_of(next));
    if (!turn->add(next)) throw no_such_mission();
    keep(id, memory);
    publish(id);
    const std::scoped_lock lock(memory_mutex_);
    ++reports_[next.status];
    return next;
}

void LiveMissions::remove(const std::string& id) {
    if (!store_.remove(id)) throw no_such_mission();
    {
        const std::scoped_lock lock(memory_mutex_);
        memory_.erase(id);
    }
    const std::scoped_lock lock(audience_mutex_);
    const auto audience = audiences_.find(id);
    if (audience == audiences_.end()) return;
    send_end(audience->second);
    audiences_.erase(audience);
}

ReportRecord LiveMissions::plan(const std::string& id, std::optional<int> revision) const {
    const MissionSummary last = summary(id);
    const int wanted = revision.value_or(last.revision);
    if (std::optional<ReportRecord> found = store_.planned(id, wanted)) return *std::move(found);
    throw http::Problem(http::not_found,
                        fmt::format("the mission has no revision {}; the last one is {}", wanted, last.revision),
                        "revision-not-found");
}

std::shared_ptr<EventStream> LiveMissions::events(const std::string& id, std::optional<std::uint64_t> after) {
    const auto stream = std::make_shared<EventStream>();
    const std::scoped_lock lock(audience_mutex_);
    drop_gone();
    const MissionSummary last = summary(id);
    if (after.value_or(0) > last.sequence) {
        throw http::Problem(http::bad_request,
                            fmt::format("Last-Event-ID is above the last event's, {}", last.sequence));
    }
    Audience& audience = audiences_.try_emplace(id, Audience{.last = last.sequence}).first->second;
    send_news(id, audience);
    if (after) {
        for (const ReportRecord& report : store_.reports_after(id, *after)) {
            if (report.sequence <= audience.last) stream->push(event_text(report));
        }
    } else if (const auto report = store_.report(id, audience.last)) {
        stream->push(event_text(*report));
    }
    if (ended_) stream->end();
    audience.streams.push_back(stream);
    return stream;
}

void LiveMissions::send_news(const std::string& id, Audience& audience) {
    for (const ReportRecord& report : store_.reports_after(id, audience.last)) {
        for (const auto& stream : audience.streams) {
            if (const auto there = stream.lock()) there->push(event_text(report));
        }
        audience.last = report.sequence;
    }
}

void LiveMissions::send_end(Audience& audience) {
    for (const auto& stream : audience.streams) {
        const auto there = stream.lock();
        if (!there) continue;
        there->push(http::server_event("deleted", "{}"));
        there->end();
    }
}

void LiveMissions::drop_gone() {
    for (auto& [id, audience] : audiences_)
        std::erase_if(audience.streams, [](const auto& stream) { return stream.expired(); });
    std::erase_if(audiences_, [](const auto& entry) { return entry.second.streams.empty(); });
}

void LiveMissions::publish(const std::string& id) {
    const std::scoped_lock lock(audience_mutex_);
    const auto audience = audiences_.find(id);
    if (audience == audiences_.end()) return;
    try {
        send_news(id, audience->second);
    } catch (const http::Problem&) {  // the report is stored all the same; it is sent with the next one
    }
}

void LiveMissions::follow(const std::stop_token& stop) {
    constexpr std::chrono::milliseconds pause(250);  // streams are no faster (http::Waiting::tick)
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock lock(mutex);
    while (!stopped.wait_for(lock, stop, pause, [] { return false; }) && !stop.stop_requested()) {
        try {
            publish_others();
        } catch (const http::Problem&) {  // the store will be back
        }
    }
}

void LiveMissions::publish_others() {
    const std::scoped_lock lock(audience_mutex_);
    drop_gone();
    if (audiences_.empty()) return;
    std::map<std::string, std::uint64_t> last;
    for (const MissionSummary& mission : store_.missions()) last[mission.mission.id] = mission.sequence;
    for (auto& [id, audience] : audiences_) {
        const auto known = last.find(id);
        if (known == last.end()) {
            send_end(audience);
            audience.streams.clear();
        } else if (known->second > audience.last) {
            send_news(id, audience);
        }
    }
}

void LiveMissions::end_streams() {
    const std::scoped_lock lock(audience_mutex_);
    ended_ = true;
    for (const auto& [id, audience] : audiences_) {
        for (const auto& stream : audience.streams) {
            if (const auto there = stream.lock()) there->end();
        }
    }
}

Metrics::Missions LiveMissions::figures() const {
    Metrics::Missions figures{.most = most_};
    try {
        figures.live = store_.count();
    } catch (const http::Problem&) {  // nobody knows
    }
    {
        const std::scoped_lock lock(memory_mutex_);
        figures.reports = reports_;
    }
    const std::scoped_lock lock(audience_mutex_);
    for (const auto& [id, audience] : audiences_) {
        figures.streams +=
            std::size_t(std::ranges::count_if(audience.streams, [](const auto& stream) { return !stream.expired(); }));
    }
    return figures;
}

}  // namespace waybreaker::service
