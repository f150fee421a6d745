#include "http/malformed_requests.hpp"

namespace waybreaker::http {
namespace {

const std::string nul(1, '\0');

// What comes before and after the line that is wrong.
std::string with_line(const std::string& line) {
    return "GET /healthz HTTP/1.1\r\nHost: localhost\r\n" + line + "\r\n\r\n";
}

std::string with_request_line(const std::string& line) {
    return line + "\r\nHost: localhost\r\n\r\n";
}

std::string with_host(const std::string& host) {
    return "GET /healthz HTTP/1.1\r\nHost: " + host + "\r\n\r\n";
}

std::string plan(const std::string& headers, const std::string& body) {
    return "POST /api/v1/maps/house.map/plan HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n" +
           headers + "\r\n" + body;
}

std::string chunked(const std::string& body) {
    return plan("Transfer-Encoding: chunked\r\n", body);
}

using Table = std::vector<Malformed>;

// RFC 9112, 2.2 and 3: lines and the first of them.
Table request_lines() {
    return {{"lines end with LF alone", "GET /healthz HTTP/1.1\nHost: localhost\n\n", 400},
            {"one line ends with LF alone", "GET /healthz HTTP/1.1\r\nHost: localhost\nX: 1\r\n\r\n", 400},
            {"the last line ends with LF alone", "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\n", 400},
            {"a bare CR in the first line", with_request_line("GET /healthz\r HTTP/1.1"), 400},
            {"a bare CR in a header", with_line("X: a\rb"), 400},
            {"a bare CR as a line's end", "GET /healthz HTTP/1.1\rHost: localhost\r\r", 400},
            {"two CR", "GET /healthz HTTP/1.1\r\r\nHost: localhost\r\n\r\n", 400},
            {"two empty lines first", "\r\n\r\n", 400},
            {"blanks before the request", with_request_line(" GET /healthz HTTP/1.1"), 400},
            {"a header before the request", "Host: localhost\r\n\r\n", 400},
            {"a line of blanks after the first", "GET /healthz HTTP/1.1\r\n \r\nHost: localhost\r\n\r\n", 400},
            {"a folded line after the first", "GET /healthz HTTP/1.1\r\n X: 1\r\nHost: localhost\r\n\r\n", 400},
            {"HTTP/0.9", "GET /healthz\r\n", 400},
            {"no address", with_request_line("GET HTTP/1.1"), 400},
            {"an empty address", with_request_line("GET  HTTP/1.1"), 400},
            {"two blanks before the address", with_request_line("GET  /healthz HTTP/1.1"), 400},
            {"two blanks before the version", with_request_line("GET /healthz  HTTP/1.1"), 400},
            {"a tab for a blank", with_request_line("GET\t/healthz HTTP/1.1"), 400},
            {"a blank in the address", with_request_line("GET /heal thz HTTP/1.1"), 400},
            {"a blank after the version", with_request_line("GET /healthz HTTP/1.1 "), 400},
            {"no method", with_request_line(" /healthz HTTP/1.1"), 400},
            {"a method that is no word", with_request_line("G@T /healthz HTTP/1.1"), 400},
            {"a method in quotes", with_request_line("\"GET\" /healthz HTTP/1.1"), 400},
            {"a NUL in the first line", with_request_line("GET /healthz" + nul + " HTTP/1.1"), 400},
            {"TLS", "\x16\x03\x01" + nul + "\xf5\x01", 400}};
}

// RFC 9112, 2.3.
Table versions() {
    return {{"HTTP in small letters", with_request_line("GET /healthz http/1.1"), 400},
            {"no HTTP", with_request_line("GET /healthz HTCPCP/1.0"), 400},
            {"no dot", with_request_line("GET /healthz HTTP/11"), 400},
            {"a comma", with_request_line("GET /healthz HTTP/1,1"), 400},
            {"two digits", with_request_line("GET /healthz HTTP/1.10"), 400},
            {"three parts", with_request_line("GET /healthz HTTP/1.1.1"), 400},
            {"no minor version", with_request_line("GET /healthz HTTP/1."), 400},
            {"a sign", with_request_line("GET /healthz HTTP/+1.1"), 400},
            {"HTTP/1.2", with_request_line("GET /healthz HTTP/1.2"), 505},
            {"HTTP/0.9, said", with_request_line("GET /healthz HTTP/0.9"), 505},
            {"HTTP/2", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", 505},
            {"HTTP/3", with_request_line("GET /healthz HTTP/3.0"), 505}};
}

// RFC 9112, 3.2; RFC 3986.
Table addresses() {
    return {{"a path that does not begin with /", with_request_line("GET healthz HTTP/1.1"), 400},
            {"* for another method", with_request_line("GET * HTTP/1.1"), 400},
            {"a host and port", with_request_line("GET localhost:80 HTTP/1.1"), 400},
            {"a tunnel", with_request_line("CONNECT localhost:80 HTTP/1.1"), 501},
            {"a fragment", with_request_line("GET /healthz#x HTTP/1.1"), 400},
            {"half an escape", with_request_line("GET /healthz%2 HTTP/1.1"), 400},
            {"an escape that is none", with_request_line("GET /healthz%zz HTTP/1.1"), 400},
            {"an escape that is none, in the query", with_request_line("GET /healthz?a=%g0 HTTP/1.1"), 400},
            {"angle brackets", with_request_line("GET /<healthz> HTTP/1.1"), 400},
            {"quotes in the query", with_request_line("GET /healthz?\"a\" HTTP/1.1"), 400},
            {"letters that are not ASCII", with_request_line("GET /h\xc3\xa9 HTTP/1.1"), 400},
            {"another scheme", with_request_line("GET ftp://localhost/healthz HTTP/1.1"), 400},
            {"no host after the scheme", with_request_line("GET http:///healthz HTTP/1.1"), 400},
            {"a user in the address", with_request_line("GET http://me@localhost/healthz HTTP/1.1"), 400},
            {"a port that is none", with_request_line("GET http://localhost:8o/healthz HTTP/1.1"), 400},
            {"a long address", with_request_line("GET /" + std::string(8192, 'a') + " HTTP/1.1"), 414},
            {"an address without end", "GET /" + std::string(40000, 'a'), 414}};
}

// RFC 9110, 7.2; RFC 9112, 3.2.
Table hosts() {
    return {{"no Host", "GET /healthz HTTP/1.1\r\n\r\n", 400},
            {"Host twice", with_line("Host: localhost"), 400},
            {"Host twice, otherwise", with_line("hOST: evil.example"), 400},
            {"a NUL in Host", with_host("localhost" + nul + ".evil.example"), 400},
            {"a user in Host", with_host("me@localhost"), 400},
            {"a path in Host", with_host("localhost/evil"), 400},
            {"two names in Host", with_host("localhost, evil.example"), 400},
            {"a blank in Host", with_host("localhost evil.example"), 400},
            {"a port alone", with_host(":80"), 400},
            {"a port that is none", with_host("localhost:eighty"), 400},
            {"a port that is too long", with_host("localhost:000080"), 400},
            {"two ports", with_host("localhost:80:80"), 400},
            {"half an address of IPv6", with_host("[::1"), 400},
            {"something after an address of IPv6", with_host("[::1]evil"), 400},
            {"brackets without an address", with_host("[localhost]"), 400},
            {"a backslash", with_host("localhost\\evil"), 400}};
}

// RFC 9110, 5; RFC 9112, 5.
Table headers() {
    std::string many;
    for (int i = 0; i < 101; ++i) many += "X-" + std::to_string(i) + ": 1\r\n";
    return {{"a folded header", with_line("X: a\r\n b"), 400},
            {"a folded header, by a tab", with_line("X: a\r\n\tb"), 400},
            {"a folded Content-Length", plan("Content-Length:\r\n 45\r\n", ""), 400},
            {"a folded Transfer-Encoding", plan("Transfer-Encoding:\r\n chunked\r\n", ""), 400},
            {"no colon", with_line("X"), 400},
            {"a blank before the colon", with_line("X : 1"), 400},
            {"a tab before the colon", with_line("X\t: 1"), 400},
            {"a blank before the colon of Content-Length", plan("Content-Length : 2\r\n", "{}"), 400},
            {"no name", with_line(": 1"), 400},
            {"a name in brackets", with_line("(X): 1"), 400},
            {"a slash in a name", with_line("X/Y: 1"), 400},
            {"a name that is not ASCII", with_line("X\xc3\xa9: 1"), 400},
            {"a NUL in a name", with_line("X" + nul + ": 1"), 400},
            {"a NUL in a value", with_line("X: " + nul), 400},
            {"a control character in a value", with_line("X: \x01"), 400},
            {"a backspace in a value", with_line("X: \x08"), 400},
            {"DEL in a value", with_line("X: \x7f"), 400},
            {"too many headers", "GET /healthz HTTP/1.1\r\nHost: localhost\r\n" + many + "\r\n", 431},
            {"a long header", with_line("X: " + std::string(32768, 'x')), 431},
            {"headers without end", "GET /healthz HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(40000, 'x'), 431}};
}

// RFC 9112, 6.1 to 6.3.
Table lengths() {
    return {
        {"two lengths", plan("Content-Length: 2\r\nContent-Length: 20\r\n", "{}"), 400},
        {"the same length twice", plan("Content-Length: 2\r\nContent-Length: 2\r\n", "{}"), 400},
        {"a list of lengths", plan("Content-Length: 2, 2\r\n", "{}"), 400},
        {"no length", plan("Content-Length: \r\n", "{}"), 400},
        {"a negative length", plan("Content-Length: -2\r\n", "{}"), 400},
        {"a signed length", plan("Content-Length: +2\r\n", "{}"), 400},
        {"a hexadecimal length", plan("Content-Length: 0x2\r\n", "{}"), 400},
        {"a length with a fraction", plan("Content-Length: 2.0\r\n", "{}"), 400},
        {"a length with an exponent", plan("Content-Length: 2e0\r\n", "{}"), 400},
        {"a length with a blank", plan("Content-Length: 2 0\r\n", "{}"), 400},
        {"a length with a unit", plan("Content-Length: 2 bytes\r\n", "{}"), 400},
        {"a length in quotes", plan("Content-Length: \"2\"\r\n", "{}"), 400},
        {"a length over 64 bits", plan("Content-Length: 18446744073709551618\r\n", "{}"), 400},
        {"a length and chunks", plan("Content-Length: 2\r\nTransfer-Encoding: chunked\r\n", "0\r\n\r\n"), 400},
        {"chunks and a length", plan("Transfer-Encoding: chunked\r\nContent-Length: 2\r\n", "0\r\n\r\n"), 400},
        {"chunks twice", plan("Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n", "0\r\n\r\n"), 400},
        {"chunks in chunks", plan("Transfer-Encoding: chunked, chunked\r\n", "0\r\n\r\n"), 400},
        {"chunks not last", plan("Transfer-Encoding: chunked, gzip\r\n", "0\r\n\r\n"), 400},
        {"no coding", plan("Transfer-Encoding: \r\n", "0\r\n\r\n"), 400},
        {"commas for a coding", plan("Transfer-Encoding: ,chunked,\r\n", "0\r\n\r\n"), 501},
        {"a parameter of chunked", plan("Transfer-Encoding: chunked;q=1\r\n", "0\r\n\r\n"), 501},
        {"a vertical tab before chunked", plan("Transfer-Encoding: \x0b chunked\r\n", "0\r\n\r\n"), 400},
        {"an unknown coding", plan("Transfer-Encoding: xchunked\r\n", "0\r\n\r\n"), 501},
        {"identity", plan("Transfer-Encoding: identity\r\n", "{}"), 501},
        {"compressed chunks", plan("Transfer-Encoding: gzip, chunked\r\n", "0\r\n\r\n"), 501},
        {"chunks of HTTP/1.0",
         "POST /api/v1/maps/house.map/plan HTTP/1.0\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n", 400}};
}

// RFC 9112, 7.1.
Table chunks() {
    return {{"a negative size", chunked("-2\r\n{}\r\n0\r\n\r\n"), 400},
            {"a signed size", chunked("+2\r\n{}\r\n0\r\n\r\n"), 400},
            {"a size that is none", chunked("two\r\n{}\r\n0\r\n\r\n"), 400},
            {"no size", chunked("\r\n{}\r\n0\r\n\r\n"), 400},
            {"0x before the size", chunked("0x2\r\n{}\r\n0\r\n\r\n"), 400},
            {"a blank before the size", chunked(" 2\r\n{}\r\n0\r\n\r\n"), 400},
            {"a blank after the size", chunked("2 \r\n{}\r\n0\r\n\r\n"), 400},
            {"a size over 64 bits", chunked("10000000000000002\r\n{}\r\n0\r\n\r\n"), 400},
            {"a size of 64 bits", chunked("ffffffffffffffff\r\n{}\r\n0\r\n\r\n"), 400},
            {"a size of 63 bits", chunked("7ffffffffffffffe\r\n{}\r\n0\r\n\r\n"), 400},
            {"a chunk longer than its size", chunked("2\r\n{ }\r\n0\r\n\r\n"), 400},
            {"a chunk shorter than its size", chunked("3\r\n{}\r\n0\r\n\r\n"), 400},
            {"no line's end after a chunk", chunked("2\r\n{}0\r\n\r\n"), 400},
            {"an extension without a name", chunked("2;\r\n{}\r\n0\r\n\r\n"), 400},
            {"LF in an extension", chunked("2;a\nb\r\n{}\r\n0\r\n\r\n"), 400},
            {"CR in an extension", chunked("2;a\rb\r\n{}\r\n0\r\n\r\n"), 400},
            {"a line's end in quotes", chunked("2;a=\"\r\n{}\"\r\n0\r\n\r\n"), 400},
            {"an extension without end", chunked("2;" + std::string(70000, 'a')), 400}};
}

// RFC 9112, 7.1.2: as headers.
Table trailers() {
    const auto with = [](const std::string& lines) { return chunked("2\r\n{}\r\n0\r\n" + lines + "\r\n"); };
    std::string many;
    for (int i = 0; i < 101; ++i) many += "X-" + std::to_string(i) + ": 1\r\n";
    const std::string much = "X: " + std::string(40000, 'x') + "\r\n";
    return {{"a trailer without a colon", with("X\r\n"), 400},
            {"a trailer with a blank before the colon", with("X : 1\r\n"), 400},
            {"a length in a trailer", with("Content-Length: 2\r\n"), 400},
            {"a folded trailer", with("X: a\r\n b\r\n"), 400},
            {"a folded trailer, by a tab", with("X: a\r\n\tb\r\n"), 400},
            {"a folded first trailer", with(" X: a\r\n"), 400},
            {"a folded trailer after a size of more digits", chunked("2\r\n{}\r\n000;a\r\nX: a\r\n b\r\n\r\n"), 400},
            {"a folded trailer without a body", chunked("0\r\nX: a\r\n b\r\n\r\n"), 400},
            {"a name that is none in a trailer", with("X/Y: 1\r\n"), 400},
            {"a control character in a trailer", with("X: \x01\r\n"), 400},
            {"LF in a trailer", with("X: a\nY: b\r\n"), 400},
            {"too many trailers", with(many), 431},
            {"a long trailer", with(much), 431},
            {"trailers without end", chunked("0\r\n" + much + much), 431}};
}

}  // namespace

std::vector<Malformed> malformed_requests() {
    Table all;
    for (const Table& part :
         {request_lines(), versions(), addresses(), hosts(), headers(), lengths(), chunks(), trailers()}) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

}  // namespace waybreaker::http
