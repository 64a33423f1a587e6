#include "finish/denoise_reference.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "denoise.h"

namespace vkbake {

namespace {

/// A sum of products in one order, which glm's own dot() does not promise.
float dot_of(const glm::vec3& a, const glm::vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

std::uint32_t chart_of(const glm::vec4& color) { return std::bit_cast<std::uint32_t>(color.a); }

float fitted_luminance(const glm::vec3& color) { return dot_of({DENOISE_RED, DENOISE_GREEN, DENOISE_BLUE}, color); }

/// Of a texel and what lies around it.
struct Guide {
    float variance = 0.0F; ///< mean over the texels around it
    float mean = 0.0F;     ///< of luminance
    float variance_of_mean = 0.0F;
};

struct Fit {
    glm::vec3 color{0.0F};
    float variance = 0.0F;  ///< of its noise; negative: the texel is left alone
    float risk = 0.0F;      ///< its squared error, were the texels that count given
    float full_risk = 0.0F; ///< with how the choice of these hangs on the texel itself
};

/// The plane of least squares through some texels, at offset (0, 0).
template<typename Value>
class Plane {
public:
    void add(float dx, float dy, const Value& value) {
        m_count += 1.0F;
        m_x += dx;
        m_y += dy;
        m_xx += dx * dx;
        m_xy += dx * dy;
        m_yy += dy * dy;
        m_sum += value;
        m_sum_x += value * dx;
        m_sum_y += value * dy;
    }
    [[nodiscard]] float count() const { return m_count; }
    /// By Cramer's rule; of whole numbers so far, so these are exact or rounded once.
    [[nodiscard]] Value value() const {
        return ((m_sum * of_sum() + m_sum_x * of_x()) + m_sum_y * of_y()) * plain_reciprocal(determinant());
    }
    /// That the texel at (0, 0) has in its own value.
    [[nodiscard]] float share() const { return of_sum() * plain_reciprocal(determinant()); }

private:
    [[nodiscard]] float of_sum() const { return m_xx * m_yy - m_xy * m_xy; }
    [[nodiscard]] float of_x() const { return m_xy * m_y - m_x * m_yy; }
    [[nodiscard]] float of_y() const { return m_x * m_xy - m_xx * m_y; }
    [[nodiscard]] float determinant() const { return (m_count * of_sum() + m_x * of_x()) + m_y * of_y(); }

    float m_count = 0.0F;
    float m_x = 0.0F;
    float m_y = 0.0F;
    float m_xx = DENOISE_RIDGE;
    float m_xy = 0.0F;
    float m_yy = DENOISE_RIDGE;
    Value m_sum{0.0F};
    Value m_sum_x{0.0F};
    Value m_sum_y{0.0F};
};

class Denoise {
public:
    explicit Denoise(const DenoiseFields& fields)
        : m_fields(fields), m_guides(fields.color.size()), m_fits(fields.color.size()) {}

    DenoisedTexels run() {
        each_texel([&](int x, int y, std::size_t texel) { m_guides[texel] = guide(x, y, texel); });
        each_texel([&](int x, int y, std::size_t texel) { m_fits[texel] = fit(x, y, texel); });
        DenoisedTexels result(m_fields.color.size());
        each_texel([&](int x, int y, std::size_t texel) {
            result[texel] = {m_fits[texel].color, m_fits[texel].variance, risk_around(x, y, texel)};
        });
        return result;
    }

private:
    template<typename Visit>
    void each_texel(const Visit& visit) const {
        for (int y = 0; y < m_fields.height; ++y) {
            for (int x = 0; x < m_fields.width; ++x) {
                if (const std::size_t texel = index(x, y); chart_of(m_fields.color[texel]) != 0) {
                    visit(x, y, texel);
                }
            }
        }
    }

    /// Calls visit(dx, dy, other) for those around a texel that share its piece of surface, row by row.
    template<typename Visit>
    void each_alike(int x, int y, std::size_t texel, int radius, const Visit& visit) const {
        for (int row = std::max(y - radius, 0); row <= std::min(y + radius, m_fields.height - 1); ++row) {
            for (int column = std::max(x - radius, 0); column <= std::min(x + radius, m_fields.width - 1); ++column) {
                if (const std::size_t other = index(column, row); alike(texel, other)) {
                    visit(static_cast<float>(column - x), static_cast<float>(row - y), other);
                }
            }
        }
    }

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_fields.width) + static_cast<std::size_t>(x);
    }

    [[nodiscard]] bool alike(std::size_t a, std::size_t b) const {
        const glm::vec3 normal_a(m_fields.facing[a]);
        const glm::vec3 normal_b(m_fields.facing[b]);
        const glm::vec3 step = glm::vec3(m_fields.place[b]) - glm::vec3(m_fields.place[a]);
        const float rise = dot_of(normal_a + normal_b, step);
        return chart_of(m_fields.color[a]) == chart_of(m_fields.color[b]) &&
               dot_of(normal_a, normal_b) >= DENOISE_LEAST_COSINE &&
               rise * rise <= 4.0F * DENOISE_MOST_SLOPE * dot_of(step, step) + DENOISE_TINY;
    }

