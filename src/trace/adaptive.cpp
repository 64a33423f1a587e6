#include "trace/adaptive.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "trace/allocation.hpp"

namespace vkbake {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t pilot_rays = least_estimated_rays;
constexpr unsigned doublings_a_pass = 2;
/// So far below the target a pass aims, so that the last ones are few.
constexpr double aim = 0.985;
/// What a filter leaves is first asked for at so many times the error.
constexpr double first_noise = 4.0;

double seconds_until(Clock::time_point time) { return std::chrono::duration<double>(time - Clock::now()).count(); }

/// ratio^log₂(rays / pilot_rays): how the variance has fallen since the pilot.
double fallen(double ratio, std::uint32_t rays) {
    double result = 1.0;
    for (std::uint32_t reached = pilot_rays; reached < rays; reached *= 2) {
        result *= ratio;
    }
    return result;
}

class Adaptive {
public:
    Adaptive(SampledMap& map, const Samplers& samplers, const AdaptiveGoal& goal, const AdaptiveReport& report)
        : m_map(map), m_samplers(samplers), m_goal(goal), m_report(report) {
        for (const TexelTile& tile : map.tiles()) {
            m_texels += tile.count;
        }
        if (goal.error) {
            m_noise = goal.left ? first_noise * *goal.error : *goal.error;
        }
    }

    AdaptiveResult run() {
        take_pilot();
        while (true) {
            m_estimate = m_map.estimate();
            const std::vector<TileNeed> needs = smoothed_needs();
            std::vector<TileOrder> orders = m_stopped ? std::vector<TileOrder>() : next_orders(needs);
            if (orders.empty() && !m_stopped && leaves_too_much()) {
                orders = next_orders(needs);
            }
            if (orders.empty()) {
                finish(needs);
                return m_result;
            }
            extend(orders);
        }
    }

private:
    /// Whether a filter does, though the noise is what it may be: then that is lowered.
    bool leaves_too_much() {
        if (!m_goal.error || !m_goal.left || m_noise <= *m_goal.error || m_estimate.relative_rmse() > m_noise ||
            m_estimate.relative_rmse() <= 0.0) {
            return false;
        }
        const double left = m_goal.left();
        m_result.judged = true;
        m_left_share = left / m_estimate.relative_rmse();
        if (left <= *m_goal.error) {
            return false;
        }
        constexpr double least_step = 0.9;
        const double share = std::pow(aim * *m_goal.error / left, 1.0 / fall_of_left(left));
        m_noise = std::max(m_estimate.relative_rmse() * std::min(share, least_step), *m_goal.error);
        return true;
    }

    /// As which power of the noise that falls which is left of it: as from the last time to this.
    double fall_of_left(double left) {
        constexpr double at_first = 0.9; // in a garden and a city; on a head on a ground less
        const Judgement now{m_estimate.relative_rmse(), left};
        const std::optional<Judgement> last = std::exchange(m_judgement, now);
        if (!last) {
            return at_first;
        }
        return std::clamp(std::log(last->left / now.left) / std::log(last->noise / now.noise), 0.5, 1.2);
    }

    void take_pilot() {
        std::vector<TileOrder> orders;
        for (std::size_t tile = 0; tile < m_map.tiles().size(); ++tile) {
            orders.push_back({static_cast<std::uint32_t>(tile), pilot_rays});
        }
        m_foretold = m_texels * pilot_rays * 2.0;
        extend(orders);
    }

    void extend(const std::vector<TileOrder>& orders) {
        const auto start = Clock::now();
        double work = 0.0;
        for (const TileOrder& order : orders) {
            const double some = static_cast<double>(order.rays - m_map.rays(order.tile)) *
                                static_cast<double>(m_map.tiles()[order.tile].count);
            work += cost(order.tile) * some;
        }
        const double before = m_work;
        const bool first = before == 0.0; // the pilot is taken whole
        const std::size_t done = m_map.extend(orders, m_samplers, [&](std::size_t count) {
            const double share = orders.empty() ? 1.0 : static_cast<double>(count) / static_cast<double>(orders.size());
            tell((before + share * work) / m_foretold);
            return first || !m_goal.deadline || seconds_until(*m_goal.deadline) > 0.0;
        });
        const double share = orders.empty() ? 1.0 : static_cast<double>(done) / static_cast<double>(orders.size());
        m_work += share * work;
        m_work_a_second = share * work / std::chrono::duration<double>(Clock::now() - start).count();
        m_stopped = done < orders.size();
        m_result.judged = false;
    }

    /// Of a tile's next samples, if nothing contradicts what is known: those without a ray are to be made all the same.
    [[nodiscard]] double cost(std::size_t tile) const {
        constexpr double without_ray = 0.2;
        return without_ray + (1.0 - without_ray) * m_map.traced_share(tile);
    }

