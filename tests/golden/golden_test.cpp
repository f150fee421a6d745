// The command line as people and scripts see it: every session in sessions/ must run as it is written there. Each has a
// scratch folder with copies of files/ and a link `data` to the project's maps.
//
// To accept what the command does now, run this program with WAYBREAKER_UPDATE_GOLDEN=1 and read the difference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "project_folder.hpp"
#include "session.hpp"

namespace waybreaker::golden {
namespace {

namespace fs = std::filesystem;

const fs::path source_folder = project_folder() / "tests" / "golden";

std::vector<std::string> session_names() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(source_folder / "sessions")) {
        names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

class GoldenSession : public testing::TestWithParam<std::string> {};

TEST_P(GoldenSession, RunsAsWritten) {
    const fs::path file = source_folder / "sessions" / (GetParam() + ".txt");
    const fs::path scratch = fs::current_path() / "golden-scratch" / GetParam();
    fs::remove_all(scratch);
    fs::create_directories(scratch.parent_path());
    fs::copy(source_folder / "files", scratch, fs::copy_options::recursive);
    fs::create_directory_symlink(project_folder() / "data", scratch / "data");

    Session session = read_session(file);
    ASSERT_FALSE(session.steps.empty());
    const bool update = std::getenv("WAYBREAKER_UPDATE_GOLDEN") != nullptr;
    for (Step& step : session.steps) {
        const std::string result = run(step, scratch, fs::path(WAYBREAKER_COMMAND).parent_path());
        if (update) {
            step.result = result;
        } else {
            EXPECT_EQ(result, step.result) << "$ " << step.command;
        }
    }
    if (update) write_session(file, session);
}

INSTANTIATE_TEST_SUITE_P(Sessions, GoldenSession, testing::ValuesIn(session_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace waybreaker::golden
