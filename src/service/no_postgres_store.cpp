// Where libpqxx is missing.
#include "service/postgres_store.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {

std::unique_ptr<MissionStore> open_postgres_store(const std::string& /*url*/, const ServiceLimits& /*limits*/,
                                                  const Log& /*log*/) {
    throw InputError(
        "this waybreaker was built without PostgreSQL: give --store a file, or install libpqxx-dev and build it anew");
}

}  // namespace waybreaker::service
