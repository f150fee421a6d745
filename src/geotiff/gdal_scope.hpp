// GDAL without side effects: silent, without side files, and with its errors as ours.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace waybreaker::geotiff {

// While it exists, GDAL on this thread prints nothing and writes no side files (.aux.xml, .gz.properties); its first
// failure is remembered. Its destructor restores the previous settings, so scopes nest; the outer one does not see
// failures of the inner one.
class GdalScope {
  public:
    GdalScope();
    ~GdalScope();
    GdalScope(const GdalScope&) = delete;
    GdalScope& operator=(const GdalScope&) = delete;

    bool failed() const { return !failure_.empty(); }
    // GDAL's own message in one line, or "unknown cause".
    std::string failure() const;

    // For GDAL's error handler.
    void remember(const char* message);

  private:
    void set_option(const char* name, const char* value);

    std::string failure_;
    std::vector<std::pair<const char*, std::optional<std::string>>> former_options_;
};

// A file in GDAL's memory, unknown to others and gone with this object.
class MemoryFile {
  public:
    MemoryFile();
    // Only a view: the bytes must outlive it, and nobody may write to the file.
    explicit MemoryFile(std::string_view bytes);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::string& path() const { return path_; }
    std::string bytes() const;
    // What GDAL says of the file, without the name that only GDAL knows.
    std::string nameless(std::string message) const;

  private:
    std::string path_;
};

}  // namespace waybreaker::geotiff
