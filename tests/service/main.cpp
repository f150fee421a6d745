// The tests of the service; and the process that it starts for each import.
#include <gtest/gtest.h>

#include <string_view>

#include "service/import_worker.hpp"

int main(int argc, char** argv) {
    using namespace waybreaker::service;
    if (argc == 4 && std::string_view(argv[1]) == import_worker_word) return run_import_worker(argv[2], argv[3]);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
