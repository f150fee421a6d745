// A mission store in a PostgreSQL database, which several servers share, and the maps that were sent to them.
//
// A turn is a transaction that holds a lock of PostgreSQL on the mission's name. The lock is free again when the server
// dies; and when a server lives on without a word, for the database ends transactions that idle longer than a plan may
// take. What such a server adds then comes too late and fails.
#pragma once

#include <memory>
#include <string>

#include "service/mission_store.hpp"

namespace waybreaker::service {

// Whether it is meant as one; it need not be right.
inline bool is_postgres_url(const std::string& text) {
    return text.starts_with("postgresql://") || text.starts_with("postgres://");
}

// Makes its tables in a schema of its own, `waybreaker`, if there are none. Keeps `limits.maps` maps beside those of
// missions. Logs why the database cannot be used, which clients need not know. Throws InputError, with the remedy, if
// the URL is wrong, the database cannot be reached, or its tables are of another version; no message has the password.
std::unique_ptr<MissionStore> open_postgres_store(const std::string& url, const ServiceLimits& limits, const Log& log);

}  // namespace waybreaker::service
