#include "rehearse/executor.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "rehearse/actor.hpp"
#include "rehearse/draws.hpp"
#include "rehearse/foresight.hpp"
#include "rehearse/outcome.hpp"
#include "rehearse/trail.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker::rehearsal {
namespace {

// What happens within so long happens at once: revisions look at times of plans, which are rounded.
constexpr double at_once = 1e-6;
constexpr int most_revisions = 1000;

class Execution {
  public:
    Execution(const Scene& scene, std::uint64_t run, Planner& planner, std::vector<double>& revise_ms)
        : scene_(scene),
          draws_(scene.options.seed, run),
          planner_(planner),
          revise_ms_(revise_ms),
          map_(&scene.map),
          mission_(&scene.mission),
          plan_(&scene.plan),
          tries_(scene.map.obstacles().size() + 1, 0) {
        for (std::size_t i = 0; i < scene.plan.agents.size(); ++i) {
            Actor& actor = actors_.emplace_back(scene.mission.agents[i], i);
            draw_news(actor, length_of(scene.plan.agents[i].path));
            acting_.push_back(i);
        }
        if (scene.plan.revised) now_ = scene.plan.revised->now;
        if (scene.plan.revised) sequence_ = scene.plan.revised->sequence;
        coming_ = scene.mission.rules.opened;
        std::ranges::stable_sort(coming_, std::ranges::greater(), &TimedOpening::at);
    }

    Rehearsed play() {
        open_by(now_);
        adopt(scene_.scripts);
        heed_news();
        while (result_.ending == Ending::arrived && !everybody_ended()) step();
        for (Actor& actor : actors_) log_end(actor);
        sum_up(scene_, std::move(actors_), events_, now_, result_);
        return std::move(result_);
    }

  private:
    void draw_news(Actor& actor, double length) {
        const bool flies = actor.kind == AgentKind::air;
        const double chance = flies ? scene_.options.lost : scene_.options.blocked;
        if (draws_.share(flies ? Chance::is_lost : Chance::is_blocked, actor.number) >= chance) return;
        actor.news = length * draws_.share(flies ? Chance::lost_at : Chance::blocked_at, actor.number);
    }

    bool everybody_ended() const {
        return std::ranges::all_of(actors_, [](const Actor& actor) { return actor.ended(); });
    }

    // The next event, and all that happen at once with it; then, if there is news, a new plan.
    void step() {
        const auto next = std::ranges::min_element(actors_, {}, &Actor::event);
        if (!coming_.empty() && coming_.back().at <= next->event()) return open_by(coming_.back().at);
        if (next->event() == never) {
            result_.ending = Ending::stuck;
            return;
        }
        happen(*next);
        while (news_ && result_.ending == Ending::arrived) {
            const auto other = std::ranges::min_element(actors_, {}, &Actor::event);
            if (other->event() > now_ + at_once) break;
            happen(*other);
        }
        heed_news();
    }

    void heed_news() {
        while (news_ && result_.ending == Ending::arrived) revise_plan();
    }

    // What others open.
    void open_by(double time) {
        now_ = std::max(now_, time);
        for (; !coming_.empty() && coming_.back().at <= now_; coming_.pop_back())
            events_.opened.push_back(coming_.back());
        wake();
    }

    void happen(Actor& actor) {
        now_ = std::max(now_, actor.event());
        if (actor.emptied_at() < actor.until) return lose(actor, result_.emptied);
        switch (actor.phase) {
            case Phase::held:
            case Phase::waiting:
                actor.until = never;
                return go_on(actor);
            case Phase::at_work:
                return finish_work(actor);
            case Phase::moving:
                return move(actor);
            case Phase::arrived:
            case Phase::lost:
                actor.until = never;
        }
    }

    // Where it is by now.
    void log(Actor& actor) const { actor.trail.add(actor.at(now_), now_); }

    // Not of who has left the map, or is lost.
    void log_end(Actor& actor) const {
        const bool left = actor.phase == Phase::arrived && scene_.mission.rules.at_goal == AtGoal::leave;
        if (!left && actor.phase != Phase::lost) log(actor);
    }

    static void stand(Actor& actor, Phase phase, double until = never) {
        actor.phase = phase;
        actor.until = until;
    }

