// PNG: read back with libpng.
#include "raster/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "render/layout.hpp"
#include "render/picture.hpp"
#include "render/worlds.hpp"

namespace waybreaker::raster {
namespace {

// The picture of a plan.
std::string png(const render::World& world, const render::PictureOptions& options) {
    return png_of(render::svg(world.map, world.mission, world.plan, options));
}

class Image {
  public:
    explicit Image(const std::string& bytes) {
        header_.version = PNG_IMAGE_VERSION;
        EXPECT_TRUE(png_image_begin_read_from_memory(&header_, bytes.data(), bytes.size())) << header_.message;
        header_.format = PNG_FORMAT_RGB;
        pixels_.resize(PNG_IMAGE_SIZE(header_));
        EXPECT_TRUE(png_image_finish_read(&header_, nullptr, pixels_.data(), 0, nullptr)) << header_.message;
    }

    int width() const { return int(header_.width); }
    int height() const { return int(header_.height); }

    // 0xRRGGBB
    unsigned at(render::Point p) const {
        const std::size_t i = 3 * (std::size_t(p.y) * header_.width + std::size_t(p.x));
        return unsigned(pixels_.at(i)) << 16 | unsigned(pixels_.at(i + 1)) << 8 | pixels_.at(i + 2);
    }

  private:
    png_image header_{};
    std::vector<png_byte> pixels_;
};

constexpr unsigned paper = 0xfaf8f4, street = 0xfffefb, obstacle = 0xdcd4c8, vermilion = 0xd55e00, tint = 0xffe2cc,
                   blue = 0x0072b2, ink = 0x26231f;

bool is_near(unsigned a, unsigned b, int tolerance = 2) {
    for (const int shift : {0, 8, 16}) {
        if (std::abs(int(a >> shift & 0xff) - int(b >> shift & 0xff)) > tolerance) return false;
    }
    return true;
}

TEST(Png, ShowsThePlan) {
    const render::World world = render::wall();
    for (const int width : {600, 1200, 2000}) {
        const render::PictureOptions options = {.width = width, .annotations = {.title = "The wall"}};
        const std::string bytes = png(world, options);
        ASSERT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
        const Image image(bytes);
        const render::Layout layout = lay_out(world.map, options, 6);
        EXPECT_EQ(image.width(), width);
        EXPECT_EQ(image.height(), int(layout.height));

        EXPECT_TRUE(is_near(image.at({1, 1}), paper));
        EXPECT_TRUE(is_near(image.at(layout.at({6, 0})), street));
        EXPECT_TRUE(is_near(image.at(layout.at({1, 4})), obstacle)) << "the other obstacle stays";
        EXPECT_TRUE(is_near(image.at(layout.at(5.5, 2)), blue)) << "the ground path after";
        EXPECT_TRUE(is_near(image.at(layout.at({7, 2})), ink)) << "the goal";

        int hatched = 0, tinted = 0, samples = 0;  // over the removed wall, clear of its edges and of the paths
        for (double y = 4; y <= 5; y += 0.01) {
            const unsigned pixel = image.at(layout.at(4, y));
            hatched += is_near(pixel, vermilion, 60);
            tinted += is_near(pixel, tint, 40);
            ++samples;
        }
        EXPECT_GT(hatched, samples / 8) << width;
        EXPECT_GT(tinted, samples / 4) << width;
    }
}

TEST(Png, SameInputSameBytes) {
    const render::World world = render::wall();
    EXPECT_EQ(png(world, {}), png(world, {}));
}

TEST(Png, DrawsTheStrangestMaps) {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 700}, {700, 1}, {16384, 2}}) {
        const render::World world = render::unsolved(Map(Grid(width, height)), {0, 0}, {0, 0});
        const Image image(png(world, {.width = 400, .annotations = {.title = "\xFF<\x02"}}));
        EXPECT_EQ(image.width(), 400);
    }
}

}  // namespace
}  // namespace waybreaker::raster
