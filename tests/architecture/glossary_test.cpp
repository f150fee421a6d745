// The glossary of docs/architecture.md: the types and functions that it names exist, and no identifier uses a word that
// it has retired.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "project_folder.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path root = waybreaker::project_folder();

std::string bytes_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

bool is_part_of_identifier(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Source text without comments and without what stands in quotes.
std::string code_of(const std::string& text) {
    std::string code;
    for (std::size_t i = 0; i < text.size();) {
        const std::string_view rest = std::string_view(text).substr(i);
        if (rest.starts_with("//")) {
            i = std::min(text.find('\n', i), text.size());
        } else if (rest.starts_with("/*")) {
            i = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
        } else if (rest.starts_with("R\"(")) {
            i = std::min(text.find(")\"", i), text.size() - 2) + 2;
            code += "\"\"";
        } else if (text[i] == '"' || (text[i] == '\'' && (i == 0 || !is_part_of_identifier(text[i - 1])))) {
            const char quote = text[i];
            for (++i; i < text.size() && text[i] != quote && text[i] != '\n'; ++i) i += text[i] == '\\' ? 1U : 0U;
            ++i;
            code += "\"\"";
        } else {
            code += text[i++];
        }
    }
    return code;
}

std::vector<std::string> identifiers_in(const std::string& code) {
    std::vector<std::string> identifiers;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (!is_part_of_identifier(code[i])) continue;
        const std::size_t begin = i;
        while (i < code.size() && is_part_of_identifier(code[i])) ++i;
        if (std::isdigit(static_cast<unsigned char>(code[begin])) == 0)
            identifiers.push_back(code.substr(begin, i - begin));
    }
    return identifiers;
}

// "mostTold_sets" holds the words most, told and sets.
std::set<std::string> words_of(const std::string& identifier) {
    std::set<std::string> words;
    std::string word;
    char before = '_';
    for (const char c : identifier + "_") {
        const bool begins = c == '_' || (std::isupper(static_cast<unsigned char>(c)) != 0 &&
                                         std::islower(static_cast<unsigned char>(before)) != 0);
        if (begins && !word.empty()) words.insert(std::exchange(word, ""));
        if (c != '_') word += char(std::tolower(static_cast<unsigned char>(c)));
        before = c;
    }
    return words;
}

// The code between the braces of every type, function or namespace of that name that is defined.
std::vector<std::string> bodies_of(const std::string& code, const std::string& name) {
    std::vector<std::string> bodies;
    for (std::size_t at = code.find(name); at != std::string::npos; at = code.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at > 0 && is_part_of_identifier(code[at - 1])) || is_part_of_identifier(code[end])) continue;
        const std::size_t open = code.find_first_of("{};", end);
        if (open == std::string::npos || code[open] != '{') continue;
        int depth = 1;
        std::size_t close = open + 1;
        for (; close < code.size() && depth > 0; ++close) depth += (code[close] == '{') - (code[close] == '}');
        bodies.push_back(code.substr(open, close - open));
    }
    return bodies;
}

bool has_identifier(const std::string& code, const std::string& name) {
    const std::vector<std::string> all = identifiers_in(code);
    return std::ranges::find(all, name) != all.end();
}

// Whether the code defines "Name", or "member" in a body of "Name" for "Name::member".
bool defines(const std::string& code, const std::string& name) {
    const std::size_t colons = name.find("::");
    const std::vector<std::string> bodies = bodies_of(code, name.substr(0, colons));
    if (colons == std::string::npos) return !bodies.empty();
    return std::ranges::any_of(bodies,
                               [&](const std::string& body) { return has_identifier(body, name.substr(colons + 2)); });
}

std::string glossary() {
    const std::string page = bytes_of(root / "docs/architecture.md");
    const std::size_t begin = page.find("## Glossary");
    return page.substr(begin, page.find("\n## ", begin) - begin);
}

// The names in the last column of the rows "| word | what it means | `Name`, `Name::member` |".
std::vector<std::string> names_in(const std::string& page) {
    static const std::regex row(R"(\n\|[^|\n]+\|[^|\n]+\|([^|\n]*)\|)");
    static const std::regex name(R"(`([\w:]+)`)");
    std::vector<std::string> names;
    for (std::sregex_iterator match(page.begin(), page.end(), row), end; match != end; ++match) {
        const std::string column = match->str(1);
        for (std::sregex_iterator one(column.begin(), column.end(), name); one != end; ++one) {
            names.push_back(one->str(1));
        }
    }
    return names;
}

// The words in the first column of the rows "| word, word | what to say instead |".
std::set<std::string> retired_in(const std::string& page) {
    static const std::regex row(R"(\n\|([\w, ]+)\|[^|\n]+\|(?=\n))");
    std::set<std::string> words;
    for (std::sregex_iterator match(page.begin(), page.end(), row), end; match != end; ++match) {
        std::istringstream list(std::regex_replace(match->str(1), std::regex(","), " "));
        for (std::string word; list >> word;) words.insert(word);
    }
    words.erase("retired");  // the heading
    return words;
}

template <class Visit>
void for_each_source(Visit visit) {
    for (const char* folder : {"src", "include"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension();
            if (extension != ".cpp" && extension != ".hpp") continue;
            visit(fs::relative(entry.path(), root), code_of(bytes_of(entry.path())));
        }
    }
}

TEST(Glossary, NamesWhatExists) {
    std::string code;
    for_each_source([&](const fs::path&, const std::string& text) { code += text; });
    const std::vector<std::string> names = names_in(glossary());
    EXPECT_GE(names.size(), 40U) << "the tables of the glossary are not read";
    for (const std::string& name : names) EXPECT_TRUE(defines(code, name)) << name;
}

TEST(Glossary, RetiredWordsAreGone) {
    const std::set<std::string> retired = retired_in(glossary());
    EXPECT_GE(retired.size(), 5U) << "the table of retired words is not read";
    for_each_source([&](const fs::path& path, const std::string& code) {
        for (const std::string& identifier : identifiers_in(code)) {
            for (const std::string& word : words_of(identifier)) {
                EXPECT_FALSE(retired.contains(word)) << path << " says " << identifier;
            }
        }
    });
}

// The checks above find what they are for.
TEST(GlossaryCheck, FindsNames) {
    const std::string code = code_of(
        "class Late;\nnamespace deep { enum class Kind : char { one, two }; }\n// struct Gone {}\n"
        "struct Plan { double gap = 0; std::string s = \"bound {\"; };\ninline int sight(int a) { return a; }\n");
    for (const char* name : {"Plan", "Plan::gap", "Kind::two", "deep::Kind", "sight"})
        EXPECT_TRUE(defines(code, name)) << name;
    for (const char* name : {"Pla", "Late", "Gone", "Plan::bound", "Plan::two", "Kind::three"}) {
        EXPECT_FALSE(defines(code, name)) << name;
    }
    EXPECT_EQ(names_in("\n| a | b | `A::x`, `y` |\n| c | `no` | |\n").size(), 2U);
}

TEST(GlossaryCheck, FindsWords) {
    EXPECT_EQ(retired_in("\n| retired | say |\n|---|---|\n| told, dear | reported |\n| a | b | `c` |\n"),
              (std::set<std::string>{"told", "dear"}));
    EXPECT_EQ(words_of("mostTold_sets2_"), (std::set<std::string>{"most", "told", "sets2"}));
    EXPECT_EQ(identifiers_in(code_of("int told_ = 0x1U; // dear\nauto s = \"vain\"; char c = '\"'; crew(1'000)")),
              (std::vector<std::string>{"int", "told_", "auto", "s", "char", "c", "crew"}));
}

}  // namespace
