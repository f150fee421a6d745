// The rules of docs/architecture.md: who may use whom, files that can be read in one sitting, no paths of anybody's
// machine. The table of that page is the rule; it stands nowhere else.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "project_folder.hpp"
#include "waybreaker/version.hpp"

namespace {

namespace fs = std::filesystem;

constexpr int max_lines = 400;

struct Rules {
    std::map<std::string, std::set<std::string>> may_use;  // by folder, all it may use, itself included
    std::map<std::string, std::string> owner;              // of a public header: the folder that implements it
};

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
        found.push_back(match->str(1));
    }
    return found;
}

// Reads table rows "| `src/map/` | what it holds | `grid.hpp` `map.hpp` | core |".
Rules read_rules(const std::string& page) {
    static const std::regex row(R"(\| `(?:src/|include/)?(\w+)/` \|[^|]*\|([^|]*)\|([^|]*)\|)");
    static const std::regex header(R"(`(?:advanced/)?([\w.]+)`)");
    static const std::regex word(R"((\w+))");
    Rules rules;
    for (std::sregex_iterator match(page.begin(), page.end(), row), end; match != end; ++match) {
        const std::string folder = match->str(1);
        for (const std::string& name : matches(match->str(2), header)) rules.owner[name] = folder;
        std::set<std::string>& used = rules.may_use[folder];
        used.insert(folder);
        // Rows stand below what they use, so what a used folder may use is known.
        for (const std::string& name : matches(match->str(3), word)) used.merge(std::set(rules.may_use.at(name)));
    }
    return rules;
}

// Reads table rows "| `src/crossing/labels/` | what it holds | geometry |" of folders below one of src/.
std::map<std::string, std::set<std::string>> read_part_rules(const std::string& page) {
    static const std::regex row(R"(\| `src/(\w+)/(\w+)/` \|[^|]*\|([^|]*)\|)");
    static const std::regex word(R"((\w+))");
    std::map<std::string, std::set<std::string>> may_use;  // "crossing/labels": itself and what it may use
    for (std::sregex_iterator match(page.begin(), page.end(), row), end; match != end; ++match) {
        const std::string folder = match->str(1) + "/";
        std::set<std::string>& used = may_use[folder + match->str(2)];
        used.insert(folder + match->str(2));
        for (const std::string& name : matches(match->str(3), word)) used.insert(folder + name);
    }
    return may_use;
}

// What is wrong with the uses that a file below a folder of src/ makes of the other parts of that folder.
std::vector<std::string> forbidden_parts(const std::map<std::string, std::set<std::string>>& may_use,
                                         const fs::path& path, const std::string& text) {
    static const std::regex include(R"re(#\s*include\s*"([\w.]+/[\w./]+)")re");
    const std::string part = path.parent_path().lexically_relative("src").string();
    const std::string folder = part.substr(0, part.find('/'));
    std::vector<std::string> findings;
    if (part == folder) return findings;
    if (!may_use.contains(part)) return {path.string() + " is in a folder the table of parts does not know"};
    for (const std::string& name : matches(text, include)) {
        const std::string used = fs::path(name).parent_path().string();
        if (used.starts_with(folder + "/") && !may_use.at(part).contains(used)) {
            findings.push_back(path.string() + " uses " + name + ", which " + part + " may not");
        }
    }
    return findings;
}

// What is wrong with the uses of a source file or CMakeLists.txt, one line each; `path` is relative to the project.
std::vector<std::string> forbidden_uses(const Rules& rules, const fs::path& path, const std::string& text) {
    static const std::regex include(R"re(#\s*include\s*["<]([\w.]+/[\w./]+)[">])re");
    static const std::regex uses(R"(\bUSES((?:\s+[a-z_]+)+))");
    static const std::regex target(R"(\bwaybreaker_([a-z]+)\b(?!\())");
    static const std::regex word(R"(([a-z_]+))");

    std::vector<std::string> used;
    std::vector<std::string> findings;
    if (path.filename() == "CMakeLists.txt") {
        for (const std::string& list : matches(text, uses)) {
            for (const std::string& folder : matches(list, word)) used.push_back(folder);
        }
        for (const std::string& folder : matches(text, target)) used.push_back(folder);
    } else {
        for (const std::string& name : matches(text, include)) {
            const std::string first = name.substr(0, name.find('/'));
            const auto owner = rules.owner.find(fs::path(name).filename());
            if (first != "waybreaker") {
                used.push_back(first);
            } else if (owner != rules.owner.end()) {
                used.push_back(owner->second);
            } else {
                findings.push_back(path.string() + " includes " + name + ", which no folder of the table owns");
            }
        }
    }

    auto part = path.begin();
    if (*part == "src" || *part == "include") ++part;
    std::string folder = *part;
    if (folder == "waybreaker" && rules.owner.contains(path.filename())) folder = rules.owner.at(path.filename());
    if (!rules.may_use.contains(folder)) return {path.string() + " is in a folder the table does not know"};
    for (const std::string& name : used) {
        // Other names are libraries from elsewhere: what may be linked is seen in NEEDS.
        if (rules.may_use.contains(name) && !rules.may_use.at(folder).contains(name)) {
            findings.push_back(path.string() + " uses " + name + ", which " + folder + " may not");
        }
    }
    return findings;
}

