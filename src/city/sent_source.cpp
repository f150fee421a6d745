#include "city/sent_source.hpp"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

namespace waybreaker::city {
namespace {

constexpr char prefix_text[] = "/vsisent/";  // GDAL keeps the pointer
constexpr std::string_view prefix = prefix_text;

using Content = std::shared_ptr<const std::string>;

// Those that live, by what follows the prefix.
class Contents {
  public:
    std::string add(const std::string& name, Content content) {
        const std::scoped_lock lock(mutex_);
        std::string key = fmt::format("{}/{}", ++count_, name);
        contents_.emplace(key, std::move(content));
        return key;
    }
    void remove(const std::string& key) {
        const std::scoped_lock lock(mutex_);
        contents_.erase(key);
    }
    // Without bytes if there is none of that name.
    Content find(const char* key) {
        const std::scoped_lock lock(mutex_);
        const auto found = contents_.find(key);
        return found == contents_.end() ? Content() : found->second;
    }

  private:
    std::mutex mutex_;
    std::uint64_t count_ = 0;
    std::map<std::string, Content, std::less<>> contents_;
};

Contents& contents() {
    static Contents all;
    return all;
}

// What GDAL has opened.
struct Handle {
    Content content;
    vsi_l_offset at = 0;
    bool ended = false;
};

int stat_of(void*, const char* name, VSIStatBufL* status, int) {
    std::memset(status, 0, sizeof *status);
    const Content content = contents().find(name);
    if (!content) return -1;
    status->st_mode = S_IFREG;
    status->st_size = static_cast<decltype(status->st_size)>(content->size());
    return 0;
}

void* open(void*, const char* name, const char* access) {
    if (std::strpbrk(access, "wa+") != nullptr) return nullptr;
    Content content = contents().find(name);
    return content ? new Handle{std::move(content)} : nullptr;
}

vsi_l_offset tell(void* file) {
    return static_cast<Handle*>(file)->at;
}

int seek(void* file, vsi_l_offset offset, int whence) {
    auto& handle = *static_cast<Handle*>(file);
    handle.ended = false;
    if (whence == SEEK_SET) handle.at = offset;
    if (whence == SEEK_CUR) handle.at += offset;
    if (whence == SEEK_END) handle.at = handle.content->size() + offset;
    return 0;
}

std::size_t read(void* file, void* buffer, std::size_t size, std::size_t count) {
    auto& handle = *static_cast<Handle*>(file);
    const std::string& bytes = *handle.content;
    const std::size_t left = handle.at >= bytes.size() ? 0 : bytes.size() - handle.at;
    const std::size_t length = std::min(left, size * count);
    if (length > 0) std::memcpy(buffer, bytes.data() + handle.at, length);
    handle.at += length;
    handle.ended = length < size * count;
    return size == 0 ? 0 : length / size;
}

int eof(void* file) {
    return static_cast<Handle*>(file)->ended ? 1 : 0;
}

int close(void* file) {
    delete static_cast<Handle*>(file);
    return 0;
}

void install() {
    VSIFilesystemPluginCallbacksStruct* const calls = VSIAllocFilesystemPluginCallbacksStruct();
    calls->stat = stat_of;
    calls->open = open;
    calls->tell = tell;
    calls->seek = seek;
    calls->read = read;
    calls->eof = eof;
    calls->close = close;
    VSIInstallPluginHandler(prefix_text, calls);
    VSIFreeFilesystemPluginCallbacksStruct(calls);
}

}  // namespace

SentSource::SentSource(const std::string& name, std::shared_ptr<const std::string> bytes) : name_(name) {
    static std::once_flag installed;
    std::call_once(installed, install);
    path_ = std::string(prefix) + contents().add(name, std::move(bytes));
}

SentSource::~SentSource() {
    contents().remove(path_.substr(prefix.size()));
}

std::string SentSource::named(std::string message) const {
    for (const std::string& path : {"/vsigzip/" + path_, path_}) {
        for (std::size_t at; (at = message.find(path)) != std::string::npos;) message.replace(at, path.size(), name_);
    }
    return message;
}

bool SentSource::is_path(std::string_view path) {
    return path.starts_with(prefix);
}

}  // namespace waybreaker::city
