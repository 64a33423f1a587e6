// A block's rays in each form that Embree takes them. Every form has
//   load(block)                  copies the rays that are active;
//   reset()                      makes asked rays ready to be asked again;
//   ask(scene, context, call)    asks them;
//   blocked()                    the answers, as BlockedRays.
// Embree changes nothing of a ray that it is asked for occlusion but its tfar.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include <embree3/rtcore.h>

#include "bvh/ray_block.hpp"

namespace vkbake::bench {

enum class CallKind { single, packets_8, packets_16, stream_of_records, stream_of_packets, stream_of_rows };

/// One way to call Embree. `rays`: how many go into one call of a stream.
struct EmbreeCall {
    CallKind kind = CallKind::single;
    unsigned rays = 1;
    bool coherent = false;
};

/// Calls `visit(stratum, lane)` for the active rays, stratum after stratum.
template<typename Visit>
inline void for_each_active(const std::array<RayBlock::LaneBits, RayBlock::strata>& active, const Visit& visit) {
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        for (unsigned left = active[stratum]; left != 0; left &= left - 1) {
            visit(stratum, static_cast<std::size_t>(std::countr_zero(left)));
        }
    }
}

/// rtcOccluded1 and rtcOccluded1M: a record a ray, without gaps.
class RayRecords {
public:
    RayRecords() {
        for (RTCRay& ray : m_rays) {
            ray.mask = ~0U;
        }
    }

    void load(const RayBlock& block) {
        m_active = block.active;
        m_max_distance = block.max_distance;
        m_count = 0;
        std::array<Quad, RayBlock::lanes> origins{};
        std::array<Quad, RayBlock::lanes> directions{};
        for (std::size_t lane = 0; lane < RayBlock::lanes; lane += 4) {
            transpose(&block.origin[0][lane], &block.origin[1][lane], &block.origin[2][lane], &origins[lane]);
        }
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            const auto& [x, y, z] = block.direction[stratum];
            for (std::size_t lane = 0; lane < RayBlock::lanes; lane += 4) {
                transpose(&x[lane], &y[lane], &z[lane], &directions[lane]);
            }
            for (unsigned left = m_active[stratum]; left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                auto* const record = reinterpret_cast<std::byte*>(&m_rays[m_count]);
                std::memcpy(record, &origins[lane], sizeof(Quad)); // and tnear = 0
                std::memcpy(record + sizeof(Quad), &directions[lane], sizeof(Quad));
                m_rays[m_count++].tfar = m_max_distance;
            }
        }
    }
    void reset() {
        for (RTCRay& ray : m_rays) {
            ray.tfar = m_max_distance;
        }
    }
    void ask(RTCScene scene, RTCIntersectContext& context, const EmbreeCall& call) {
        if (call.kind == CallKind::single) {
            for (unsigned i = 0; i < m_count; ++i) {
                rtcOccluded1(scene, &context, &m_rays[i]);
            }
            return;
        }
        for (unsigned begin = 0; begin < m_count; begin += call.rays) {
            rtcOccluded1M(scene, &context, &m_rays[begin], std::min(call.rays, m_count - begin), sizeof(RTCRay));
        }
    }
    [[nodiscard]] BlockedRays blocked() const {
        BlockedRays blocked{};
        const RTCRay* ray = m_rays.data();
        for_each_active(m_active, [&](std::size_t stratum, std::size_t lane) {
            const unsigned bit = ray++->tfar < 0.0F ? 1U << lane : 0U;
            blocked[stratum] = static_cast<RayBlock::LaneBits>(blocked[stratum] | bit);
        });
        return blocked;
    }

private:
    using Quad = float __attribute__((vector_size(16)));

    /// Four values of each row to four records (x, y, z, 0).
    static void transpose(const float* x_row, const float* y_row, const float* z_row, Quad* records) {
        Quad x;
        Quad y;
        Quad z;
        const Quad zero{};
        std::memcpy(&x, x_row, sizeof(Quad));
        std::memcpy(&y, y_row, sizeof(Quad));
        std::memcpy(&z, z_row, sizeof(Quad));
        const Quad low_xy = __builtin_shufflevector(x, y, 0, 4, 1, 5);
        const Quad high_xy = __builtin_shufflevector(x, y, 2, 6, 3, 7);
        const Quad low_z = __builtin_shufflevector(z, zero, 0, 4, 1, 5);
        const Quad high_z = __builtin_shufflevector(z, zero, 2, 6, 3, 7);
        records[0] = __builtin_shufflevector(low_xy, low_z, 0, 1, 4, 5);
        records[1] = __builtin_shufflevector(low_xy, low_z, 2, 3, 6, 7);
        records[2] = __builtin_shufflevector(high_xy, high_z, 0, 1, 4, 5);
        records[3] = __builtin_shufflevector(high_xy, high_z, 2, 3, 6, 7);
    }

    std::array<RTCRay, RayBlock::rays> m_rays{};
    std::array<RayBlock::LaneBits, RayBlock::strata> m_active{};
    unsigned m_count = 0;
    float m_max_distance = 0.0F;
};

/// rtcOccluded8, rtcOccluded16 and rtcOccludedNM: `Width` lanes of a stratum a packet.
template<typename Packet, std::size_t Width>
class RayPackets {
public:
    RayPackets() {
        for (Packet& packet : m_packets) {
            std::fill_n(packet.mask, Width, ~0U);
        }
    }

