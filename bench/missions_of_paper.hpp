// The 144 missions of the paper's kind that the authors' program was run on (reference/authors_program.csv in the
// shared folder): city maps of 512 x 512, distance over 400, a detour of over 10 %.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "waybreaker/cell.hpp"

namespace waybreaker::bench {

// The rows of a comma-separated file by the names of its columns. Throws InputError if it cannot be read.
using CsvRow = std::map<std::string, std::string>;
std::vector<CsvRow> read_csv(const std::filesystem::path& path);

struct CityMission {
    std::string city;
    Cell start;
    Cell goal;
    friend auto operator<=>(const CityMission&, const CityMission&) = default;
};

CityMission mission_of(const CsvRow& row);

std::vector<CityMission> missions_of_paper();

}  // namespace waybreaker::bench