    void tell(double share) {
        m_share = std::clamp(share, m_share, 1.0);
        m_report(m_share, m_left_share * m_estimate.relative_rmse());
    }

    [[nodiscard]] std::vector<TileNeed> smoothed_needs() const {
        const std::size_t count = m_map.tiles().size();
        std::vector<double> at_pilot(count); // mean σ² of a texel, brought back to the pilot's rays
        double whole = 0.0;
        double measured = 0.0;
        for (std::size_t tile = 0; tile < count; ++tile) {
            const double sum = m_map.tile_variance(tile, m_estimate.ratio);
            measured += sum;
            at_pilot[tile] = sum / m_map.tiles()[tile].count / fallen(m_estimate.ratio, m_map.rays(tile));
            whole += at_pilot[tile] * m_map.tiles()[tile].count / m_texels;
        }
        // The map's own estimate goes by the coarse contrasts, which err less on the sum.
        const double scale = measured > 0.0 ? m_estimate.sampled.variance * m_texels / measured : 0.0;
        std::vector<TileNeed> needs(count);
        for (std::size_t tile = 0; tile < count; ++tile) {
            constexpr double of_neighbours = 0.28;
            constexpr double of_map = 0.02;
            const double beside =
                0.5 * (at_pilot[tile > 0 ? tile - 1 : tile] + at_pilot[std::min(tile + 1, count - 1)]);
            const double mean =
                (1.0 - of_neighbours - of_map) * at_pilot[tile] + of_neighbours * beside + of_map * whole;
            const std::uint32_t texels = m_map.tiles()[tile].count;
            needs[tile] = {texels, m_map.rays(tile), scale * mean * texels * fallen(m_estimate.ratio, m_map.rays(tile)),
                           cost(tile)};
        }
        return needs;
    }

    /// Empty where the goal is reached, or out of reach.
    [[nodiscard]] std::vector<TileOrder> next_orders(const std::vector<TileNeed>& needs) {
        if (m_goal.deadline) {
            return orders_in_time(needs);
        }
        const double target = m_noise * m_estimate.mean();
        Allocation allocation{.doublings = std::vector<std::uint8_t>(needs.size(), 0)};
        if (m_estimate.relative_rmse() > m_noise && m_estimate.sampled.variance > 0.0) {
            double sum = 0.0; // what the smoothed needs say of the map as it is
            for (const TileNeed& need : needs) {
                sum += need.variance;
            }
            // Where the light before leaves no room, what can be had is that this one hardly adds to its error.
            constexpr double least_share = 0.05;
            const double goal = std::max(aim * target * aim * target - m_estimate.before.variance,
                                         least_share * m_estimate.before.variance);
            allocation = allocate_for_variance(needs, m_estimate.ratio, goal / m_estimate.sampled.variance * sum);
        }
        // Before the end, so that what it takes from the error counts for the others.
        constexpr double near_the_end = 1.5;
        if (m_estimate.relative_rmse() < near_the_end * m_noise) {
            double_worst(needs, worst_factor * target, allocation);
        }
        hold_back(needs, allocation);
        return orders_of(allocation);
    }

    [[nodiscard]] std::vector<TileOrder> orders_in_time(const std::vector<TileNeed>& needs) {
        if (m_goal.error && m_estimate.relative_rmse() <= m_noise) {
            return {};
        }
        const double work = seconds_until(*m_goal.deadline) * m_work_a_second;
        // Less than this would not pay for its own deciding.
        constexpr double worthwhile = 0.01;
        if (work < worthwhile * m_work) {
            return {};
        }
        return orders_of(allocate_for_work(needs, m_estimate.ratio, work));
    }

    [[nodiscard]] std::vector<TileOrder> orders_of(const Allocation& allocation) {
        constexpr double may_not_do = 1.5; // until a filter was asked
        m_foretold = (m_work + allocation.work) * (m_goal.left && !m_judgement ? may_not_do : 1.0);
        std::vector<TileOrder> orders;
        for (std::size_t tile = 0; tile < allocation.doublings.size(); ++tile) {
            const unsigned doublings = std::min<unsigned>(allocation.doublings[tile], doublings_a_pass);
            if (doublings > 0) {
                orders.push_back({static_cast<std::uint32_t>(tile), m_map.rays(tile) << doublings});
            }
        }
        return orders;
    }

