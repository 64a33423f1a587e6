// The brightest places of a sky's picture, ready to be sampled.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "trace/sky_lookup.hpp"

namespace vkbake {

/// The peaks (PeakCut) that were taken out of a picture, as tables for trace/peak_directions.hpp. A row of the picture
/// is chosen first, then a peak in it, then a point of the peak's tent.
///
/// Choices are made by a number of 24 binary digits, each option's share being whole steps of 2⁻²⁴, one at least: so
/// that its probability is exact, and nothing is lost beside a sun.
class SkyPeaks {
public:
    /// Cuts off `sky`'s picture at the threshold; there is something above it.
    SkyPeaks(SkyLookup& sky, double threshold);

    [[nodiscard]] std::size_t count() const { return m_peaks.size(); }
    [[nodiscard]] double probability(std::size_t peak) const { return m_probabilities[peak]; }

    /// An option of a choice, and the part of a texel's tent, along one axis, that lies in its picture. Numbers that
    /// choose lie in (−1, 1).
    struct Option {
        float begin = 0.0F;
        float end = 0.0F;       ///< > begin: the next one's begin; of the last one 1
        float tent_low = 0.0F;  ///< of the tent's distribution
        float tent_mass = 1.0F; ///< of it between the borders
    };
    /// A guide table (Chen and Asau 1974). It cuts (−1, 1) into a power of two of equal parts, about one an option: the
    /// part's entry is the first option that a number of it may choose, the next entry the last one.
    struct Guides {
        std::int32_t first = 0; ///< entry
        std::int32_t shift = 0; ///< x = n / 2²⁴ − 1 lies in part n >> shift
    };
    /// Where its texels' centres are: cosine and sine of the polar angle; of a cube the coordinate down, and 0.
    struct Row {
        Option option;
        float cosine = 0.0F;
        float sine = 0.0F;
        std::int32_t image = 0;
        std::int32_t first = 0; ///< in peaks()
        Guides guides;          ///< in peak_guides()
    };
    /// Where the texel's centre is: cosine and sine of the azimuth; of a cube the coordinate across, and 0.
    struct Peak {
        Option option;
        float cosine = 0.0F;
        float sine = 0.0F;
        std::array<float, 3> light{}; ///< what a sample brings to E/π, by the solid angle of a texel and cos θ
    };
    [[nodiscard]] const std::vector<Row>& rows() const { return m_rows; }
    [[nodiscard]] const std::vector<Peak>& peaks() const { return m_peaks; }

    [[nodiscard]] const Guides& guides_of_rows() const { return m_guides_of_rows; }
    [[nodiscard]] const std::vector<std::int32_t>& row_guides() const { return m_row_guides; }
    [[nodiscard]] const std::vector<std::int32_t>& peak_guides() const { return m_peak_guides; }

    /// A cube's direction is axis + across · a + down · b. In the scene.
    struct Face {
        glm::vec3 axis{0.0F};
        glm::vec3 across{0.0F};
        glm::vec3 down{0.0F};
    };
    [[nodiscard]] bool is_cube() const { return m_cube; }
    [[nodiscard]] const std::array<Face, 6>& faces() const { return m_faces; }
    /// Whether any tent reaches over a border.
    [[nodiscard]] bool clips() const { return m_clips; }
    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }

private:
    /// A texel's excess. Those of a ring around an image count too: the tent of a texel reaches over its border.
    struct Excess {
        int image = 0;
        int x = 0;
        int y = 0;
        glm::dvec3 light{0.0};
        double power = 0.0; ///< in proportion to what it sends
    };

    [[nodiscard]] std::vector<Excess> cut(BorderedImages& images, int image_count, double threshold) const;
    [[nodiscard]] double power(const Excess& excess) const;
    void add_rows(const std::vector<Excess>& excess);
    void add_peaks(const std::vector<Excess>& excess);
    void place_faces(const SkyTurn& turn);

    bool m_cube = false;
    bool m_clips = false;
    int m_width = 0;
    int m_height = 0;
    SkyTurn m_turn;
    std::array<Face, 6> m_faces{};
    std::vector<Row> m_rows;
    std::vector<Peak> m_peaks;
    Guides m_guides_of_rows;
    std::vector<std::int32_t> m_row_guides;
    std::vector<std::int32_t> m_peak_guides;
    std::vector<double> m_probabilities; ///< of peaks
};

} // namespace vkbake
