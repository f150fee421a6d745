#include "render/plan_picture.hpp"

#include <utility>

#include "io/plan_surfaces.hpp"
#include "render/caption.hpp"

namespace waybreaker::render {

PictureOptions picture_options(const io::MapFile& map, const io::MissionDocument& asked, const Plan& plan) {
    PictureOptions options{.cell_size = map.cell_size,
                           .metres = map.has_metres(),
                           .seconds = asked.in_seconds,
                           .objective = asked.mission.rules.objective,
                           .annotations = map.annotations};
    options.annotations.title = map.name();
    std::vector<std::string>& notes = options.annotations.notes;
    if (std::string line = io::surface_line(plan, asked.mission, map); !line.empty()) {
        notes.insert(notes.begin(), std::move(line));
    }
    return options;
}

std::string plan_svg(const io::MapFile& map, const io::PlanFile& plan, std::optional<Reach> reach) {
    PictureOptions options = picture_options(map, plan.asked, plan.plan);
    options.reach = std::move(reach);
    return svg(map.map, plan.asked.mission, plan.plan, options);
}

std::string plan_sentence(const io::MapFile& map, const io::PlanFile& plan) {
    return headline(map.map, plan.asked.mission, plan.plan, picture_options(map, plan.asked, plan.plan));
}

}  // namespace waybreaker::render
