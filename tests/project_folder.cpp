#include "project_folder.hpp"

namespace waybreaker {

std::filesystem::path project_folder() {
    return WAYBREAKER_SOURCE_DIR;
}

}  // namespace waybreaker
