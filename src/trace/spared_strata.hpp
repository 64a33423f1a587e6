// Which of a tile's next strata are traced.
#pragma once

#include <cstdint>

#include "base/random.hpp"
#include "trace/cell_visibility.hpp"
#include "trace/cosine_strata.hpp"

namespace vkbake {

/// Parts the strata of a plan, for one tile, into those in known cells and others. Of the known ones one in sixteen,
/// which chance chooses, is *checked*: traced before the others, to see whether it meets what it should.
///
/// Each function calls use(strata) with as many at a time as a block of rays has, in their order.
class SparedStrata {
public:
    /// `strata` must outlive it. `seen`: what the tile's rays have met, of strata.first() samples of each of its
    /// `texels`. `random`: the tile's own.
    SparedStrata(const CosineStrata& strata, const CellVisibility& seen, std::uint32_t texels, std::uint64_t random)
        : m_strata(&strata), m_known(seen, strata.first(), texels), m_random(random) {}

    [[nodiscard]] const KnownCells& known() const { return m_known; }

    /// Known as `answer`, and checked.
    template<class Use>
    void each_checked(KnownCells::Answer answer, const Use& use) const {
        each([&](std::uint64_t stratum) { return is_checked(stratum) && is(answer, stratum); }, use);
    }
    /// Known as `answer`, and not checked.
    template<class Use>
    void each_spared(KnownCells::Answer answer, const Use& use) const {
        each([&](std::uint64_t stratum) { return !is_checked(stratum) && is(answer, stratum); }, use);
    }
    /// Not known.
    template<class Use>
    void each_unknown(const Use& use) const {
        each([&](std::uint64_t stratum) { return is(KnownCells::Answer::none, stratum); }, use);
    }
    /// All that are not both known and checked.
    template<class Use>
    void each_unchecked(const Use& use) const {
        each([&](std::uint64_t stratum) { return !is_checked(stratum) || is(KnownCells::Answer::none, stratum); }, use);
    }

private:
    template<class Takes, class Use>
    void each(const Takes& takes, const Use& use) const {
        BlockStrata some;
        for (std::uint64_t stratum = m_strata->first_stratum(); stratum < m_strata->count(); ++stratum) {
            if (takes(stratum) && some.add(stratum)) {
                use(some);
                some.count = 0;
            }
        }
        if (some.count > 0) {
            some.fill();
            use(some);
        }
    }
    [[nodiscard]] bool is(KnownCells::Answer answer, std::uint64_t stratum) const {
        return m_known.at(m_strata->cell(stratum), m_strata->bits()) == answer;
    }
    [[nodiscard]] bool is_checked(std::uint64_t stratum) const {
        const std::uint64_t chosen = mix64(m_random ^ (stratum / KnownCells::checked_strata));
        return (chosen ^ stratum) % KnownCells::checked_strata == 0;
    }

    const CosineStrata* m_strata; ///< never null
    KnownCells m_known;
    std::uint64_t m_random;
};

} // namespace vkbake
