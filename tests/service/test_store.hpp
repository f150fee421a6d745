// Where tests keep live missions: in files, or in the database that scripts/with-postgres names.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "service/mission_store.hpp"

namespace waybreaker::service {

inline const ReportRecord first_report{.now = 0.1, .status = "planned", .plan = "{}", .event = "{}"};
inline const ArchivedMap archived_map{"upload-1", Connectivity::four, std::string("m\0a\xffp", 5)};
inline constexpr std::size_t many_missions = 100;

inline std::string test_postgres() {
    const char* const url = std::getenv("WAYBREAKER_TEST_POSTGRES");
    return url == nullptr ? "" : url;
}

inline bool on_postgres() {
    return !test_postgres().empty();
}

// Runs SQL in the database.
inline void run_sql(const std::string& sql) {
    const std::string command =
        "psql --quiet --no-psqlrc --set ON_ERROR_STOP=1 --dbname \"$WAYBREAKER_TEST_POSTGRES\" "
        "--command \"" +
        sql + "\" >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << sql;
}

// An empty store, for open_store().
inline std::string new_test_store(const std::string& file) {
    if (!on_postgres()) return file;
    run_sql("DROP SCHEMA IF EXISTS waybreaker CASCADE");
    return test_postgres();
}

}  // namespace waybreaker::service
