#include "geotiff/hex_zlib.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>

#include <algorithm>
#include <memory>
#include <new>

namespace waybreaker::geotiff {
namespace {

struct FreeMemory {
    void operator()(void* memory) const { VSIFree(memory); }
};
template <class T>
using GdalMemory = std::unique_ptr<T, FreeMemory>;

}  // namespace

std::string deflated(const std::vector<std::uint8_t>& bytes) {
    constexpr int smallest = 9;
    std::size_t size = 0;
    const GdalMemory<void> packed(CPLZLibDeflate(bytes.data(), bytes.size(), smallest, nullptr, 0, &size));
    if (!packed) throw std::bad_alloc();
    const GdalMemory<char> digits(CPLBinaryToHex(int(size), static_cast<const GByte*>(packed.get())));
    return digits.get();
}

std::vector<std::uint8_t> inflated(std::string_view digits, std::size_t most) {
    int size = 0;
    const GdalMemory<GByte> packed(CPLHexToBinary(std::string(digits).c_str(), &size));
    std::vector<std::uint8_t> bytes;
    for (std::size_t room = std::min(4 * digits.size() + 1, most); room < 2 * most; room *= 2) {
        bytes.resize(std::min(room, most));
        std::size_t filled = 0;
        if (!CPLZLibInflate(packed.get(), std::size_t(size), bytes.data(), bytes.size(), &filled)) continue;
        bytes.resize(filled);
        return bytes;
    }
    return {};
}

}  // namespace waybreaker::geotiff
