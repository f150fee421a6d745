// Runs of bits in a line of 64-bit words, tested a word at a time.
#pragma once

#include <bit>
#include <cstdint>

namespace waybreaker {

// Whether any of the bits first..last (both included) of the line is set. Precondition: 0 <= first <= last.
inline bool any_bit(const std::uint64_t* line, unsigned first, unsigned last) {
    const unsigned first_word = first / 64;
    const unsigned last_word = last / 64;
    const std::uint64_t from = ~std::uint64_t{0} << (first % 64);
    const std::uint64_t to = ~std::uint64_t{0} >> (63 - last % 64);
    if (first_word == last_word) return (line[first_word] & from & to) != 0;
    if ((line[first_word] & from) != 0) return true;
    for (unsigned word = first_word + 1; word < last_word; ++word) {
        if (line[word] != 0) return true;
    }
    return (line[last_word] & to) != 0;
}

// Calls visit(first, last) for every maximal run of set bits among the `bits` bits that start at bit 1 of the line (bit
// 0 and the bits after them are frame); positions count from that bit 1.
template <class Visit>
void for_each_run(const std::uint64_t* line, int bits, Visit visit) {
    const int end = bits + 1;  // first bit of the frame behind
    int position = 1;
    while (position < end) {
        std::uint64_t word = line[position / 64] >> (position % 64);
        if (word == 0) {
            position = (position / 64 + 1) * 64;
            continue;
        }
        position += std::countr_zero(word);
        if (position >= end) return;
        const int first = position;
        for (;;) {
            word = ~line[position / 64] >> (position % 64);
            if (word != 0) {
                position += std::countr_zero(word);
                break;
            }
            position = (position / 64 + 1) * 64;
            if (position >= end) break;
        }
        if (position > end) position = end;
        visit(first - 1, position - 2);
    }
}

}  // namespace waybreaker
