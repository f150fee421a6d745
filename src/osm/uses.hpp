// Whether a closed way is the outline of an area, a line that comes back to where it began, or both.
#pragma once

namespace osmium {
class TagList;
}

namespace waybreaker::osm {

struct Uses {
    bool line = false;
    bool area = false;
};

Uses uses_of(const osmium::TagList& tags, bool closed);

// Whether closed ways with the key can be areas for it.
bool is_area_key(const char* key);

}  // namespace waybreaker::osm
