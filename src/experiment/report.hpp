// Report: the results of the paper's experiment as a self-contained page: figures, numbers, claims.
#pragma once

#include <string>
#include <vector>

#include "experiment/summary.hpp"

namespace waybreaker::experiment {

struct ReportFile {
    std::string name;
    std::string bytes;
};

// index.html, which needs nothing beside it, and every figure as SVG and PNG. The figures are over all missions of the
// file; several sets are also compared with each other.
std::vector<ReportFile> report(const Summary& summary);

}  // namespace waybreaker::experiment
