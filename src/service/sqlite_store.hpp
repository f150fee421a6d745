// A mission store in an SQLite file, for one server.
#pragma once

#include <memory>
#include <string>

#include "service/mission_store.hpp"

namespace waybreaker::service {

// Opens or begins the file; no other process can open it until it is closed. Empty: in memory. Throws InputError, with
// the remedy, if it is a file of something else, of another version, damaged, or in use; it is unchanged then.
std::unique_ptr<MissionStore> open_sqlite_store(const std::string& path);

}  // namespace waybreaker::service
