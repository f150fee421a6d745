// Head check: whether the bytes of a request's head are sound (RFC 9112, 2 to 6; RFC 9110, 5 and 7.2), before anybody
// reads a value out of them. Who lies in front of the server may read an unsound head otherwise than we do, and a
// request could hide in what one takes for a body and the other does not: so what the standards let a recipient mend,
// is refused.
//
//     HeadCheck check;
//     while (!(end = check.end_of_head(bytes))) bytes += more();    // throws Problem as soon as it is unsound
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace waybreaker::server {

class HeadCheck {
  public:
    static constexpr std::size_t most_bytes = 32 * 1024;  // of a head
    static constexpr std::size_t most_fields = 100;
    static constexpr std::size_t longest_target = 8192;

    // How many of the bytes are the head, the empty line included, once all of it is there. Each call brings the bytes
    // of the last one, and those that have come since. Throws Problem.
    std::optional<std::size_t> end_of_head(std::string_view bytes);

  private:
    void check_byte(char c);
    bool end_line(std::string_view line);
    void check_request_line(std::string_view line);
    void check_field(std::string_view line);
    void check_length(std::string_view value);
    void check_coding(std::string_view value);
    void check_whole() const;

    std::size_t seen_ = 0;
    std::size_t line_ = 0;  // where it begins
    bool after_return_ = false;
    bool skipped_empty_line_ = false;
    bool has_request_line_ = false;
    std::size_t fields_ = 0;
    bool is_old_ = false;  // HTTP/1.0
    bool has_host_ = false;
    bool has_length_ = false;
    bool has_coding_ = false;
};

}  // namespace waybreaker::server