    // Leaves the stop, or finds out why not.
    void go_on(Actor& actor) {
        const Stop& here = actor.here();
        const auto stands = [&](ObstacleId id) { return !is_open(id); };
        const bool waits = std::ranges::any_of(here.waits, [&](std::size_t k) { return !happened_[k]; }) ||
                           std::ranges::any_of(here.gates, stands);
        if (waits) return stand(actor, Phase::waiting);
        if (here.not_before > now_) return stand(actor, Phase::held, here.not_before);
        if (here.on_time && now_ > here.not_before + at_once && stops_before_zone(actor)) return;
        if (actor.stop + 1 == actor.script.size()) {
            if (actor.phase != Phase::arrived) actor.arrived_at = now_;
            result_.on_reserve += actor.land(now_) ? 1 : 0;
            return stand(actor, Phase::arrived);
        }
        const Stop& next = actor.script[actor.stop + 1];
        if (next.at == here.at) {
            if (next.work == 0) return get_to_next(actor);
            result_.on_reserve += actor.begin_work(next, now_) ? 1 : 0;
            return stand(actor, Phase::at_work, now_ + next.work);
        }
        if (here.share == 0 && !actor.rolls && !actor.delayed) {
            actor.delayed = true;
            const double delay = draws_.delay(scene_.options.delay, actor.number, actor.moves++);
            if (delay > 0) return stand(actor, Phase::held, now_ + delay);
        }
        log(actor);
        actor.take_off(now_);
        actor.phase = Phase::moving;
        actor.since = now_;
        const double length = actor.to_next();
        const bool news_on_the_way = actor.driven <= actor.news && actor.news < actor.driven + length;
        actor.until = now_ + (news_on_the_way ? actor.news - actor.driven : length) / actor.speed;
    }

    // Whether one that is late has to: until there is a new plan, or until the zone is over where no plan helps.
    bool stops_before_zone(Actor& actor) {
        const double later = foresight_->may_go_on(actor, now_);
        if (later <= now_) return false;
        stand(actor, Phase::waiting);
        if (std::exchange(actor.barred_at, now_) != now_) {
            news_ = true;
        } else if (later != never) {
            actor.until = later;
        } else {
            result_.ending = Ending::no_way;
        }
        return true;
    }

    void move(Actor& actor) {
        const double length = actor.to_next();
        if (actor.driven <= actor.news && actor.news < actor.driven + length) {
            actor.news = never;
            actor.until = std::max(now_, actor.since + length / actor.speed);
            return actor.kind == AgentKind::air ? lose(actor, result_.lost) : find_blocked_street(actor);
        }
        actor.driven += length;
        get_to_next(actor);
    }

    void get_to_next(Actor& actor) {
        ++actor.stop;
        actor.rolls = false;
        actor.delayed = false;
        actor.phase = Phase::waiting;
        log(actor);
        // What takes no time is done on arrival.
        const std::vector<ObstacleId>& breaches = actor.here().breaches;
        if (!breaches.empty() && actor.work.empty() && !try_breaches(breaches)) return stand(actor, Phase::waiting);
        actor.work.clear();
        signal(actor);
        go_on(actor);
    }

    void finish_work(Actor& actor) {
        const std::vector<ObstacleId> work = actor.work;
        // By the plan it is done at the next stop; where the plan has changed meanwhile, here.
        const bool planned = actor.ends_work_as_planned();
        if (!try_breaches(work)) {
            actor.work.clear();
            if (planned) ++actor.stop;
            return stand(actor, Phase::waiting);
        }
        if (planned) return get_to_next(actor);
        actor.work.clear();
        go_on(actor);
    }

    // Whether all of them succeed.
    bool try_breaches(const std::vector<ObstacleId>& breaches) {
        bool all = true;
        for (const ObstacleId id : breaches) {
            const std::uint64_t count = id.value < tries_.size() ? tries_[id.value]++ : 0;
            if (draws_.share(Chance::fails, id.value, count) < scene_.options.fail) {
                ++result_.failed;
                failed_.push_back({id, now_});
                news_ = true;
                all = false;
            } else {
                events_.opened.push_back({id, now_});
            }
        }
        wake();
        return all;
    }

    bool is_open(ObstacleId id) const {
        return std::ranges::find(events_.opened, id, &TimedOpening::obstacle) != events_.opened.end();
    }

    void signal(Actor& actor) {
        const std::vector<std::size_t>& signals = actor.here().signals;
        for (const std::size_t k : signals) happened_[k] = true;
        if (!signals.empty()) wake();
    }

    // Those that wait look again.
    void wake() {
        for (Actor& actor : actors_) {
            if (actor.phase == Phase::waiting && !actor.script.empty() && actor.until == never) actor.until = now_;
        }
    }

    void lose(Actor& actor, int& count) {
        ++count;
        log(actor);
        // The plan counts on a breach that had begun before it was made.
        for (const ObstacleId id : actor.work) {
            if (opens_by_itself(mission_->rules, id)) failed_.push_back({id, now_});
        }
        actor.work.clear();
        actor.lost_at = actor.at(now_);
        actor.took_off = never;
        stand(actor, Phase::lost);
        news_ = true;
    }

    void find_blocked_street(Actor& finder) {
        const std::optional<Point> place = finder.ahead(scene_.options.sight, now_);
        if (!place) return;
        Found found{rubble_at(*map_, *place, actors_, now_)};
        if (found.cells.empty()) return;
        ++result_.blocked;
        events_.rubble.push_back({found.cells, now_});
        found_.push_back(std::move(found));
        news_ = true;
    }

