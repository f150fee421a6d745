#include "service/limits.hpp"

#include <unistd.h>

namespace waybreaker::service {

std::size_t default_memory() {
    return std::size_t(::sysconf(_SC_PHYS_PAGES)) * std::size_t(::sysconf(_SC_PAGESIZE)) / 2;
}

}  // namespace waybreaker::service
