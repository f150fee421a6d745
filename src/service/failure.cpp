#include "service/failure.hpp"

#include <exception>
#include <new>

#include "http/problem.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

std::string message_in_flight() {
    try {
        throw;
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "an exception that is none of ours";
    }
}

}  // namespace

Failure current_failure() {
    try {
        throw;
    } catch (const http::Problem& problem) {
        return {problem.status(), problem.what(), "", problem.kind()};
    } catch (const InputError& error) {
        return {http::unprocessable, error.what()};
    } catch (const std::bad_alloc&) {
        return {http::unavailable, "too little memory is left for this; ask again", "", "no-memory"};
    } catch (...) {
        return {http::internal_error, "this is our fault; the log says more", message_in_flight()};
    }
}

}  // namespace waybreaker::service
