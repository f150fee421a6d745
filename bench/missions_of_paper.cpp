#include "missions_of_paper.hpp"

#include <fstream>
#include <sstream>

#include "maps.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::bench {
namespace {

std::vector<std::string> fields(std::string line) {
    if (line.ends_with('\r')) line.pop_back();
    std::vector<std::string> result;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) result.push_back(field);
    return result;
}

}  // namespace

std::vector<CsvRow> read_csv(const std::filesystem::path& path) {
    std::ifstream in(path);
    if (!in) throw InputError(path.string(), 0, "cannot be read");
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = fields(line);
    std::vector<CsvRow> rows;
    while (std::getline(in, line)) {
        const std::vector<std::string> values = fields(line);
        CsvRow& row = rows.emplace_back();
        for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) row[names[i]] = values[i];
    }
    return rows;
}

CityMission mission_of(const CsvRow& row) {
    const auto number = [&](const char* name) { return std::stoi(row.at(name)); };
    return {row.at("map"), {number("start_x"), number("start_y")}, {number("goal_x"), number("goal_y")}};
}

std::vector<CityMission> missions_of_paper() {
    std::vector<CityMission> missions;
    for (const CsvRow& row : read_csv(shared_folder() / "reference" / "authors_program.csv")) {
        if (row.at("weight") == "1" && row.at("removals") == "3") missions.push_back(mission_of(row));
    }
    return missions;
}

}  // namespace waybreaker::bench