    State state() {
        State state{.sequence = ++sequence_, .now = now_};
        for (const std::size_t i : acting_) {
            const Actor& actor = actors_[i];
            state.agents.push_back(actor.state(now_));
            if (actor.phase != Phase::at_work) continue;
            for (const ObstacleId id : actor.work) state.opened.push_back({id, actor.until});
        }
        for (const TimedOpening& opening : events_.opened) {
            if (!opens_by_itself(mission_->rules, opening.obstacle)) state.opened.push_back(opening);
        }
        state.failed = std::exchange(failed_, {});
        state.found = std::exchange(found_, {});
        return state;
    }

    // Aircraft that would not come home are lost.
    Revision revised(State state) {
        while (true) {
            const auto begin = std::chrono::steady_clock::now();
            try {
                Revision next = revise(planner_, *map_, *mission_, *plan_, state, 0, scene_.method, scene_.limits);
                const std::chrono::duration<double, std::milli> lasted = std::chrono::steady_clock::now() - begin;
                revise_ms_.push_back(lasted.count());
                return next;
            } catch (const InputError& error) {
                const auto said = std::ranges::find(state.agents, error.error().subject, &AgentState::id);
                if (said == state.agents.end() || !said->flown || said->doing == Doing::lost) throw;
                said->doing = Doing::lost;
                lose(actors_[acting_[std::size_t(said - state.agents.begin())]], result_.emptied);
                news_ = false;
            }
        }
    }

    void revise_plan() {
        news_ = false;
        if (++result_.revisions > most_revisions) {
            result_.ending = Ending::not_found;
            return;
        }
        Revision next = revised(state());
        if (next.plan.status != PlanStatus::solved) {
            result_.ending = ending_of(next, actors_);
            return wake();
        }
        revision_ = std::move(next);
        map_ = &revision_->map;
        mission_ = &revision_->mission;
        plan_ = &revision_->plan;
        std::erase_if(acting_, [&](std::size_t i) { return actors_[i].phase == Phase::lost; });
        std::vector<ObstacleId> standing;
        for (const TimedOpening& opening : mission_->rules.opened) {
            if (!is_open(opening.obstacle)) standing.push_back(opening.obstacle);
        }
        adopt(scripts_of(*map_, *mission_, *plan_, standing));
    }

    // Everybody goes on with another script, from where it is.
    void adopt(std::vector<Script> scripts) {
        happened_.assign(plan_->orders.size(), false);
        foresight_ = std::make_unique<const Foresight>(*map_, *mission_);
        for (std::size_t i = 0; i < acting_.size(); ++i) {
            Actor& actor = actors_[acting_[i]];
            actor.planned_as = i;
            const bool moves = actor.phase == Phase::moving;
            if (!actor.script.empty()) {
                const Point at = actor.at(now_);
                if (moves) actor.driven += distance(actor.here().at, at);
                if (moves) actor.rolls = true;
                log(actor);
                scripts[i].front().at = at;
            }
            actor.path = plan_->agents[i].path;
            actor.script = std::move(scripts[i]);
            actor.stop = 0;
            if (moves) stand(actor, Phase::waiting);
            log(actor);
        }
        // A breach that takes no time may be made where an aircraft is.
        for (const std::size_t i : acting_) {
            const std::vector<ObstacleId>& breaches = actors_[i].here().breaches;
            if (breaches.empty() || try_breaches(breaches)) signal(actors_[i]);
        }
        if (news_) return;
        for (const std::size_t i : acting_) {
            Actor& actor = actors_[i];
            if (actor.phase == Phase::waiting || actor.phase == Phase::arrived) go_on(actor);
        }
    }

    const Scene& scene_;
    Draws draws_;
    Planner& planner_;
    std::vector<double>& revise_ms_;
    std::optional<Revision> revision_;
    const Map* map_;
    const Mission* mission_;
    const Plan* plan_;
    std::unique_ptr<const Foresight> foresight_;
    std::vector<Actor> actors_;         // of the first plan
    std::vector<std::size_t> acting_;   // those of the plan, in its order
    std::vector<bool> happened_;        // the first event of each order
    std::vector<std::uint64_t> tries_;  // of each obstacle's breach
    Events events_;
    std::vector<TimedOpening> coming_;  // the next one last
    // Since the plan:
    std::vector<TimedOpening> failed_;
    std::vector<Found> found_;
    bool news_ = false;
    double now_ = 0;
    std::uint64_t sequence_ = 0;
    Rehearsed result_;
};

}  // namespace

Rehearsed play(const Scene& scene, std::uint64_t run, Planner& planner, std::vector<double>& revise_ms) {
    return Execution(scene, run, planner, revise_ms).play();
}

}  // namespace waybreaker::rehearsal
