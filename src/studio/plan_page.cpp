#include "studio/plan_page.hpp"

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

}  // namespace

// A picture as wide as the window, without the styles of the page.
std::string noscript(const StillPlan& still) {
    return "<noscript>\n<div class=\"still\">\n<h1>" + escaped(still.title) + "</h1>\n<p>" + still.sentence + "</p>\n" +
           still.picture +
           "<p>Where JavaScript may run, this page plays the plan: open it in a browser.</p>\n</div>\n</noscript>\n";
}

// The policy keeps the page from asking anyone for anything. The bundle is ours and holds no "</script" (tests/studio).
std::string plan_page(const StillPlan& still, std::string_view data) {
    std::string page =
        "<!doctype html>\n"
        "<html lang=\"en\">\n"
        "<head>\n"
        "<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
        "style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n"
        "<title>";
    page += escaped(still.title);
    page += "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n";
    page += studio_css();
    page += "</style>\n</head>\n<body>\n<div id=\"app\"></div>\n" + noscript(still) +
            "<script type=\"application/json\" id=\"waybreaker\">";
    page += harmless(data);
    page += "</script>\n<script type=\"module\">\n";
    page += studio_js();
    page += "</script>\n</body>\n</html>\n";
    return page;
}

}  // namespace waybreaker::studio
