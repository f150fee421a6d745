#include "http/gzip.hpp"

#include <zlib.h>

#include <array>
#include <memory>
#include <new>
#include <stdexcept>

#include "http/header_list.hpp"
#include "http/problem.hpp"

namespace waybreaker::http {
namespace {

constexpr int gzip_window = 15 + 16;  // zlib: the largest window, in gzip's format

// Whether a weight is above 0: "q=0", "q=0." and "q=0.000" are not.
bool is_wanted(std::string_view parameters) {
    const std::size_t weight = parameters.find("q=");
    if (weight == std::string_view::npos) return true;
    return parameters.substr(weight + 2).find_first_not_of("0. \t") != std::string_view::npos;
}

}  // namespace

bool accepts_gzip(std::string_view accept_encoding) {
    bool any = false;
    for (const std::string& item : header_list(accept_encoding)) {
        const std::size_t semicolon = item.find(';');
        const std::string_view coding = trimmed(std::string_view(item).substr(0, semicolon));
        const bool wanted = semicolon == std::string::npos || is_wanted(std::string_view(item).substr(semicolon));
        if (coding == "gzip" || coding == "x-gzip") return wanted;
        if (coding == "*") any = wanted;
    }
    return any;
}

std::string gzip(std::string_view bytes, int level) {
    constexpr int usual_memory = 8;
    z_stream stream{};
    if (deflateInit2(&stream, level, Z_DEFLATED, gzip_window, usual_memory, Z_DEFAULT_STRATEGY) != Z_OK) {
        throw std::bad_alloc();
    }
    std::string packed(deflateBound(&stream, uLong(bytes.size())), '\0');
    // zlib does not write to its input, and counts to 4 GiB; no response is that large.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = uInt(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = uInt(packed.size());
    const int outcome = deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    if (outcome != Z_STREAM_END) throw std::runtime_error("gzip ends before its input does");
    return packed;
}

// Programs that compress in parallel write several members, one after the other (RFC 1952, 2.2).
std::string gunzip(std::string_view packed, std::size_t most) {
    z_stream stream{};
    if (inflateInit2(&stream, gzip_window) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> ends(&stream, inflateEnd);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = uInt(packed.size());
    std::string bytes;
    std::array<char, 65536> piece{};
    int outcome = Z_OK;
    while (outcome == Z_OK || (outcome == Z_STREAM_END && stream.avail_in > 0)) {
        if (outcome == Z_STREAM_END) inflateReset(&stream);
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = uInt(piece.size());
        outcome = inflate(&stream, Z_NO_FLUSH);
        const std::size_t count = piece.size() - stream.avail_out;
        if (count > most - bytes.size()) {
            throw body_too_large(most, " when it is unpacked");
        }
        bytes.append(piece.data(), count);
    }
    if (outcome != Z_STREAM_END) throw Problem(bad_request, "the body is not gzip, or not all of it");
    return bytes;
}

}  // namespace waybreaker::http
