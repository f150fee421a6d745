// A plan's page: whole, and closed against what its data may hold.
#include "studio/plan_page.hpp"

#include <gtest/gtest.h>

#include <string>

#include "studio/studio_files.hpp"

namespace waybreaker::studio {
namespace {

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(StudioFiles, AreThePageAndWhatItAsksFor) {
    ASSERT_EQ(files().size(), 3U);
    EXPECT_EQ(files()[0].path, "/");
    for (const File& file : files()) {
        EXPECT_GT(file.bytes.size(), 100U) << file.path;
        const bool asked = files()[0].bytes.find(file.path) != std::string_view::npos;
        EXPECT_TRUE(asked || file.path == "/") << file.path;
    }
}

TEST(PlanPage, NothingInItsDataOrTitleEndsWhatItStandsIn) {
    const std::string page = plan_page({.title = "A </title></noscript><script>alert(1)</script> & B"},
                                       R"({"x": "</script><script>alert(1)</script><!--"})");
    EXPECT_EQ(count(page, "<script"), 2);
    EXPECT_EQ(count(page, "</script"), 2);
    EXPECT_EQ(count(page, "</title"), 1);
    EXPECT_EQ(count(page, "</style"), 1);
    EXPECT_EQ(count(page, "</noscript"), 1);
    EXPECT_NE(page.find(R"({"x": "\u003c/script>)"), std::string::npos);
    EXPECT_NE(page.find("A &lt;/title>"), std::string::npos);
}

TEST(PlanPage, AsksNobodyForAnything) {
    const std::string page = plan_page({.title = "title"}, "{}");
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
    EXPECT_EQ(page.find("src=\""), std::string::npos);
    EXPECT_EQ(count(page, "href=\""), 1);
    EXPECT_NE(page.find("href=\"data:,\""), std::string::npos);
}

TEST(PlanPage, CarriesWhatItPlansWith) {
    const CarriedPlanner carried{
        .map = R"({"title": "</script>"})", .plan = "{}", .planner = std::string("\0asm\xff", 5)};
    const std::string page = plan_page({.title = "title"}, carried);
    EXPECT_NE(page.find(R"(id="waybreaker-map">{"title": "\u003c/script>"}</script>)"), std::string::npos);
    EXPECT_NE(page.find(R"(id="waybreaker-plan">{}</script>)"), std::string::npos);
    EXPECT_NE(page.find(R"(id="waybreaker-planner">AGFzbf8=</script>)"), std::string::npos);
    EXPECT_EQ(count(page, "<script"), 5);
    EXPECT_EQ(count(page, "</script"), 5);
    EXPECT_EQ(page.find("id=\"waybreaker\""), std::string::npos) << "a page that plans is not the viewer";
    EXPECT_NE(page.find("default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:;"),
              std::string::npos);
    EXPECT_EQ(page.find("src=\""), std::string::npos);
}

}  // namespace
}  // namespace waybreaker::studio
