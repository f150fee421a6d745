// Live missions: plans that are being executed. What is reported of one revises its plan; all of it is in the store
// before it is acknowledged, and the store alone says how far a mission is: other servers may share it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "http/job_queue.hpp"
#include "request/plan_request.hpp"
#include "service/event_stream.hpp"
#include "service/limits.hpp"
#include "service/map_store.hpp"
#include "service/memory_budget.hpp"
#include "service/metrics.hpp"
#include "service/mission_store.hpp"
#include "service/planner_pool.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::service {

class LiveMissions {
  public:
    // Goes on with the missions of the store. Keeps the references.
    LiveMissions(MissionStore& store, MapStore& maps, PlannerPool& planners, const ServiceLimits& limits,
                 MemoryBudget& budget);

    std::vector<MissionSummary> list() const { return store_.missions(); }
    // This and what follows throw Problem if there is no such mission.
    MissionSummary summary(const std::string& id) const;

    // Throws Problem if no more missions may be live: before one is planned, and again when it begins.
    void require_room() const;

    struct Begun {
        MissionSummary summary;
        ReportRecord first;
    };
    // To be called by a worker. Throw Problem if nothing comes of it: then nothing has changed.
    Begun begin(const request::LiveRequest& request, const std::string& body, const SharedMap& map,
                const http::Worker& worker);
    // One after the other for each mission. What a report that is known already gave, it gives again.
    ReportRecord report(const std::string& id, const State& state, const http::Worker& worker);

    void remove(const std::string& id);
    // That with the plan of a revision; empty: of the last one. Throws Problem if there is none.
    ReportRecord plan(const std::string& id, std::optional<int> revision) const;

    // What is reported after that sequence number; empty: the last report, and what comes.
    std::shared_ptr<EventStream> events(const std::string& id, std::optional<std::uint64_t> after);
    // Ends all streams, and those to come.
    void end_streams();

    Metrics::Missions figures() const;

  private:
    using SharedMemory = std::shared_ptr<MemoryBudget::Share>;
    // Who listens to a mission, and the last report that they have all been sent.
    struct Audience {
        std::uint64_t last = 0;
        std::vector<std::weak_ptr<EventStream>> streams = {};
    };

    SharedMap map_of(const MissionRecord& mission);
    // What was answered to that report, if it is known. Throws Problem if another has its number, or it comes too late.
    std::optional<ReportRecord> answered(const MissionSummary& last, const State& state) const;
    SharedMemory memory_of(std::size_t bytes) const;
    SharedMemory memory_of_map(const ArchivedMap& map);
    void keep(const std::string& id, const SharedMemory& memory);

    // Sends the news of a mission to who listens here.
    void publish(const std::string& id);
    // Sends, again and again, what other servers have added.
    void follow(const std::stop_token& stop);
    void publish_others();
    // With audience_mutex_ locked:
    void send_news(const std::string& id, Audience& audience);
    static void send_end(Audience& audience);
    void drop_gone();

    MissionStore& store_;
    MapStore& maps_;
    PlannerPool& planners_;
    MemoryBudget& budget_;
    double seconds_;
    std::size_t most_;

    mutable std::mutex memory_mutex_;
    // Of what a store in memory holds of each mission, and of its map; and of the maps, by their ids in the archive.
    std::map<std::string, std::vector<SharedMemory>> memory_;
    std::map<std::string, std::weak_ptr<MemoryBudget::Share>> map_memory_;
    std::map<std::string, std::uint64_t> reports_;

    mutable std::mutex audience_mutex_;
    std::map<std::string, Audience> audiences_;  // by mission
    bool ended_ = false;
    std::jthread following_;
};

}  // namespace waybreaker::service
