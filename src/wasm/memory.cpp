// operator new that throws where memory has run out: that of Debian's C++ library for wasm32-wasi, compiled without
// exceptions, returns null, and WebAssembly lets a program write there.
#include <cstdlib>
#include <new>

namespace {

void* or_throw(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

void* aligned(std::size_t size, std::size_t alignment) {
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    return whole < size ? nullptr : std::aligned_alloc(alignment, whole);
}

}  // namespace

// malloc(0) may return null.
void* operator new(std::size_t size) {
    return or_throw(std::malloc(size > 0 ? size : 1));
}

void* operator new(std::size_t size, std::align_val_t alignment) {
    return or_throw(aligned(size > 0 ? size : 1, std::size_t(alignment)));
}

void* operator new(std::size_t size, const std::nothrow_t& /*unused*/) noexcept {
    return std::malloc(size > 0 ? size : 1);
}

void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t& /*unused*/) noexcept {
    return aligned(size > 0 ? size : 1, std::size_t(alignment));
}

// Those of arrays call these.