    [[nodiscard]] Guide guide(int x, int y, std::size_t texel) const {
        constexpr std::array<float, 10> reciprocals = DENOISE_RECIPROCALS;
        Guide sum;
        std::size_t count = 0;
        each_alike(x, y, texel, DENOISE_GUIDE_RADIUS, [&](float, float, std::size_t other) {
            sum.variance += m_fields.place[other].w;
            sum.mean += m_fields.facing[other].w;
            ++count;
        });
        const float variance = sum.variance * reciprocals[count];
        return {variance, sum.mean * reciprocals[count], variance * reciprocals[count]};
    }

    /// Whether neither the texels nor the means around them differ by more than noise explains, were the first brighter
    /// by `more`.
    [[nodiscard]] bool indistinct(std::size_t a, std::size_t b, float more) const {
        const float apart = (m_fields.facing[b].w - m_fields.facing[a].w) - more;
        const float means_apart = (m_guides[b].mean - m_guides[a].mean) - more * DENOISE_GUIDE_SHARE;
        return apart * apart <= DENOISE_TEXEL_SIGMAS * (m_guides[a].variance + m_guides[b].variance) + DENOISE_TINY &&
               means_apart * means_apart <=
                   DENOISE_GUIDE_SIGMAS * (m_guides[a].variance_of_mean + m_guides[b].variance_of_mean) + DENOISE_TINY;
    }

    [[nodiscard]] Fit fit(int x, int y, std::size_t texel) const {
        const float own = m_fields.place[texel].w;
        const float around = m_guides[texel].variance;
        if (around < m_fields.good) {
            return {glm::vec3(m_fields.color[texel]), -1.0F, own, own};
        }
        Plane<glm::vec3> light;
        Plane<float> brighter;
        Plane<float> darker;
        float variance = 0.0F;
        const float more = around * plain_root_reciprocal(around);
        each_alike(x, y, texel, DENOISE_FIT_RADIUS, [&](float dx, float dy, std::size_t other) {
            const float luminance = m_fields.facing[other].w;
            const float change = other == texel ? more : 0.0F;
            if (indistinct(texel, other, 0.0F)) {
                light.add(dx, dy, glm::vec3(m_fields.color[other]));
                variance += m_fields.place[other].w;
            }
            if (indistinct(texel, other, more)) {
                brighter.add(dx, dy, luminance + change);
            }
            if (indistinct(texel, other, -more)) {
                darker.add(dx, dy, luminance - change);
            }
        });
        const glm::vec3 color = glm::max(light.value(), glm::vec3(0.0F));
        const float off = fitted_luminance(color) - m_fields.facing[texel].w;
        const float full_share = (brighter.value() - darker.value()) * (0.5F * plain_reciprocal(more));
        return {color, variance * plain_reciprocal(light.count()) * light.share(),
                off * off - own * (1.0F - 2.0F * light.share()), off * off - own * (1.0F - 2.0F * full_share)};
    }

    /// Mean over the fits around a texel; DENOISE_ALONE where these are worse than no fits.
    [[nodiscard]] float risk_around(int x, int y, std::size_t texel) const {
        if (m_fits[texel].variance < 0.0F) {
            return DENOISE_ALONE;
        }
        float risk = 0.0F;
        float full_risk = 0.0F;
        float without = 0.0F;
        float count = 0.0F;
        each_alike(x, y, texel, DENOISE_RISK_RADIUS, [&](float, float, std::size_t other) {
            risk += m_fits[other].risk;
            full_risk += m_fits[other].full_risk;
            without += m_fields.place[other].w;
            count += 1.0F;
        });
        return risk > without ? DENOISE_ALONE : full_risk * plain_reciprocal(count);
    }

    const DenoiseFields& m_fields;
    std::vector<Guide> m_guides;
    std::vector<Fit> m_fits;
};

} // namespace

float plain_reciprocal(float x) {
    float guess = std::bit_cast<float>(0x7EF311C3U - std::bit_cast<std::uint32_t>(x));
    for (int step = 0; step < 4; ++step) {
        guess = guess * (2.0F - x * guess);
    }
    return guess;
}

float plain_root_reciprocal(float x) {
    float guess = std::bit_cast<float>(0x5F375A86U - (std::bit_cast<std::uint32_t>(x) >> 1U));
    const float half = 0.5F * x;
    for (int step = 0; step < 4; ++step) {
        guess = guess * (1.5F - (half * guess) * guess);
    }
    return guess;
}

DenoisedTexels denoise_reference(const DenoiseFields& fields) { return Denoise(fields).run(); }

} // namespace vkbake
