#include "experiment/store.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "core/random.hpp"
#include "experiment/merge.hpp"
#include "input_error.hpp"
#include "small_experiment.hpp"

namespace waybreaker::experiment {
namespace {

class StoreResults : public SmallExperiment {
  protected:
    std::string store_error(const std::string& name, const std::string& version = "1.2.3", Shard shard = {}) {
        return input_error([&] { Store(path(name), experiment, shard, version); });
    }
    std::string merge_error(const std::vector<std::string>& names) {
        std::vector<std::string> paths;
        for (const std::string& name : names) paths.push_back(path(name));
        const std::string message = input_error([&] { merge(paths, path("all.db")); });
        EXPECT_FALSE(std::filesystem::exists(path("all.db")));
        return message;
    }
};

TEST_F(StoreResults, RefusesFilesOfOthersAndLeavesThemAsTheyAre) {
    put("text.db", std::string(5000, 'x'));
    EXPECT_EQ(store_error("text.db"), path("text.db") + ": is not a file of results: give another name");
    EXPECT_EQ(bytes_of("text.db"), std::string(5000, 'x'));

    SQLite::Database(path("other.db"), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE mine (x)");
    const std::string before = bytes_of("other.db");
    EXPECT_EQ(store_error("other.db"),
              path("other.db") + ": is a database of something else, not results of an experiment: give another file");
    EXPECT_EQ(bytes_of("other.db"), before);

    SQLite::Database(path("new.db"), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec("CREATE TABLE x (x); PRAGMA application_id = " + std::to_string(application_id) +
              "; PRAGMA user_version = 99");
    EXPECT_EQ(store_error("new.db"),
              path("new.db") + ": was written by another version of waybreaker, in a format unknown to this one");
    EXPECT_EQ(input_error([&] { Results(path("none.db")); }),
              "cannot read " + path("none.db") + ": No such file or directory");
    put("empty.db", "");
    EXPECT_EQ(input_error([&] { Results(path("empty.db")); }),
              path("empty.db") + ": is empty: no experiment has stored its results here");
}

TEST_F(StoreResults, RefusesAnotherExperimentVersionOrShard) {
    run_into("r.db");
    EXPECT_EQ(
        store_error("r.db", "2.0.0"),
        path("r.db") + ": was begun by waybreaker 1.2.3, this is 2.0.0: end it with that one, or begin another file");
    EXPECT_EQ(store_error("r.db", "1.2.3", {2, 3}),
              path("r.db") + ": holds shard 1/1, not 2/3: give each shard its own file");
    experiment.digest += "0";
    EXPECT_EQ(store_error("r.db"), path("r.db") +
                                       ": holds the results of another experiment, or its spec, missions or maps have "
                                       "changed: give another file");
}

TEST_F(StoreResults, RefusesASecondRunOnAFile) {
    Store first(path("r.db"), experiment, {}, "1.2.3");
    const std::string in_use = path("r.db") + ": is in use by another run: wait for its end, or give another file";
    EXPECT_EQ(store_error("r.db"), in_use);
    EXPECT_EQ(input_error([&] { Results(path("r.db")); }), in_use);
    EXPECT_EQ(run(experiment, first).stored, 72U) << "the first is not disturbed";
}

TEST_F(StoreResults, NeverGivesBackNonsenseFromADamagedFile) {
    run_into("r.db");
    const std::string sound = bytes_of("r.db");
    Random random(7);
    int refused = 0;
    for (int i = 0; i < 200; ++i) {
        std::string damaged = sound;
        if (i % 2 == 0) damaged.resize(std::size_t(random.below(int(damaged.size()))));
        const int hole = random.below(3000);
        for (int j = 0; j < hole && !damaged.empty(); ++j) {
            damaged[std::size_t(random.below(int(damaged.size())))] = char(random.below(256));
        }
        put("damaged.db", damaged);
        try {
            Results results(path("damaged.db"));
            results.for_each_mission([](const ExperimentMission&, std::span<const std::optional<Result>>) {});
            results.csv(true);
        } catch (const InputError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 180);
}

TEST_F(StoreResults, KeepsWhatIsStoredWhenTheDiskIsFull) {
    Store store(path("r.db"), experiment, {}, "1.2.3");
    store.add(std::vector<Row>{{.job = 3, .result = {.message = "first"}}});
    const std::uintmax_t size = std::filesystem::file_size(path("r.db"));
    // A file that cannot grow behaves like a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit former{};
    getrlimit(RLIMIT_FSIZE, &former);
    const rlimit full{size, former.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    const std::vector<Row> large{{.job = 5, .result = {.message = std::string(100'000, 'x')}}};
    const std::string message = input_error([&] { store.add(large); });
    setrlimit(RLIMIT_FSIZE, &former);
    EXPECT_TRUE(message.starts_with("cannot write " + path("r.db") + ": ")) << message;
    EXPECT_NE(message.find("what was stored is safe"), std::string::npos) << message;
    EXPECT_EQ(store.open_jobs().size(), 71U);
    store.add(large);
    EXPECT_EQ(store.open_jobs().size(), 70U);
}

TEST_F(StoreResults, AreMergedOnlyIfComplete) {
    for (const std::uint32_t index : {1U, 2U, 3U}) {
        run_into(std::to_string(index) + ".db", {}, {index, 3});
        std::filesystem::copy(path(std::to_string(index) + ".db"), path("copy" + std::to_string(index) + ".db"));
    }
    run_into("half.db", {}, {1, 2});
    EXPECT_EQ(merge_error({"1.db", "3.db"}), "shard 2/3 is missing");
    EXPECT_EQ(merge_error({"1.db", "2.db", "copy2.db", "3.db"}),
              path("copy2.db") + ": is shard 2, and so is " + path("2.db"));
    EXPECT_EQ(merge_error({"1.db", "half.db"}),
              path("half.db") + ": is one of 2 shards, " + path("1.db") + " one of 3");
    SQLite::Database(path("copy3.db"), SQLite::OPEN_READWRITE).exec("DELETE FROM results WHERE configuration = 4");
    EXPECT_EQ(merge_error({"1.db", "2.db", "copy3.db"}),
              path("copy3.db") + ": is not complete, 2 results are missing: run shard 3/3 again");
    SQLite::Database(path("copy1.db"), SQLite::OPEN_READWRITE)
        .exec("UPDATE experiment SET value = '9' WHERE key = 'version'");
    EXPECT_EQ(merge_error({"2.db", "copy1.db", "3.db"}), path("copy1.db") + ": was made by waybreaker 9, " +
                                                             path("2.db") +
                                                             " by 1.2.3: their results do not belong together");
    SQLite::Database(path("copy2.db"), SQLite::OPEN_READWRITE)
        .exec("UPDATE experiment SET value = 'x' WHERE key = 'digest'");
    EXPECT_EQ(merge_error({"1.db", "copy2.db", "3.db"}),
              path("copy2.db") + ": holds another experiment than " + path("1.db"));
    put("all.db", "mine");
    EXPECT_EQ(input_error([&] {
                  merge(std::vector<std::string>{path("1.db"), path("2.db"), path("3.db")}, path("all.db"));
              }),
              path("all.db") + ": exists: give a new name");
    EXPECT_EQ(bytes_of("all.db"), "mine");
}

TEST_F(StoreResults, ExportQuotesWhatCsvMustQuote) {
    {
        Store store(path("r.db"), experiment, {}, "1.2.3");
        store.add(std::vector<Row>{{.job = 0, .result = {.message = "said \"no\", twice\n"}},
                                   {.job = 1, .result = {.message = "=1+1"}}});
    }
    EXPECT_NE(csv_of("r.db").find(",'=1+1,"), std::string::npos) << "no formula to a spreadsheet";
    EXPECT_NE(csv_of("r.db").find(",\"said \"\"no\"\", twice\n\","), std::string::npos) << csv_of("r.db");
    EXPECT_EQ(csv_of("r.db").find("seconds"), std::string::npos);
    EXPECT_NE(Results(path("r.db")).csv(true).find("before_seconds"), std::string::npos);
}

}  // namespace
}  // namespace waybreaker::experiment
