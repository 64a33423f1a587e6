#include "draw_svg.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include <librsvg/rsvg.h>

#include "vkbake/error.hpp"

namespace vkbake::cli {
namespace {

template<auto release>
struct Free {
    template<typename Object>
    void operator()(Object* object) const {
        release(object);
    }
};

/// What a call of librsvg reports.
class Report {
public:
    Report() = default;
    ~Report() { g_clear_error(&m_error); }
    Report(const Report&) = delete;
    Report& operator=(const Report&) = delete;
    Report(Report&&) = delete;
    Report& operator=(Report&&) = delete;

    [[nodiscard]] GError** place() { return &m_error; }

    [[noreturn]] void fail() const {
        throw Error(ErrorKind::output,
                    std::string("the plot cannot be drawn: ") + (m_error != nullptr ? m_error->message : "no memory"));
    }

private:
    GError* m_error = nullptr;
};

} // namespace

Image draw_svg(const std::string& svg, int width, int height) {
    Report report;
    const std::unique_ptr<RsvgHandle, Free<g_object_unref>> drawing(rsvg_handle_new_from_data(
        reinterpret_cast<const guint8*>(svg.data()), static_cast<gsize>(svg.size()), report.place()));
    const std::unique_ptr<cairo_surface_t, Free<cairo_surface_destroy>> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
    const std::unique_ptr<cairo_t, Free<cairo_destroy>> context(cairo_create(surface.get()));
    if (drawing == nullptr || cairo_status(context.get()) != CAIRO_STATUS_SUCCESS) {
        report.fail();
    }
    cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
    cairo_paint(context.get());
    const RsvgRectangle all{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)};
    if (rsvg_handle_render_document(drawing.get(), context.get(), &all, report.place()) == 0) {
        report.fail();
    }
    cairo_surface_flush(surface.get());
    const unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
    Image image{.width = width, .height = height, .texels = {}, .coverage = {}};
    image.texels.resize(image.index(0, height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint32_t texel = 0; // red, green and blue below the highest byte
            std::memcpy(&texel, bytes + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x), 4);
            const auto channel = [texel](unsigned shift) { return static_cast<float>(texel >> shift & 255U) / 255.0F; };
            image.texels[image.index(x, y)] = {channel(16), channel(8), channel(0), 1.0F};
        }
    }
    return image;
}

} // namespace vkbake::cli
