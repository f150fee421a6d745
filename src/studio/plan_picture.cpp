#include "studio/plan_picture.hpp"

#include "render/caption.hpp"

namespace waybreaker::studio {
namespace {

render::PictureOptions options_of(const io::MapFile& map, const io::PlanFile& plan) {
    return picture_options(map, plan.mission.rules.objective, plan.in_seconds);
}

}  // namespace

render::PictureOptions picture_options(const io::MapFile& map, Objective objective, bool in_seconds) {
    return {.cell_size = map.cell_size,
            .metres = map.has_metres(),
            .seconds = in_seconds,
            .title = map.title.empty() ? map.source : map.title,
            .attribution = map.attribution,
            .objective = objective,
            .background = map.background,
            .kinds = map.kinds,
            .sections = map.sections};
}

std::string plan_svg(const io::MapFile& map, const io::PlanFile& plan) {
    return render::svg(map.map, plan.mission, plan.plan, options_of(map, plan));
}

std::string plan_sentence(const io::MapFile& map, const io::PlanFile& plan) {
    return render::headline(map.map, plan.mission, plan.plan, options_of(map, plan));
}

}  // namespace waybreaker::studio
