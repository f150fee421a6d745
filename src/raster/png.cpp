// PNG by librsvg from the SVG: one way of drawing, two formats (docs/adr/002-png-by-librsvg.md).
#include "raster/png.hpp"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <memory>
#include <stdexcept>

namespace waybreaker::raster {
namespace {

template <auto release>
struct Release {
    template <typename T>
    void operator()(T* object) const {
        release(object);
    }
};

using Document = std::unique_ptr<RsvgHandle, Release<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Release<cairo_destroy>>;
using Error = std::unique_ptr<GError, Release<g_error_free>>;

// The SVG is ours: what fails here is the machine (memory), not the input.
[[noreturn]] void fail(const Error& error) {
    throw std::runtime_error(std::string("cannot draw the picture: ") + (error ? error->message : "unknown reason"));
}

Document parse(const std::string& svg) {
    GError* error = nullptr;
    // "Unlimited": the outline of a large map may exceed libxml2's limits for untrusted input.
    const std::unique_ptr<GInputStream, Release<g_object_unref>> stream(
        g_memory_input_stream_new_from_data(svg.data(), gssize(svg.size()), nullptr));
    Document document(
        rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
    if (!document) fail(Error(error));
    return document;
}

cairo_status_t append(void* png, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(png)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string png_of(const std::string& svg, double scale) {
    const Document document = parse(svg);
    double width = 0;
    double height = 0;
    rsvg_handle_get_intrinsic_size_in_pixels(document.get(), &width, &height);
    width *= scale;
    height *= scale;

    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(width), int(height)));
    const Context context(cairo_create(surface.get()));
    const RsvgRectangle viewport = {0, 0, width, height};
    GError* error = nullptr;
    if (!rsvg_handle_render_document(document.get(), context.get(), &viewport, &error)) fail(Error(error));

    std::string bytes;
    if (cairo_surface_write_to_png_stream(surface.get(), append, &bytes) != CAIRO_STATUS_SUCCESS) fail(nullptr);
    return bytes;
}

}  // namespace waybreaker::raster
