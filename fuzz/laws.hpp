// What holds for every parser, whatever bytes it is given: it reads them, or refuses them in one helpful line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "waybreaker/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace waybreaker {

// A broken law ends the program, in every build: that is what the fuzzer looks for.
inline void law(bool holds) {
    if (!holds) std::abort();
}

template <class Parse>
void read_or_refuse(const std::uint8_t* data, std::size_t size, Parse parse) {
    try {
        parse(std::string_view(reinterpret_cast<const char*>(data), size));
    } catch (const InputError& error) {
        const std::string_view message = error.what();
        law(message.starts_with("input:"));
        for (const char c : message) law(static_cast<unsigned char>(c) >= ' ');
    }
}

}  // namespace waybreaker
