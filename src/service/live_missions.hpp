// Live missions: plans that are being executed. What is reported of one revises its plan; all of it is in the store
// before it is acknowledged, and what memory holds of a mission can be made again from there.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
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

    struct Summary {
        MissionRecord mission;  // without the request
        std::uint64_t sequence = 0;
        int revision = 0;
        double now = 0;
        std::string status;  // of the last report
    };
    std::vector<Summary> list() const;
    // This and what follows throw Problem if there is no such mission.
    Summary summary(const std::string& id) const;

    // A place for one more live mission, kept while the mission is about to begin.
    class Place {
      public:
        explicit Place(LiveMissions& missions) : missions_(missions) {}
        Place(const Place&) = delete;
        Place& operator=(const Place&) = delete;
        ~Place();

      private:
        friend class LiveMissions;
        LiveMissions& missions_;
        bool taken_ = false;
    };
    // Throws Problem if no more missions may be live.
    std::shared_ptr<Place> place();

    struct Begun {
        Summary summary;
        ReportRecord first;
    };
    // To be called by a worker. Throw Problem if nothing comes of it: then nothing has changed.
    Begun begin(const request::LiveRequest& request, const std::string& body, const SharedMap& map, Place& place,
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
    struct Live {
        std::mutex reporting;  // held while a report is at work; locked before LiveMissions::mutex_
        // Guarded by LiveMissions::mutex_:
        Summary last;
        std::vector<std::weak_ptr<EventStream>> streams;
        std::vector<SharedMemory> memory;  // of what a store in memory holds of it, and of its map
    };

    std::shared_ptr<Live> find(const std::string& id) const;
    SharedMap map_of(const MissionRecord& mission);
    // What was answered to that report, if it is known. Throws Problem if another has its number, or it comes too late.
    std::optional<ReportRecord> answered(const Summary& last, const State& state) const;
    SharedMemory memory_of(std::size_t bytes) const;
    SharedMemory memory_of_map(const ArchivedMap& map);
    // With mutex_ locked:
    std::shared_ptr<Live> known(const std::string& id) const;
    std::shared_ptr<Live> insert(const MissionRecord& mission, const ReportRecord& last);
    void commit(Live& live, const ReportRecord& report);

    MissionStore& store_;
    MapStore& maps_;
    PlannerPool& planners_;
    MemoryBudget& budget_;
    double seconds_;
    std::size_t most_;
    mutable std::mutex mutex_;  // never held while a map is read or a plan is made
    std::map<std::string, std::shared_ptr<Live>> live_;
    std::map<std::string, std::weak_ptr<MemoryBudget::Share>>
        map_memory_;          // of maps that missions share, by id in the archive
    std::size_t places_ = 0;  // of missions that are about to begin
    bool ended_ = false;
    std::map<std::string, std::uint64_t> reports_;
};

}  // namespace waybreaker::service
