#include "studio/plan_picture.hpp"

#include "render/caption.hpp"

namespace waybreaker::studio {
namespace {

render::PictureOptions options_of(const io::MapFile& map, const io::PlanFile& plan) {
    return picture_options(map, plan.mission.rules.objective, plan.in_seconds);
}

}  // namespace

render::PictureOptions picture_options(const io::MapFile& map, Objective objective, bool in_seconds) {
    render::PictureOptions options{.cell_size = map.cell_size,
                                   .metres = map.has_metres(),
                                   .seconds = in_seconds,
                                   .objective = objective,
                                   .annotations = map.annotations};
    options.annotations.title = map.name();
    return options;
}

std::string plan_svg(const io::MapFile& map, const io::PlanFile& plan) {
    return render::svg(map.map, plan.mission, plan.plan, options_of(map, plan));
}

std::string plan_sentence(const io::MapFile& map, const io::PlanFile& plan) {
    return render::headline(map.map, plan.mission, plan.plan, options_of(map, plan));
}

}  // namespace waybreaker::studio
