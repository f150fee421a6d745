#include <memory>
#include <string>

#include "city/osm_features.hpp"
#include "city/sent_source.hpp"
#include "laws.hpp"

// OpenStreetMap's data in any of its formats is read, or refused in one line; what is read lies on the globe.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    read_or_refuse(data, size, [](std::string_view bytes) {
        const city::SentSource sent("input", std::make_shared<const std::string>(bytes));
        const std::optional<city::OsmSource> source = city::osm_source(sent.path());
        if (!source) return;
        city::FeatureQuery query;
        query.system.SetWellKnownGeogCS("WGS84");
        query.points = query.lines = query.areas = std::vector<city::TagFilter>();
        try {
            city::visit_osm(*source, query, [](const city::Feature& feature) {
                law(feature.geometry != nullptr && !feature.geometry->IsEmpty());
                OGREnvelope box;
                feature.geometry->getEnvelope(&box);
                law(box.MinX >= -180 && box.MaxX <= 180 && box.MinY >= -90 && box.MaxY <= 90);
            });
        } catch (const InputError& error) {
            throw InputError(sent.named(error.what()));
        }
    });
    return 0;
}
