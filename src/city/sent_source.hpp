// Map data that strangers sent: bytes in memory that GDAL reads as a file, with drivers that open nothing else.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace waybreaker::city {

// Known by its path as long as this object lives; several threads may read it.
class SentSource {
  public:
    // `name` is what titles and errors call it: letters, digits, dots, dashes and underscores.
    SentSource(const std::string& name, std::shared_ptr<const std::string> bytes);
    ~SentSource();
    SentSource(const SentSource&) = delete;
    SentSource& operator=(const SentSource&) = delete;

    const std::string& path() const { return path_; }
    // A message about it, with its name in place of its path.
    std::string named(std::string message) const;

    static bool is_path(std::string_view path);

  private:
    std::string name_;
    std::string path_;
};

}  // namespace waybreaker::city