    void load(const RayBlock& block) {
        m_active = block.active;
        m_max_distance = block.max_distance;
        for (std::size_t p = 0; p < packet_count; ++p) {
            Packet& packet = m_packets[p];
            const std::size_t first = p % parts * Width;
            const auto& [x, y, z] = block.direction[p / parts];
            std::copy_n(&block.origin[0][first], Width, packet.org_x);
            std::copy_n(&block.origin[1][first], Width, packet.org_y);
            std::copy_n(&block.origin[2][first], Width, packet.org_z);
            std::copy_n(&x[first], Width, packet.dir_x);
            std::copy_n(&y[first], Width, packet.dir_y);
            std::copy_n(&z[first], Width, packet.dir_z);
            for (std::size_t i = 0; i < Width; ++i) {
                const bool active = (m_active[p / parts] >> (first + i) & 1U) != 0;
                m_valid[p][i] = active ? -1 : 0;
                packet.tnear[i] = active ? 0.0F : std::numeric_limits<float>::infinity();
            }
        }
        reset();
    }
    void reset() {
        for (std::size_t p = 0; p < packet_count; ++p) {
            for (std::size_t i = 0; i < Width; ++i) { // an interval turned over: a stream has no mask of its own
                m_packets[p].tfar[i] = m_valid[p][i] != 0 ? m_max_distance : -std::numeric_limits<float>::infinity();
            }
        }
    }
    void ask(RTCScene scene, RTCIntersectContext& context, const EmbreeCall& call) {
        if (call.kind == CallKind::stream_of_packets) {
            const unsigned step = call.rays / static_cast<unsigned>(Width);
            for (unsigned begin = 0; begin < packet_count; begin += step) {
                rtcOccludedNM(scene, &context, reinterpret_cast<RTCRayN*>(&m_packets[begin]), Width, step,
                              sizeof(Packet));
            }
            return;
        }
        for (std::size_t p = 0; p < packet_count; ++p) {
            if ((m_active[p / parts] >> (p % parts * Width) & ((1U << Width) - 1U)) == 0) {
                continue;
            }
            if constexpr (Width == 16) {
                rtcOccluded16(m_valid[p].data(), scene, &context, &m_packets[p]);
            } else {
                rtcOccluded8(m_valid[p].data(), scene, &context, &m_packets[p]);
            }
        }
    }
    [[nodiscard]] BlockedRays blocked() const {
        BlockedRays blocked{};
        for (std::size_t p = 0; p < packet_count; ++p) {
            unsigned bits = 0;
            for (std::size_t i = 0; i < Width; ++i) {
                bits |= (m_packets[p].tfar[i] < 0.0F ? 1U : 0U) << (p % parts * Width + i);
            }
            RayBlock::LaneBits& stratum = blocked[p / parts];
            stratum = static_cast<RayBlock::LaneBits>(stratum | (bits & m_active[p / parts]));
        }
        return blocked;
    }

private:
    static constexpr std::size_t parts = RayBlock::lanes / Width; // packets a stratum
    static constexpr std::size_t packet_count = RayBlock::strata * parts;

    std::array<Packet, packet_count> m_packets{};
    alignas(64) std::array<std::array<int, Width>, packet_count> m_valid{};
    std::array<RayBlock::LaneBits, RayBlock::strata> m_active{};
    float m_max_distance = 0.0F;
};

/// rtcOccludedNp: a row for each component, without gaps. The rows that a ray may do without are left out.
class RayRows {
public:
    void load(const RayBlock& block) {
        m_active = block.active;
        m_max_distance = block.max_distance;
        m_count = 0;
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            if (m_active[stratum] == 0xFFFFU) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    std::copy_n(block.origin[axis].data(), RayBlock::lanes, &m_rows[axis][m_count]);
                    std::copy_n(block.direction[stratum][axis].data(), RayBlock::lanes, &m_rows[3 + axis][m_count]);
                }
                m_count += RayBlock::lanes;
                continue;
            }
            for (unsigned left = m_active[stratum]; left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    m_rows[axis][m_count] = block.origin[axis][lane];
                    m_rows[3 + axis][m_count] = block.direction[stratum][axis][lane];
                }
                ++m_count;
            }
        }
        reset();
    }
    void reset() { m_tfar.fill(m_max_distance); }
    void ask(RTCScene scene, RTCIntersectContext& context, const EmbreeCall& call) {
        for (unsigned begin = 0; begin < m_count; begin += call.rays) {
            const RTCRayNp rays{.org_x = &m_rows[0][begin],
                                .org_y = &m_rows[1][begin],
                                .org_z = &m_rows[2][begin],
                                .tnear = m_tnear.data(),
                                .dir_x = &m_rows[3][begin],
                                .dir_y = &m_rows[4][begin],
                                .dir_z = &m_rows[5][begin],
                                .time = nullptr,
                                .tfar = &m_tfar[begin],
                                .mask = nullptr,
                                .id = nullptr,
                                .flags = nullptr};
            rtcOccludedNp(scene, &context, &rays, std::min(call.rays, m_count - begin));
        }
    }
    [[nodiscard]] BlockedRays blocked() const {
        BlockedRays blocked{};
        const float* tfar = m_tfar.data();
        for_each_active(m_active, [&](std::size_t stratum, std::size_t lane) {
            const unsigned bit = *tfar++ < 0.0F ? 1U << lane : 0U;
            blocked[stratum] = static_cast<RayBlock::LaneBits>(blocked[stratum] | bit);
        });
        return blocked;
    }

private:
    alignas(64) std::array<std::array<float, RayBlock::rays>, 6> m_rows{};
    alignas(64) std::array<float, RayBlock::rays> m_tfar{};
    alignas(64) std::array<float, RayBlock::rays> m_tnear{};
    std::array<RayBlock::LaneBits, RayBlock::strata> m_active{};
    unsigned m_count = 0;
    float m_max_distance = 0.0F;
};

} // namespace vkbake::bench
