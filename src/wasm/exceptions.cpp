// What throwing and catching needs below the compiler (Itanium C++ ABI, on WebAssembly's own exceptions): Debian's C++
// library for wasm32-wasi is compiled without. For one thread, and for thrown objects, not thrown pointers.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <typeinfo>

namespace waybreaker::wasm {
namespace {

using Destructor = void* (*)(void*);  // they return `this` on WebAssembly

// Lies before the thrown object.
struct alignas(16) Exception {
    const std::type_info* type;
    Destructor destroy;
    void* as_caught;           // the object as its handler's type sees it
    int handlers;              // that are running
    bool rethrown;             // by one of them
    Exception* caught_before;  // whose handlers run outside of this one's
};

Exception* innermost = nullptr;  // of those whose handlers run

Exception* header_of(void* object) {
    return static_cast<Exception*>(object) - 1;
}

void* object_of(Exception* exception) {
    return exception + 1;
}

// Where there is no memory for an exception, std::bad_alloc among them: the last one stays until it is freed.
constexpr std::size_t spare_bytes = 256;
alignas(Exception) std::byte spare[spare_bytes];
bool spare_in_use = false;

// The order of virtual functions in libc++abi's type_info, whose can_catch knows about base classes.
struct CatchableType : std::type_info {
    virtual void unused_1() const = 0;
    virtual void unused_2() const = 0;
    virtual bool can_catch(const CatchableType* thrown, void*& object) const = 0;
};

bool catches(const std::type_info* caught, Exception& exception) {
    if (caught == nullptr) return true;  // catch (...)
    void* object = object_of(&exception);
    const auto* const thrown = static_cast<const CatchableType*>(exception.type);
    if (!static_cast<const CatchableType*>(caught)->can_catch(thrown, object)) return false;
    exception.as_caught = object;
    return true;
}

// Reads the table that the compiler makes of a function's handlers ("language-specific data area").
class Table {
  public:
    explicit Table(const void* at) : at_(static_cast<const std::uint8_t*>(at)) {}

    const std::uint8_t* at() const { return at_; }
    std::uint8_t byte() { return *at_++; }
    std::uint32_t number() { return bits().value; }
    std::int32_t signed_number() {
        const auto [value, width, last] = bits();
        const bool negative = width < 32 && (last & 0x40U) != 0;
        return std::int32_t(negative ? value | (~0U << width) : value);
    }

  private:
    struct Bits {
        std::uint32_t value;
        unsigned width;
        std::uint8_t last;
    };
    // LEB128: seven bits a byte, the lowest first.
    Bits bits() {
        Bits read{0, 0, 0};
        do {
            read.last = byte();
            read.value |= std::uint32_t(read.last & 0x7fU) << read.width;
            read.width += 7;
        } while ((read.last & 0x80U) != 0);
        return read;
    }

    const std::uint8_t* at_;
};

// The number, in the function's table, of the type that catches the exception at that place; 0: it goes on.
std::uint32_t handler_at(std::uint32_t place, const void* function_table, Exception& exception) {
    constexpr std::uint8_t omitted = 0xff;
    Table table(function_table);
    if (table.byte() != omitted || table.byte() == omitted) std::abort();  // no landing pads elsewhere; has types
    const std::uint32_t to_types = table.number();
    const auto* const types = reinterpret_cast<const std::type_info* const*>(table.at() + to_types);
    table.byte();  // how places are encoded: as numbers
    const std::uint32_t places_size = table.number();
    const std::uint8_t* const actions = table.at() + places_size;
    std::uint32_t action = 0;
    for (std::uint32_t i = 0; i <= place; ++i) {
        table.number();
        action = table.number();
    }
    if (action == 0) return 0;
    for (Table record(actions + action - 1);;) {
        const std::int32_t type = record.signed_number();
        if (type > 0 && catches(types[-type], exception)) return std::uint32_t(type);
        const std::uint8_t* const from = record.at();
        const std::int32_t next = record.signed_number();
        if (next == 0) return 0;
        record = Table(from + next);
    }
}

[[noreturn]] void raise(Exception* exception) {
    __builtin_wasm_throw(0, exception);  // 0: the tag of C++
}

}  // namespace
}  // namespace waybreaker::wasm

using namespace waybreaker::wasm;

extern "C" {

// The compiler writes place and table, and reads the selected type.
struct {
    std::uint32_t place;
    const void* table;
    std::uint32_t selected;
} __wasm_lpad_context;

int _Unwind_CallPersonality(void* exception) {
    __wasm_lpad_context.selected =
        handler_at(__wasm_lpad_context.place, __wasm_lpad_context.table, *static_cast<Exception*>(exception));
    return 0;
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
    if (void* const memory = std::malloc(sizeof(Exception) + size)) return object_of(static_cast<Exception*>(memory));
    if (spare_in_use || sizeof(Exception) + size > spare_bytes) std::terminate();
    spare_in_use = true;
    return object_of(reinterpret_cast<Exception*>(spare));
}

void __cxa_free_exception(void* object) noexcept {
    Exception* const exception = header_of(object);
    if (exception == reinterpret_cast<Exception*>(spare)) {
        spare_in_use = false;
    } else {
        std::free(exception);
    }
}

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, Destructor destroy) {
    Exception* const exception = header_of(object);
    *exception = {type, destroy, object, 0, false, nullptr};
    raise(exception);
}

void* __cxa_begin_catch(void* thrown) noexcept {
    auto* const exception = static_cast<Exception*>(thrown);
    exception->rethrown = false;
    if (exception->handlers++ == 0) {
        exception->caught_before = innermost;
        innermost = exception;
    }
    return exception->as_caught;
}

void __cxa_end_catch() {
    Exception* const exception = innermost;
    if (--exception->handlers > 0) return;
    innermost = exception->caught_before;
    if (exception->rethrown) return;
    if (exception->destroy != nullptr) exception->destroy(object_of(exception));
    __cxa_free_exception(object_of(exception));
}

[[noreturn]] void __cxa_rethrow() {
    if (innermost == nullptr) std::terminate();
    innermost->rethrown = true;
    raise(innermost);
}

}  // extern "C"
