#include "atlas/chart_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vkbake {

namespace {

/// Rows of bits, from which runs are read.
class TexelRows {
public:
    TexelRows(int width, int height)
        : m_words((static_cast<std::size_t>(width) + 63) / 64), m_width(width), m_height(height),
          m_bits(m_words * static_cast<std::size_t>(height), 0) {}

    void set(int y, int begin, int end) {
        std::uint64_t* const row = &m_bits[static_cast<std::size_t>(y) * m_words];
        const auto from = static_cast<std::size_t>(begin);
        const auto last = static_cast<std::size_t>(end - 1);
        const std::uint64_t head = ~std::uint64_t{0} << (from % 64);
        const std::uint64_t tail = ~std::uint64_t{0} >> (63 - last % 64);
        if (from / 64 == last / 64) {
            row[from / 64] |= head & tail;
            return;
        }
        row[from / 64] |= head;
        std::fill(row + from / 64 + 1, row + last / 64, ~std::uint64_t{0});
        row[last / 64] |= tail;
    }

    [[nodiscard]] ChartShape shape() const {
        ChartShape shape{.width = m_width, .height = m_height};
        for (int y = 0; y < m_height; ++y) {
            shape.first.push_back(static_cast<std::uint32_t>(shape.runs.size()));
            const std::uint64_t* const row = &m_bits[static_cast<std::size_t>(y) * m_words];
            const auto has = [&](int x) { return (row[x / 64] >> (static_cast<unsigned>(x) % 64) & 1U) != 0; };
            for (int x = 0; x < m_width;) {
                if (!has(x)) {
                    ++x;
                    continue;
                }
                const int begin = x;
                while (x < m_width && has(x)) {
                    ++x;
                }
                shape.runs.push_back({begin, x});
            }
        }
        shape.first.push_back(static_cast<std::uint32_t>(shape.runs.size()));
        return shape;
    }

private:
    std::size_t m_words;
    int m_width;
    int m_height;
    std::vector<std::uint64_t> m_bits;
};

constexpr double reach = 1.0 / 128.0;

/// Marks what a triangle meets: in each row the texels from its least to its greatest x within the row.
void mark(const std::array<glm::dvec2, 3>& t, const TexelSize& size, TexelRows& rows) {
    const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
    const int y_begin = std::max(0, static_cast<int>(std::floor(low - reach)));
    const int y_end = std::min(size.height, static_cast<int>(std::floor(high + reach)) + 1);
    for (int y = y_begin; y < y_end; ++y) {
        const double upper = y - reach;
        const double lower = y + 1 + reach;
        double least = 1e300;
        double greatest = -1e300;
        const auto meet = [&](double x) {
            least = std::min(least, x);
            greatest = std::max(greatest, x);
        };
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec2& a = t[c];
            const glm::dvec2& b = t[(c + 1) % 3];
            if (a.y >= upper && a.y <= lower) {
                meet(a.x);
            }
            for (const double line : {upper, lower}) {
                if ((a.y < line) != (b.y < line)) {
                    meet(a.x + (b.x - a.x) * ((line - a.y) / (b.y - a.y)));
                }
            }
        }
        const int begin = std::max(0, static_cast<int>(std::floor(least - reach)));
        const int end = std::min(size.width, static_cast<int>(std::floor(greatest + reach)) + 1);
        if (begin < end) {
            rows.set(y, begin, end);
        }
    }
}

} // namespace

double ChartShape::texel_count() const {
    double count = 0.0;
    for (const Run& run : runs) {
        count += run.end - run.begin;
    }
    return count;
}

ChartShape shape_of(const Chart& chart, std::span<const glm::vec2> flat, const ChartLayout& layout) {
    if (layout.size.width == 1 || layout.size.height == 1) {
        return rectangle(layout.size);
    }
    TexelRows rows(layout.size.width, layout.size.height);
    for (const std::uint32_t triangle : chart.triangles) {
        std::array<glm::dvec2, 3> t{};
        for (std::size_t c = 0; c < 3; ++c) {
            t[c] = glm::dvec2(flat[3 * std::size_t{triangle} + c]) * layout.scale + layout.offset;
        }
        mark(t, layout.size, rows);
    }
    return rows.shape();
}

ChartShape turned(const ChartShape& shape) {
    TexelRows rows(shape.height, shape.width);
    for (int y = 0; y < shape.height; ++y) {
        for (const ChartShape::Run& run : shape.row(y)) {
            for (int x = run.begin; x < run.end; ++x) {
                rows.set(shape.width - 1 - x, y, y + 1);
            }
        }
    }
    return rows.shape();
}

ChartShape rectangle(const TexelSize& size) {
    ChartShape shape{.width = size.width, .height = size.height};
    for (int y = 0; y < size.height; ++y) {
        shape.first.push_back(static_cast<std::uint32_t>(y));
        shape.runs.push_back({0, size.width});
    }
    shape.first.push_back(static_cast<std::uint32_t>(size.height));
    return shape;
}

} // namespace vkbake
