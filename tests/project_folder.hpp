// Where the project lies. One source knows the path, so that the other tests compile alike in every clone.
#pragma once

#include <filesystem>

namespace waybreaker {

std::filesystem::path project_folder();

}  // namespace waybreaker
