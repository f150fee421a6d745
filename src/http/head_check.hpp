// Head check: whether a request's head, or the trailers after a chunked body, are well-formed (RFC 9112, 2 to 7;
// RFC 9110, 5 and 7.2), before anything is parsed from them. A proxy in front of the server may interpret a malformed
// head differently, and a request could hide in what only one of them takes for a body (request smuggling): so what the
// standards allow a recipient to repair is refused.
//
//     HeadCheck check;
//     while (!(end = check.end_of_head(bytes))) bytes += more();    // throws Problem as soon as it is malformed
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace waybreaker::http {

class HeadCheck {
  public:
    static constexpr std::size_t most_bytes = std::size_t{32} * 1024;  // of a head, and of trailers
    static constexpr std::size_t most_fields = 100;
    static constexpr std::size_t longest_target = 8192;

    enum class Part { head, trailers };

    explicit HeadCheck(Part part = Part::head) : part_(part), has_request_line_(part == Part::trailers) {}

    // The length of the head including the empty line, once it is complete. Each call passes all bytes received so far.
    // Throws Problem.
    std::optional<std::size_t> end_of_head(std::string_view bytes);

  private:
    void check_byte(char c);
    bool end_line(std::string_view line);
    void check_request_line(std::string_view line);
    void check_field(std::string_view line);
    void check_length(std::string_view value);
    void check_coding(std::string_view value);
    void check_whole() const;

    Part part_;
    std::size_t seen_ = 0;
    std::size_t line_ = 0;  // where it begins
    bool after_return_ = false;
    bool skipped_empty_line_ = false;
    bool has_request_line_;
    std::size_t fields_ = 0;
    bool is_old_ = false;  // HTTP/1.0
    bool has_host_ = false;
    bool has_length_ = false;
    bool has_coding_ = false;
};

}  // namespace waybreaker::http
