// The URL of a PostgreSQL database.
#pragma once

#include <string>

namespace waybreaker::service {

struct PostgresUrl {
    std::string parameters;  // of a connection, as libpq takes them
    std::string name;        // the database without user and password, for messages
};

// Throws InputError if it is none; the message does not quote it, for a password may stand in an unlikely place.
PostgresUrl parse_postgres_url(const std::string& url);

}  // namespace waybreaker::service
