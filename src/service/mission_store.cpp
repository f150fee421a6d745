#include "service/mission_store.hpp"

#include "service/postgres_store.hpp"
#include "service/sqlite_store.hpp"

namespace waybreaker::service {

std::unique_ptr<MissionStore> open_store(const std::string& where, const ServiceLimits& limits, const Log& log) {
    return is_postgres_url(where) ? open_postgres_store(where, limits, log) : open_sqlite_store(where);
}

}  // namespace waybreaker::service