std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

const fs::path project = waybreaker::project_folder();

// Calls visit(path relative to the project, text) for every text file of ours below the given folders.
template <class Visit>
void for_each_file(std::initializer_list<const char*> folders, Visit visit) {
    static const std::set<std::string> extensions = {"", ".c", ".cpp", ".h", ".hpp", ".txt", ".md", ".cmake", ".json"};
    for (const char* folder : folders) {
        if (!fs::exists(project / folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(project / folder)) {
            if (!entry.is_regular_file() || !extensions.contains(entry.path().extension())) continue;
            visit(fs::relative(entry.path(), project), read(entry.path()));
        }
    }
}

const Rules& rules() {
    static const Rules result = read_rules(read(project / "docs/architecture.md"));
    return result;
}

TEST(Layout, EveryFolderUsesOnlyWhatItMay) {
    for_each_file({"src", "apps", "include"}, [](const fs::path& path, const std::string& text) {
        const std::string extension = path.extension();
        if (extension != ".cpp" && extension != ".hpp" && path.filename() != "CMakeLists.txt") return;
        if (path == "src/CMakeLists.txt") return;  // adds the folders, is none
        for (const std::string& finding : forbidden_uses(rules(), path, text)) ADD_FAILURE() << finding;
    });
}

TEST(Layout, EveryPartOfAFolderUsesOnlyWhatItMay) {
    const auto may_use = read_part_rules(read(project / "docs/architecture.md"));
    EXPECT_GE(may_use.size(), 4U) << "the table of parts is not read";
    for (const auto& [part, used] : may_use) EXPECT_TRUE(fs::exists(project / "src" / part)) << part;
    for_each_file({"src"}, [&](const fs::path& path, const std::string& text) {
        if (path.extension() != ".cpp" && path.extension() != ".hpp") return;
        for (const std::string& finding : forbidden_parts(may_use, path, text)) ADD_FAILURE() << finding;
    });
}

TEST(Layout, EveryFolderOfTheTableExists) {
    EXPECT_GE(rules().may_use.size(), 10U) << "the table of docs/architecture.md is not read";
    for (const auto& [folder, used] : rules().may_use) {
        EXPECT_TRUE(fs::exists(project / "src" / folder) || fs::exists(project / folder) ||
                    fs::exists(project / "include" / folder))
            << folder;
    }
}

// Who reads missions and writes plans and pictures need not link what plans them.
TEST(Layout, DocumentsPicturesAndTheCheckerDoNotUseThePlanner) {
    for (const char* folder : {"io", "render", "check"}) {
        for (const char* planning : {"search", "crossing", "flight", "schedule", "select", "coalition", "mission"}) {
            EXPECT_FALSE(rules().may_use.at(folder).contains(planning)) << folder << " may use " << planning;
        }
    }
}

TEST(Layout, FilesCanBeReadInOneSitting) {
    for_each_file({"src", "apps", "include", "tests", "fuzz", "bench", "examples", "cmake", "scripts"},
                  [](const fs::path& path, const std::string& text) {
                      const std::string extension = path.extension();
                      if (extension == ".txt" && path.filename() != "CMakeLists.txt") return;  // expected output
                      if (extension == ".json") return;
                      EXPECT_LE(std::count(text.begin(), text.end(), '\n'), max_lines) << path;
                  });
}

TEST(Layout, NoPathOfAnybodysMachine) {
    static const std::regex machine_path(R"((^|[\s"'(=`])/(home|root|work|Users)/)");
    for_each_file({"src", "apps", "include", "tests", "fuzz", "bench", "examples", "cmake", "scripts", "docs", "data"},
                  [](const fs::path& path, const std::string& text) {
                      std::istringstream lines(text);
                      int number = 0;
                      for (std::string line; std::getline(lines, line);) {
                          ++number;
                          EXPECT_FALSE(std::regex_search(line, machine_path)) << path << ":" << number << ": " << line;
                      }
                  });
}

TEST(Layout, TheCitationIsOfThisVersion) {
    static const std::regex cited(R"(\nversion: (\S+)\n)");
    static const std::regex built(R"(\bproject\(waybreaker VERSION (\S+) )");
    const std::vector<std::string> version = matches(read(project / "CITATION.cff"), cited);
    ASSERT_EQ(version.size(), 1U);
    EXPECT_EQ(version, matches(read(project / "CMakeLists.txt"), built));
}

TEST(Layout, TheHeadersAreOfThisVersion) {
    static const std::regex built(R"(\bproject\(waybreaker VERSION (\S+) )");
    const std::string macros = std::to_string(WAYBREAKER_VERSION_MAJOR) + "." +
                               std::to_string(WAYBREAKER_VERSION_MINOR) + "." +
                               std::to_string(WAYBREAKER_VERSION_PATCH);
    EXPECT_EQ(matches(read(project / "CMakeLists.txt"), built), std::vector{macros});
    EXPECT_EQ(WAYBREAKER_VERSION_STRING, macros);
    EXPECT_EQ(WAYBREAKER_VERSION,
              10000 * WAYBREAKER_VERSION_MAJOR + 100 * WAYBREAKER_VERSION_MINOR + WAYBREAKER_VERSION_PATCH);
}

// The checks above find what they are for.
class ForbiddenUses : public testing::Test {
  protected:
    std::vector<std::string> of(const char* path, const char* text) const { return forbidden_uses(table, path, text); }

    const Rules table = read_rules(
        "| `src/core/` | cells | `cell.hpp` | |\n"
        "| `src/map/` | grid | `map.hpp` | core |\n"
        "| `src/search/` | loop | `search.hpp` | map |\n"
        "| `src/plan/` | data | `plan.hpp` | core |\n"
        "| `include/waybreaker/` | face | `waybreaker.hpp` | search plan |\n");
};

TEST_F(ForbiddenUses, AllowWhatTheTableSaysAndWhatThatMayUse) {
    EXPECT_TRUE(of("src/search/a.cpp", "#include \"map/x.hpp\"\n#include \"core/y.hpp\"\n#include <vector>").empty());
    EXPECT_TRUE(of("src/search/a.cpp", "#include \"search/x.hpp\"\n#include \"waybreaker/map.hpp\"").empty());
    EXPECT_TRUE(of("include/waybreaker/waybreaker.hpp", "#include \"waybreaker/plan.hpp\"").empty());
    EXPECT_TRUE(of("src/search/CMakeLists.txt", "waybreaker_library(search SOURCES a.cpp USES map NEEDS fmt)").empty());
}

TEST_F(ForbiddenUses, FindIncludes) {
    EXPECT_EQ(of("src/map/a.cpp", "#include \"search/x.hpp\"").size(), 1U);
    EXPECT_EQ(of("src/plan/deep/a.hpp", "  # include <search/x.hpp>").size(), 1U);
    EXPECT_EQ(of("src/plan/a.cpp", "#include \"waybreaker/map.hpp\"").size(), 1U);
    EXPECT_EQ(of("include/waybreaker/map.hpp", "#include \"waybreaker/advanced/search.hpp\"").size(), 1U);
    EXPECT_EQ(of("src/map/a.cpp", "#include \"waybreaker/unknown.hpp\"").size(), 1U);
}

TEST_F(ForbiddenUses, FindLinks) {
    EXPECT_EQ(of("src/map/CMakeLists.txt", "waybreaker_library(map SOURCES a.cpp USES core\n  search)").size(), 1U);
    EXPECT_EQ(of("src/map/CMakeLists.txt", "target_link_libraries(waybreaker_map PUBLIC waybreaker_plan)").size(), 1U);
}

TEST_F(ForbiddenUses, FindFoldersTheTableDoesNotKnow) {
    EXPECT_EQ(of("src/utils/a.cpp", "").size(), 1U);
}

TEST(ForbiddenParts, AreFound) {
    const auto may_use = read_part_rules("| `src/search/low/` | a | |\n| `src/search/high/` | b | low |\n");
    const auto of = [&](const char* path, const char* text) { return forbidden_parts(may_use, path, text).size(); };
    EXPECT_EQ(of("src/search/high/a.cpp", "#include \"search/low/x.hpp\"\n#include \"search/tuning.hpp\""), 0U);
    EXPECT_EQ(of("src/search/low/a.cpp", "#include \"search/low/x.hpp\"\n#include \"core/low/x.hpp\""), 0U);
    EXPECT_EQ(of("src/search/a.cpp", "#include \"search/high/x.hpp\""), 0U);
    EXPECT_EQ(of("src/search/low/a.cpp", "#include \"search/high/x.hpp\""), 1U);
    EXPECT_EQ(of("src/search/middle/a.cpp", ""), 1U);
}

}  // namespace
