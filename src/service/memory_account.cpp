#include "service/memory_account.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

namespace waybreaker::service {
namespace {

// The budget is asked once for so much, not for each allocation.
constexpr std::size_t step = std::size_t{1} << 20;

thread_local MemoryAccount* account_of_thread = nullptr;

}  // namespace

MemoryAccount::Scope::Scope(MemoryAccount* account) : outer_(std::exchange(account_of_thread, account)) {}

MemoryAccount::Scope::~Scope() {
    account_of_thread = outer_;
}

// Others that give back memory for it must not seem to free this account's.
bool MemoryAccount::reserve(std::size_t bytes) {
    const Scope none(nullptr);
    return share_.grow(std::max(bytes, step)) || share_.grow(bytes);
}

bool MemoryAccount::add(std::size_t bytes) {
    const std::size_t after = bytes_ + bytes;
    if (after > share_.bytes() && !reserve(after - share_.bytes())) {
        needed_ = after;
        return false;
    }
    bytes_ = after;
    return true;
}

void MemoryAccount::subtract(std::size_t bytes) {
    bytes_ -= std::min(bytes, bytes_);
    if (share_.bytes() - bytes_ > 8 * step) share_.shrink_to(bytes_ + step);
}

}  // namespace waybreaker::service

// NOLINTBEGIN(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory,bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp):
// this is operator new, and the linker wants these names

#if defined(__clang__)
#pragma clang diagnostic ignored "-Wreserved-identifier"
#endif

extern "C" {
void* __real_calloc(std::size_t count, std::size_t size);
void __real_free(void* memory);

void* __wrap_calloc(std::size_t count, std::size_t size) {
    using waybreaker::service::account_of_thread;
    void* const memory = __real_calloc(count, size);
    if (memory == nullptr || account_of_thread == nullptr || account_of_thread->add(malloc_usable_size(memory)))
        return memory;
    __real_free(memory);
    return nullptr;
}

void __wrap_free(void* memory) {
    using waybreaker::service::account_of_thread;
    if (account_of_thread != nullptr && memory != nullptr) account_of_thread->subtract(malloc_usable_size(memory));
    __real_free(memory);
}
}

void* operator new(std::size_t size) {
    using waybreaker::service::account_of_thread;
    void* memory = std::malloc(std::max<std::size_t>(size, 1));
    while (memory == nullptr) {
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
        memory = std::malloc(std::max<std::size_t>(size, 1));
    }
    if (account_of_thread != nullptr && !account_of_thread->add(malloc_usable_size(memory))) {
        __real_free(memory);
        throw std::bad_alloc();
    }
    return memory;
}

// As the standard library's does, but not that of a sanitizer, which would miss its own operator delete.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    try {
        return operator new(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void operator delete(void* memory) noexcept {
    __wrap_free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    __wrap_free(memory);
}

// NOLINTEND(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory,bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
