// Many missions on one map, over several threads.
#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// Threads that are waited for, whatever happens: std::jthread, which not every standard library has.
class Joined {
  public:
    Joined() = default;
    Joined(const Joined&) = delete;
    Joined& operator=(const Joined&) = delete;
    ~Joined() {
        for (std::thread& thread : threads_) thread.join();
    }
    template <class Work>
    void start(const Work& work) {
        threads_.emplace_back(work);
    }

  private:
    std::vector<std::thread> threads_;
};

}  // namespace

std::vector<BatchPlan> plan_all(const Map& map, std::span<const Mission> missions, const Method& method,
                                const Limits& limits, unsigned threads) {
    std::vector<BatchPlan> plans(missions.size());
    std::vector<std::exception_ptr> failures(missions.size());  // no fault of the missions: memory ran out, say
    std::atomic<std::size_t> next = 0;
    // Each thread takes the next mission; where a plan lands does not depend on who makes it.
    const auto work = [&] {
        MissionPlanner planner;
        for (std::size_t i = next++; i < missions.size(); i = next++) {
            try {
                plans[i].plan = planner.plan(map, missions[i], method, limits);
            } catch (const InputError& error) {
                plans[i].error = error.what();
            } catch (...) {
                failures[i] = std::current_exception();
            }
        }
    };
    const std::size_t wanted = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
    {
        Joined others;
        for (std::size_t i = 1; i < std::min(wanted, missions.size()); ++i) others.start(work);
        work();
    }
    for (const std::exception_ptr& failure : failures) {
        if (failure) std::rethrow_exception(failure);
    }
    return plans;
}

}  // namespace waybreaker
