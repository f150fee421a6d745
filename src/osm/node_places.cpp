#include "osm/node_places.hpp"

#include <algorithm>
#include <iterator>
#include <protozero/buffer_string.hpp>
#include <protozero/varint.hpp>

namespace waybreaker::osm {
namespace {

constexpr int block_size = 16;  // nodes
constexpr std::size_t chunk_size = std::size_t{1} << 20;

void append(std::string& bytes, std::int64_t difference) {
    protozero::add_varint_to_buffer(&bytes, protozero::encode_zigzag64(difference));
}

std::int64_t take(const char*& at, const char* end) {
    return protozero::decode_zigzag64(protozero::decode_varint(&at, end));
}

}  // namespace

void NodePlaces::add(std::int64_t id, osmium::Location location) {
    if (!blocks_.empty() && id <= last_.id) {
        out_of_order_.emplace_back(id, location);
        return;
    }
    const Entry entry{id, location.x(), location.y()};
    // After a negative id, so that differences of ids stay in 64 bits.
    if (blocks_.empty() || in_block_ == block_size || last_.id < 0) {
        begin_block(entry);
    } else {
        std::string& bytes = chunks_.back();
        append(bytes, entry.id - last_.id);
        append(bytes, std::int64_t{entry.x} - last_.x);
        append(bytes, std::int64_t{entry.y} - last_.y);
        ++in_block_;
    }
    last_ = entry;
}

void NodePlaces::begin_block(const Entry& entry) {
    constexpr std::size_t longest_block = std::size_t{block_size} * 3 * 10;  // bytes
    if (chunks_.empty() || chunks_.back().size() + longest_block > chunk_size) {
        chunks_.emplace_back().reserve(chunk_size);
    }
    blocks_.push_back({entry, std::uint32_t(chunks_.size() - 1), std::uint32_t(chunks_.back().size())});
    in_block_ = 1;
}

void NodePlaces::finish() {
    std::ranges::stable_sort(out_of_order_, {}, &std::pair<std::int64_t, osmium::Location>::first);
}

osmium::Location NodePlaces::find(std::int64_t id) const {
    const auto after = std::ranges::upper_bound(blocks_, id, {}, [](const Block& block) { return block.first.id; });
    if (after != blocks_.begin()) {
        const Block& block = *std::prev(after);
        const std::string& bytes = chunks_[block.chunk];
        const bool last_of_chunk = after == blocks_.end() || after->chunk != block.chunk;
        const char* at = bytes.data() + block.begin;
        const char* const end = last_of_chunk ? bytes.data() + bytes.size() : bytes.data() + after->begin;
        Entry entry = block.first;
        while (entry.id < id && at != end) {
            entry.id += take(at, end);
            entry.x = std::int32_t(entry.x + take(at, end));
            entry.y = std::int32_t(entry.y + take(at, end));
        }
        if (entry.id == id) return {entry.x, entry.y};
    }
    const auto found =
        std::ranges::lower_bound(out_of_order_, id, {}, &std::pair<std::int64_t, osmium::Location>::first);
    return found != out_of_order_.end() && found->first == id ? found->second : osmium::Location();
}

}  // namespace waybreaker::osm
