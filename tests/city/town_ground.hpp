// A town to draw upon, with one small building so that there is something to import.
#pragma once

#include <optional>
#include <string>

#include "city/city_import.hpp"
#include "city/ground_picture.hpp"
#include "city/osm_drawing.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {

class TownGround : public TemporaryFolder {
  protected:
    OsmDrawing drawing_ = OsmDrawing(town_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));

    ImportReport import(const OsmDrawing& drawing, ImportOptions options = town_window) const {
        return import_city(put("town.osm", drawing.xml()), options);
    }
    std::string drawn(std::optional<Profile> profile = {}) const {
        ImportOptions options = town_window;
        options.profile = profile;
        return picture(import(drawing_, options).tiff);
    }
};

}  // namespace waybreaker::city
