// Map archive: where maps can be read again that were sent and are no longer in memory.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker::service {

struct ArchivedMap {
    std::string id;
    Connectivity connectivity = Connectivity::four;
    std::string bytes;
};

// Thread-safe.
class MapArchive {
  public:
    virtual ~MapArchive() = default;
    virtual bool holds(const std::string& id) = 0;
    // Of the maps that clients have sent; others are copies of the server's own.
    virtual std::vector<std::string> sent() = 0;
    virtual std::optional<ArchivedMap> read(const std::string& id) = 0;
    // A map is sent; if other servers share the archive, they can read it from now on. Throws Problem if another map
    // has its id.
    virtual void keep(const std::string& /*id*/, Connectivity /*connectivity*/, const std::string& /*bytes*/) {}
    // False, and nothing has changed, if live missions are on that map.
    virtual bool forget(const std::string& id) = 0;
};

}  // namespace waybreaker::service
