#include "format_losses.hpp"

#include "note.hpp"

namespace waybreaker::apps {

void report_losses(const std::string& path, const std::vector<std::string>& losses) {
    for (const std::string& loss : losses) note(path, loss);
}

}  // namespace waybreaker::apps
