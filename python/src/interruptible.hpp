// Work that other Python threads run beside, and that Ctrl-C ends.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <future>

#include "waybreaker/limits.hpp"

namespace waybreaker::python {

// Whether a signal's handler has raised an exception: it is given, and no longer set. Needs the GIL.
inline std::exception_ptr raised_by_signal() {
    return PyErr_CheckSignals() == 0 ? nullptr : std::make_exception_ptr(pybind11::error_already_set());
}

// The result of work(StopToken), done on a thread of its own while this one looks for signals. REQUIRES: the GIL is
// held; `work` does not use Python.
template <class Work>
auto interruptible(Work work) {
    constexpr std::chrono::milliseconds between_looks{20};
    StopSource source;
    const pybind11::gil_scoped_release release;
    auto result = std::async(std::launch::async, [&] { return work(source.get_token()); });
    while (result.wait_for(between_looks) != std::future_status::ready) {
        std::exception_ptr raised;
        {
            const pybind11::gil_scoped_acquire acquire;
            raised = raised_by_signal();
        }
        if (!raised) continue;
        source.request_stop();
        result.wait();
        std::rethrow_exception(raised);
    }
    return result.get();
}

}  // namespace waybreaker::python
