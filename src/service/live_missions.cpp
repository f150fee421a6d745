#include "service/live_missions.hpp"

#include <fmt/format.h>

#include <algorithm>
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
    for (const auto& [mission, last] : store_.missions()) insert(mission, last);
}

std::shared_ptr<LiveMissions::Live> LiveMissions::insert(const MissionRecord& mission, const ReportRecord& last) {
    const auto live = std::make_shared<Live>();
    live->last = {mission, last.sequence, last.revision, last.now, last.status};
    live->last.mission.request.clear();
    return live_[mission.id] = live;
}

std::shared_ptr<LiveMissions::Live> LiveMissions::known(const std::string& id) const {
    const auto found = live_.find(id);
    if (found == live_.end()) throw no_such_mission();
    return found->second;
}

std::shared_ptr<LiveMissions::Live> LiveMissions::find(const std::string& id) const {
    const std::scoped_lock lock(mutex_);
    return known(id);
}

std::vector<LiveMissions::Summary> LiveMissions::list() const {
    const std::scoped_lock lock(mutex_);
    std::vector<Summary> all;
    for (const auto& [id, live] : live_) all.push_back(live->last);
    return all;
}

LiveMissions::Summary LiveMissions::summary(const std::string& id) const {
    const std::scoped_lock lock(mutex_);
    return known(id)->last;
}

LiveMissions::Place::~Place() {
    if (taken_) return;
    const std::scoped_lock lock(missions_.mutex_);
    --missions_.places_;
}

std::shared_ptr<LiveMissions::Place> LiveMissions::place() {
    const std::scoped_lock lock(mutex_);
    if (live_.size() + places_ >= most_) {
        throw http::Problem(http::insufficient_storage,
                            fmt::format("{} missions are live, as many as may be (--live-missions)", most_));
    }
    const auto place = std::make_shared<Place>(*this);
    ++places_;
    return place;
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
        const std::scoped_lock lock(mutex_);
        if (SharedMemory known = map_memory_[map.id].lock()) return known;
    }
    SharedMemory memory = memory_of(map.bytes.size());
    const std::scoped_lock lock(mutex_);
    std::erase_if(map_memory_, [](const auto& entry) { return entry.second.expired(); });
    map_memory_[map.id] = memory;
    return memory;
}

