// Where the shared maps and reference figures lie: beside the project, or where WAYBREAKER_SHARED says.
//
//     const auto shared = shared_folder();
//     if (!shared) GTEST_SKIP() << no_shared_folder;
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "project_folder.hpp"

namespace waybreaker {

inline constexpr std::string_view no_shared_folder = "the shared maps are not here: set WAYBREAKER_SHARED";

inline std::optional<std::filesystem::path> shared_folder() {
    const char* const given = std::getenv("WAYBREAKER_SHARED");
    const std::filesystem::path folder =
        given != nullptr ? std::filesystem::path(given) : project_folder() / ".." / "shared";
    return std::filesystem::is_directory(folder / "data") ? std::optional(folder) : std::nullopt;
}

// The files of a folder with that extension, by name.
inline std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder, std::string_view extension) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == extension) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace waybreaker
