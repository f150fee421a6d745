#include "studio/plan_page.hpp"

#include <array>
#include <cstdint>

#include "studio/bundle.hpp"

namespace waybreaker::studio {
namespace {

// A text between tags.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

// JSON that no HTML parser takes for a tag or comment: in JSON, '<' stands in texts only.
std::string harmless(std::string_view json) {
    std::string result;
    for (const char c : json) {
        if (c == '<') {
            result += "\\u003c";
        } else {
            result += c;
        }
    }
    return result;
}

// RFC 4648, 4.
std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    constexpr std::size_t group = 3;
    std::string text;
    text.reserve((bytes.size() + 2) / group * 4);
    for (std::size_t at = 0; at < bytes.size(); at += group) {
        const std::string_view part = bytes.substr(at, group);
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < group; ++i) {
            bits = bits << 8U | (i < part.size() ? std::uint8_t(part[i]) : 0U);
        }
        std::array<char, 4> four{};
        for (std::size_t i = 0; i < four.size(); ++i) {
            four[i] = i <= part.size() ? letters[bits >> (18U - 6U * unsigned(i)) & 63U] : '=';
        }
        text.append(four.data(), four.size());
    }
    return text;
}

// A picture as wide as the window, without the styles of the page.
std::string noscript(const StillPlan& still) {
    return "<noscript>\n<div class=\"still\">\n<h1>" + escaped(still.title) + "</h1>\n<p>" + still.sentence + "</p>\n" +
           still.picture +
           "<p>Where JavaScript may run, this page plays the plan: open it in a browser.</p>\n</div>\n</noscript>\n";
}

std::string element(const char* type, const char* id, std::string_view text) {
    return std::string("<script type=\"") + type + "\" id=\"" + id + "\">" + std::string(text) + "</script>\n";
}

// The policy keeps the page from asking anyone for anything. The bundle is ours and holds no "</script" (tests/studio).
std::string page(const StillPlan& still, const std::string& may_run, const std::string& elements) {
    std::string page =
        "<!doctype html>\n"
        "<html lang=\"en\">\n"
        "<head>\n"
        "<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'" +
        may_run +
        "; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n"
        "<title>";
    page += escaped(still.title);
    page += "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n";
    page += studio_css();
    page += "</style>\n</head>\n<body>\n<div id=\"app\"></div>\n" + noscript(still) + elements +
            "<script type=\"module\">\n";
    page += studio_js();
    page += "</script>\n</body>\n</html>\n";
    return page;
}

}  // namespace

std::string plan_page(const StillPlan& still, std::string_view data) {
    return page(still, "", element("application/json", "waybreaker", harmless(data)));
}

std::string plan_page(const StillPlan& still, const CarriedPlanner& carried) {
    return page(still, " 'wasm-unsafe-eval' blob:; worker-src blob:",
                element("application/json", "waybreaker-map", harmless(carried.map)) +
                    element("application/json", "waybreaker-plan", harmless(carried.plan)) +
                    element("text/plain", "waybreaker-worker", worker_js()) +
                    element("text/plain", "waybreaker-planner", base64(carried.planner)));
}

}  // namespace waybreaker::studio