LiveMissions::Begun LiveMissions::begin(const request::LiveRequest& request, const std::string& body,
                                        const SharedMap& map, Place& place, const http::Worker& worker) {
    const ReportRecord first = first_plan({map, request.map, request, planners_, seconds_}, worker);
    if (worker.stop.stop_requested()) throw http::Problem(http::unavailable, "the time is up; ask again");
    const ArchivedMap archive = archived(*map);
    const MissionRecord mission{
        .id = new_id(), .map = request.map, .archive = archive.id, .digest = map->file.digest, .request = body};
    SharedMemory map_memory = memory_of_map(archive);
    SharedMemory memory = memory_of(body.size() + size_of(first));
    const std::scoped_lock lock(mutex_);
    store_.add(mission, archive, first);
    const std::shared_ptr<Live> live = insert(mission, first);
    live->memory = {std::move(memory), std::move(map_memory)};
    place.taken_ = true;
    --places_;
    return {live->last, first};
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

std::optional<ReportRecord> LiveMissions::answered(const Summary& last, const State& state) const {
    if (state.sequence > last.sequence) return std::nullopt;
    std::optional<ReportRecord> known = store_.report(last.mission.id, state.sequence);
    if (known && known->state == io::state_json(state).dump()) return known;
    const std::string why = known ? "another report has the sequence number {}; the last one is {}"
                                  : "the report has the sequence number {}, and {} is known already: what was found "
                                    "by then can change nothing";
    throw http::Problem(http::conflict, fmt::format(fmt::runtime(why), state.sequence, last.sequence));
}

void LiveMissions::commit(Live& live, const ReportRecord& report) {
    const std::string& id = live.last.mission.id;
    if (known(id).get() != &live) throw no_such_mission();
    store_.add(id, report);
    live.last.sequence = report.sequence;
    live.last.revision = report.revision;
    live.last.now = report.now;
    live.last.status = report.status;
    ++reports_[report.status];
    std::erase_if(live.streams, [](const auto& stream) { return stream.expired(); });
    for (const auto& stream : live.streams) {
        if (const auto there = stream.lock()) there->push(event_text(report));
    }
}

ReportRecord LiveMissions::report(const std::string& id, const State& state, const http::Worker& worker) {
    const std::shared_ptr<Live> live = find(id);
    const std::scoped_lock turn(live->reporting);
    const Summary last = summary(id);
    if (const auto before = answered(last, state)) return *before;
    const ReportRecord held = plan(id, last.revision);
    std::vector<State> since;
    for (const ReportRecord& one : store_.reports_after(id, held.sequence))
        since.push_back(io::parse_state(one.state, "a report"));
    const MissionRecord mission = store_.mission(id);
    if (mission.id.empty()) throw no_such_mission();
    const LiveTask task{map_of(mission), mission.map, request::parse_live_request(mission.request), planners_,
                        seconds_};
    const ReportRecord next = revised_plan(task, held, since, state, worker);
    if (worker.stop.stop_requested()) throw http::Problem(http::unavailable, "the time is up; report it again");
    const SharedMemory memory = memory_of(size_of(next));
    const std::scoped_lock lock(mutex_);
    commit(*live, next);
    if (store_.in_memory()) live->memory.push_back(memory);
    return next;
}

void LiveMissions::remove(const std::string& id) {
    const std::scoped_lock lock(mutex_);
    const std::shared_ptr<Live> live = known(id);
    store_.remove(id);
    live_.erase(id);
    for (const auto& stream : live->streams) {
        const auto there = stream.lock();
        if (!there) continue;
        there->push(http::server_event("deleted", "{}"));
        there->end();
    }
}

ReportRecord LiveMissions::plan(const std::string& id, std::optional<int> revision) const {
    const int wanted = revision.value_or(summary(id).revision);
    if (std::optional<ReportRecord> found = store_.planned(id, wanted)) return *std::move(found);
    throw http::Problem(http::not_found,
                        fmt::format("the mission has no revision {}; the last one is {}", wanted, summary(id).revision),
                        "revision-not-found");
}

std::shared_ptr<EventStream> LiveMissions::events(const std::string& id, std::optional<std::uint64_t> after) {
    const auto stream = std::make_shared<EventStream>();
    const std::scoped_lock lock(mutex_);
    const std::shared_ptr<Live> live = known(id);
    if (after.value_or(0) > live->last.sequence) {
        throw http::Problem(http::bad_request,
                            fmt::format("Last-Event-ID is above the last event's, {}", live->last.sequence));
    }
    if (after) {
        for (const ReportRecord& report : store_.reports_after(id, *after)) stream->push(event_text(report));
    } else if (const auto last = store_.report(id, live->last.sequence)) {
        stream->push(event_text(*last));
    }
    if (ended_) stream->end();
    std::erase_if(live->streams, [](const auto& one) { return one.expired(); });
    live->streams.push_back(stream);
    return stream;
}

void LiveMissions::end_streams() {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    for (const auto& [id, live] : live_) {
        for (const auto& stream : live->streams) {
            if (const auto there = stream.lock()) there->end();
        }
    }
}

Metrics::Missions LiveMissions::figures() const {
    const std::scoped_lock lock(mutex_);
    Metrics::Missions figures{.live = live_.size(), .most = most_, .streams = 0, .reports = reports_};
    for (const auto& [id, live] : live_) {
        figures.streams +=
            std::size_t(std::ranges::count_if(live->streams, [](const auto& stream) { return !stream.expired(); }));
    }
    return figures;
}

}  // namespace waybreaker::service