    /// Where one pass would bring most of what is foretold, only the half of its work that gains most is left in the
    /// order: how the variance falls from here on is known too roughly to be bound to all of it. No tile is traced in
    /// more steps for that.
    void hold_back(const std::vector<TileNeed>& needs, Allocation& allocation) const {
        constexpr double worth_a_pass = 0.04; // of the work so far
        std::vector<std::pair<double, std::size_t>> gains;
        double work = 0.0;
        for (std::size_t tile = 0; tile < needs.size(); ++tile) {
            if (allocation.doublings[tile] > 0) {
                gains.emplace_back(-gain_a_sample(needs[tile], m_estimate.ratio), tile);
                work += work_in_pass(needs[tile], allocation.doublings[tile]);
            }
        }
        if (work < worth_a_pass * m_work || work < 0.5 * allocation.work) {
            return;
        }
        std::sort(gains.begin(), gains.end());
        double ordered = 0.0;
        for (const auto& [gain, tile] : gains) {
            if (ordered >= 0.5 * work) {
                allocation.doublings[tile] = 0;
            } else {
                ordered += work_in_pass(needs[tile], allocation.doublings[tile]);
            }
        }
    }

    [[nodiscard]] static double work_in_pass(const TileNeed& need, unsigned doublings) {
        return need.cost * static_cast<double>(need.texels) * static_cast<double>(need.rays) *
               static_cast<double>((1U << std::min(doublings, doublings_a_pass)) - 1U);
    }

    /// Of the tiles whose texels err by more than `limit`, doubles the least bad, until the others are no more than the
    /// share allowed.
    void double_worst(const std::vector<TileNeed>& needs, double limit, Allocation& allocation) const {
        std::vector<std::pair<double, std::size_t>> worst;
        double texels = 0.0;
        for (std::size_t tile = 0; tile < needs.size(); ++tile) {
            const double square = needs[tile].variance / needs[tile].texels;
            if (square > limit * limit && needs[tile].rays < most_rays) {
                worst.emplace_back(square, tile);
                texels += needs[tile].texels;
            }
        }
        std::sort(worst.begin(), worst.end());
        for (const auto& [square, tile] : worst) {
            if (texels <= worst_share * m_texels) {
                break;
            }
            allocation.doublings[tile] = std::max<std::uint8_t>(allocation.doublings[tile], 1);
            texels -= needs[tile].texels;
        }
    }

    void finish(const std::vector<TileNeed>& needs) {
        std::vector<TileNeed> fresh = needs;
        double sum = 0.0;
        double at_pilot = 0.0;
        for (TileNeed& need : fresh) {
            sum += need.variance;
            need.variance /= fallen(m_estimate.ratio, need.rays);
            need.rays = pilot_rays;
            need.cost = 1.0;
            at_pilot += need.variance;
        }
        m_result.samples = 0.0;
        for (std::size_t tile = 0; tile < needs.size(); ++tile) {
            m_result.samples += static_cast<double>(m_map.rays(tile)) * needs[tile].texels;
        }
        m_result.best_samples = m_texels * pilot_rays + allocate_for_variance(fresh, m_estimate.ratio, sum).work;
        m_result.uniform = uniform_rays(at_pilot, sum);
    }

    /// So many rays a texel bring the variance from what the pilot left to `wanted`; 1 / σ² taken for straight between
    /// two powers of two.
    [[nodiscard]] std::uint64_t uniform_rays(double at_pilot, double wanted) const {
        std::uint64_t rays = pilot_rays;
        double variance = at_pilot;
        while (variance * m_estimate.ratio > wanted && wanted > 0.0) {
            variance *= m_estimate.ratio;
            rays *= 2;
        }
        const double share = wanted > 0.0 ? (variance / wanted - 1.0) / (1.0 / m_estimate.ratio - 1.0) : 0.0;
        return rays + static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(rays));
    }

    struct Judgement {
        double noise = 0.0; ///< relative
        double left = 0.0;
    };

    SampledMap& m_map;
    const Samplers& m_samplers;
    const AdaptiveGoal& m_goal;
    const AdaptiveReport& m_report;
    MapEstimate m_estimate;
    AdaptiveResult m_result;
    double m_noise = 0.0;                 ///< relative, that may be left; where an error is asked for
    double m_left_share = 1.0;            ///< of the noise, that a filter left of it when it was asked last
    std::optional<Judgement> m_judgement; ///< the last
    bool m_stopped = false;               ///< by the deadline
    double m_texels = 0.0;
    double m_work = 0.0;     ///< done: samples, each times its cost
    double m_foretold = 1.0; ///< work over all
    double m_work_a_second = 0.0;
    double m_share = 0.0;
};

} // namespace

AdaptiveResult sample_adaptively(SampledMap& map, const Samplers& samplers, const AdaptiveGoal& goal,
                                 const AdaptiveReport& report) {
    return Adaptive(map, samplers, goal, report).run();
}

} // namespace vkbake
