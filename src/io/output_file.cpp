#include "io/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/excerpt.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

namespace fs = std::filesystem;

std::string cause() {
    return std::generic_category().message(errno);
}

// RAII wrapper of a file descriptor.
class File {
  public:
    explicit File(int descriptor) : descriptor_(descriptor) {}
    File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    File& operator=(File&&) = delete;
    ~File() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    explicit operator bool() const { return descriptor_ >= 0; }
    int descriptor() const { return descriptor_; }

    // A full disk may only be reported here. False, with errno set, on failure.
    bool sync_and_close() { return ::fsync(descriptor_) == 0 && ::close(std::exchange(descriptor_, -1)) == 0; }

  private:
    int descriptor_;
};

// Removes the file in its destructor, unless it was renamed.
struct Temporary {
    explicit Temporary(std::string its_path) : path(std::move(its_path)) {}
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary() {
        if (!path.empty()) ::unlink(path.c_str());
    }
    std::string path;
};

// False, with errno set, on failure.
bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(std::size_t(written));
    }
    return true;
}

void write_through(const std::string& path, int descriptor, std::string_view bytes) {
    if (!write_all(descriptor, bytes)) throw InputError("cannot write " + excerpt(path) + ": " + cause());
}

// A new file next to `target`, under an unused name.
std::pair<std::string, File> open_neighbour(const std::string& target) {
    for (int i = 0;; ++i) {
        std::string path = target + "." + std::to_string(::getpid()) + "-" + std::to_string(i) + ".part";
        File file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (file || errno != EEXIST) return {std::move(path), std::move(file)};
    }
}

void replace(const std::string& target, const std::string& path, std::string_view bytes) {
    auto [neighbour, file] = open_neighbour(target);
    if (!file) throw InputError("cannot write " + excerpt(path) + ": " + cause());
    Temporary temporary(neighbour);
    if (!write_all(file.descriptor(), bytes) || !file.sync_and_close() ||
        ::rename(neighbour.c_str(), target.c_str()) != 0) {
        throw InputError("cannot write " + excerpt(path) + ": " + cause());
    }
    temporary.path.clear();
}

}  // namespace

void write_whole(const std::string& path, std::string_view bytes) {
    if (path == "-") return write_through("standard output", STDOUT_FILENO, bytes);
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status))
        throw InputError("cannot write " + excerpt(path) + ": it is a folder; give a file name");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        const File file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
        if (!file) throw InputError("cannot write " + excerpt(path) + ": " + cause());
        return write_through(path, file.descriptor(), bytes);
    }
    const fs::path target = fs::weakly_canonical(path, error);
    replace(error ? path : target.string(), path, bytes);
}

namespace {

// Always a descriptor of its own, as it is closed afterwards.
File open_input(const std::string& path) {
    return File(is_standard_input(path) ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
}

// Reads until `bytes` is full or the file ends: how many of the bytes are read then.
std::size_t fill(const File& file, std::string& bytes, std::size_t size, const std::string& name) {
    while (size < bytes.size()) {
        const ssize_t got = ::read(file.descriptor(), bytes.data() + size, bytes.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw InputError("cannot read " + name + ": " + cause());
        if (got == 0) break;
        size += std::size_t(got);
    }
    return size;
}

}  // namespace

bool is_standard_input(const std::string& path) {
    return path == "-" || path == "/dev/stdin";
}

std::string input_name(const std::string& path) {
    return is_standard_input(path) ? "standard input" : excerpt(path);
}

std::string read_whole(const std::string& path, std::size_t limit, const HeadCheck& check_head) {
    const std::string name = input_name(path);
    const File file = open_input(path);
    struct stat status {};
    if (!file || ::fstat(file.descriptor(), &status) != 0) throw InputError("cannot read " + name + ": " + cause());
    if (S_ISDIR(status.st_mode)) throw InputError("cannot read " + name + ": it is a folder; give a file");

    std::string bytes(std::min(head_size, limit + 1), '\0');
    std::size_t size = fill(file, bytes, 0, name);
    if (check_head) check_head(std::string_view(bytes).substr(0, size));
    const auto refuse = [&] {
        throw InputError("cannot read " + name + ": it has over " + std::to_string(limit) + " bytes");
    };
    // The size of another kind of file says nothing.
    if (S_ISREG(status.st_mode) && status.st_size > off_t(limit)) refuse();
    // One byte more than there should be, so that the end shows without growing.
    const std::size_t expected = std::size_t(std::max<off_t>(status.st_size, 0)) + 1;
    if (size == bytes.size()) bytes.resize(std::clamp(expected, size, limit + 1));
    while ((size = fill(file, bytes, size, name)) == bytes.size() && size <= limit) {
        bytes.resize(std::min(2 * size, limit + 1));
    }
    if (size > limit) refuse();
    bytes.resize(size);
    return bytes;
}

}  // namespace waybreaker::io
