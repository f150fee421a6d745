#include <new>
#include <stdexcept>

#include "capi/handles.hpp"

namespace waybreaker::capi {
namespace {

waybreaker_status failed(waybreaker_status status, const char* message, waybreaker_text** error) noexcept {
    try {
        if (error != nullptr) *error = text_of(message).release();
    } catch (...) {
        *error = nullptr;  // no memory for it: the status has to do
    }
    return status;
}

}  // namespace

waybreaker_status status_of_exception(waybreaker_text** error) noexcept {
    try {
        throw;
    } catch (const InputError& fault) {
        return failed(WAYBREAKER_INPUT_ERROR, fault.what(), error);
    } catch (const std::bad_alloc&) {
        return failed(WAYBREAKER_OUT_OF_MEMORY, "there is not enough memory", error);
    } catch (const std::length_error&) {
        return failed(WAYBREAKER_OUT_OF_MEMORY, "there is not enough memory", error);
    } catch (const std::exception& fault) {
        return failed(WAYBREAKER_INTERNAL_ERROR, fault.what(), error);
    } catch (...) {
        return failed(WAYBREAKER_INTERNAL_ERROR, "an exception of unknown type", error);
    }
}

}  // namespace waybreaker::capi

const char* waybreaker_version(void) {
    return WAYBREAKER_VERSION_STRING;
}

const char* waybreaker_text_data(const waybreaker_text* text) {
    return text == nullptr ? "" : text->bytes.c_str();
}

size_t waybreaker_text_size(const waybreaker_text* text) {
    return text == nullptr ? 0 : text->bytes.size();
}

void waybreaker_text_free(waybreaker_text* text) {
    delete text;
}
