// What the handles of waybreaker.h hold, and how a call becomes a status.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/map_file.hpp"
#include "waybreaker.h"
#include "waybreaker/error.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/planner.hpp"

struct waybreaker_text {
    std::string bytes;
};

struct waybreaker_map {
    waybreaker::io::MapFile file;
    waybreaker::Connectivity connectivity = waybreaker::Connectivity::four;
};

struct waybreaker_planner {
    // Empty until it plans, and after a call that ran out of memory in the middle of its work.
    std::optional<waybreaker::Planner> kept;
    // Of the call that runs. The flag is held as long as it takes to copy a pointer; there is no std::mutex where there
    // are no threads, as in WebAssembly.
    std::atomic_flag locked;
    std::optional<waybreaker::StopSource> running;
};

namespace waybreaker::capi {

// The status of the exception that is being handled, and its message, if anybody wants it.
waybreaker_status status_of_exception(waybreaker_text** error) noexcept;

// Gives what `make` returns, a unique_ptr, to whoever called.
template <class Result, class Make>
waybreaker_status give(Result** result, waybreaker_text** error, Make make) noexcept {
    if (error != nullptr) *error = nullptr;
    if (result != nullptr) *result = nullptr;
    try {
        if (result == nullptr) throw InputError("there is no place for the result: its address is NULL");
        *result = make().release();
        return WAYBREAKER_OK;
    } catch (...) {
        return status_of_exception(error);
    }
}

inline std::unique_ptr<waybreaker_text> text_of(std::string bytes) {
    return std::make_unique<waybreaker_text>(waybreaker_text{std::move(bytes)});
}

// REQUIRES of a caller, as an InputError.
template <class T>
T& required(T* pointer, const char* what) {
    if (pointer == nullptr) throw InputError(std::string(what) + " is NULL");
    return *pointer;
}

inline std::string_view bytes_of(const char* data, std::size_t size, const char* what) {
    return size == 0 ? std::string_view() : std::string_view(&required(data, what), size);
}

}  // namespace waybreaker::capi
