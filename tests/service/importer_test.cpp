// Map data is read in a process of its own: what that does wrong is a problem of one client.
#include "service/importer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <random>
#include <thread>

#include "http/problem.hpp"
#include "osm_yard.hpp"
#include "service/child_process.hpp"
#include "service/import_worker.hpp"
#include "service/sanitizer.hpp"

namespace waybreaker::service {
namespace {

std::vector<std::string> shell(const std::string& script) {
    return {"/bin/sh", "-c", script};
}

TEST(ChildProcess, HearsAllThatItIsToldAndSaysAllItHas) {
    const std::string first(3'000'000, 'a');
    const std::string last(5'000'000, 'b');
    const std::array<std::string_view, 3> told{first, "", last};
    const ChildEnd end = run_child({"/bin/cat"}, told, 9'000'000, {});
    EXPECT_EQ(end.said, first + last);
    EXPECT_FALSE(end.stopped);
}

TEST(ChildProcess, NeedNotListen) {
    const std::string much(5'000'000, 'a');
    const std::array<std::string_view, 1> told{much};
    EXPECT_EQ(run_child(shell("echo done; exit 3"), told, 100, {}).said, "done\n");
    EXPECT_EQ(WEXITSTATUS(run_child(shell("exit 3"), {}, 100, {}).status), 3);
}

TEST(ChildProcess, EndsAtAStop) {
    StopSource stop;
    stop.request_stop();
    EXPECT_TRUE(run_child(shell("exec sleep 1000"), {}, 100, stop.get_token()).stopped);
}

TEST(ChildProcess, EndsWhenItSaysTooMuch) {
    EXPECT_LT(run_child(shell("exec yes"), {}, 1000, {}).said.size(), 1'000'000U);
}

TEST(ChildProcess, HasNoFileOfOurs) {
    const int ours = open("/dev/null", O_RDONLY);
    const std::string script = fmt::format("test -e /proc/$$/fd/{}; echo $?", ours);
    EXPECT_EQ(run_child(shell(script), {}, 100, {}).said, "1\n");
    close(ours);
}

TEST(ChildProcess, MustBeThere) {
    EXPECT_THROW(run_child({"/no/such/program"}, {}, 100, {}), std::runtime_error);
}

class ImporterTest : public testing::Test {
  protected:
    // Its problem; "" if it has none. Throws what is not the client's fault.
    std::string problem_of(const std::vector<std::string>& worker, const std::string& data = osm_yard()) {
        const Importer importer(worker, limits_, budget_);
        try {
            extract_ = importer.extract("yard", data, stop_.get_token());
        } catch (const http::Problem& problem) {
            return std::string(problem.kind());
        }
        return "";
    }
    static std::vector<std::string> worker() { return {"/proc/self/exe", import_worker_word}; }

    ServiceLimits limits_;
    MemoryBudget budget_{std::size_t{1} << 30};
    StopSource stop_;
    city::Extract extract_;
};

TEST_F(ImporterTest, SaysWhatIsWrongWithTheData) {
    EXPECT_EQ(problem_of(worker()), "");
    EXPECT_EQ(extract_.buildings, 2U);
    EXPECT_EQ(problem_of(worker(), "nonsense"), "source-unreadable");
    EXPECT_EQ(budget_.used(), 0U);
}

TEST_F(ImporterTest, TellsApartWhyAWorkerEnds) {
    EXPECT_EQ(problem_of(shell("exit " + std::to_string(worker_out_of_memory))), "import-beyond-memory");
    EXPECT_EQ(problem_of(shell("kill -ABRT $$")), "import-beyond-memory");  // GDAL does so
    EXPECT_EQ(problem_of(shell("kill -XCPU $$")), "import-too-long");
    for (const char* broken :
         {"kill -SEGV $$", "exit 1", "exit 0", "echo nonsense", "echo '{}'", "echo '{\"bytes\": 9}'; echo short",
          "echo '{\"bytes\": 0}'", "echo '{\"problem\": {\"kind\": \"none\", \"detail\": \"\"}, \"bytes\": 0}'"}) {
        EXPECT_THROW(problem_of(shell(broken)), std::exception) << broken;
        EXPECT_EQ(budget_.used(), 0U) << broken;
    }
    stop_.request_stop();
    EXPECT_EQ(problem_of(shell("exec sleep 1000")), "import-too-long");
}

TEST_F(ImporterTest, WorksWithinTheBudget) {
    EXPECT_EQ(problem_of(shell("exit 1"), std::string(20'000'000, ' ')), "source-too-large");
    MemoryBudget::Share others(budget_, MemoryBudget::Use::planner);
    EXPECT_TRUE(others.grow(budget_.most() - 1000));
    EXPECT_EQ(problem_of(worker()), "no-memory");
}

// A building whose outline crosses itself two million times: to make it valid takes gigabytes.
TEST_F(ImporterTest, AShapeGetsNoMoreMemoryThanItsSizeAllows) {
    if (sanitized) GTEST_SKIP() << "sanitizers have memory of their own";
    std::mt19937 random(1);
    std::uniform_real_distribution<double> degrees(0, 0.01);
    std::string ring;
    for (int i = 0; i < 3000; ++i) {
        ring += "[" + std::to_string(9 + degrees(random)) + ", " + std::to_string(50 + degrees(random)) + "], ";
    }
    const std::string data =
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"building": "yes"},
            "geometry": {"type": "Polygon", "coordinates": [[[9, 50], )" +
        ring + "[9, 50]]]}}]}";
    ASSERT_EQ(problem_of(worker(), data), "");
    const Importer importer(worker(), limits_, budget_);
    const ImportRequest request =
        parse_import_request(R"({"source": "tangle", "center": [9.005, 50.005], "size": 600})");
    try {
        importer.import("tangle.geojson", data, extract_, request, 1'000'000, {});
        FAIL() << "it has enough memory";
    } catch (const http::Problem& problem) {
        EXPECT_EQ(problem.kind(), "import-beyond-memory");
    }
}

}  // namespace
}  // namespace waybreaker::service
