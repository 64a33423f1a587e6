#include "bench/rays/embree_contender.hpp"

#include <utility>

namespace vkbake::bench {
namespace {

// As Embree's manual asks of every thread that traces. The threads of a pass end with it.
void flush_denormals() {
#if defined(__SSE__)
    __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040U); // FTZ and DAZ
#endif
}

RTCIntersectContext make_context(bool coherent) {
    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

template<typename Layout>
class EmbreeContender final : public Contender {
public:
    EmbreeContender(const EmbreeScene& scene, const EmbreeCall& call, const RaySet& rays, Pass for_pass)
        : m_scene(&scene), m_call(call), m_rays(&rays), m_answers(rays.blocks.size()) {
        if (for_pass == Pass::ask) {
            m_made = std::vector<Layout>(rays.blocks.size());
            for (std::size_t block = 0; block < m_made.size(); ++block) {
                m_made[block].load(rays.blocks[block]);
            }
        }
    }

    [[nodiscard]] std::string description() const override {
        return m_scene->quality().name() + ", " + name_of(m_call);
    }
    [[nodiscard]] const RaySet& rays() const override { return *m_rays; }

    void prepare() override {
        for (Layout& block : m_made) {
            block.reset();
        }
    }

    [[nodiscard]] Work ask() override {
        flush_denormals();
        return [this, context = make_context(m_call.coherent)](std::size_t tile) mutable {
            const std::size_t first = tile * m_rays->blocks_a_tile;
            for (std::size_t block = first; block < first + m_rays->blocks_a_tile; ++block) {
                m_made[block].ask(m_scene->get(), context, m_call);
            }
        };
    }

    [[nodiscard]] Work make_and_ask() override {
        flush_denormals();
        return [this, context = make_context(m_call.coherent),
                own = std::make_shared<Own>(*m_rays->source)](std::size_t tile) mutable {
            own->maker.begin(m_rays->tiles[tile]);
            for (std::size_t b = 0; b < m_rays->blocks_a_tile; ++b) {
                own->layout.load(own->maker.make(b));
                own->layout.ask(m_scene->get(), context, m_call);
                m_answers[tile * m_rays->blocks_a_tile + b] = own->layout.blocked();
            }
        };
    }

    [[nodiscard]] std::vector<BlockedRays> answers() override {
        for (std::size_t block = 0; block < m_made.size(); ++block) {
            m_answers[block] = m_made[block].blocked();
        }
        return m_answers;
    }

private:
    /// What a thread needs to make rays on the way.
    struct Own {
        explicit Own(const RaySource& source) : maker(source) {}
        RayMaker maker;
        Layout layout;
    };

    const EmbreeScene* m_scene; ///< never null
    EmbreeCall m_call;
    const RaySet* m_rays; ///< never null
    std::vector<Layout> m_made;
    std::vector<BlockedRays> m_answers;
};

} // namespace

std::vector<EmbreeCall> all_calls() {
    std::vector<EmbreeCall> calls;
    for (const bool coherent : {false, true}) {
        for (const CallKind kind : {CallKind::single, CallKind::packets_8, CallKind::packets_16}) {
            calls.push_back({kind, 1, coherent});
        }
        for (const CallKind kind :
             {CallKind::stream_of_records, CallKind::stream_of_packets, CallKind::stream_of_rows}) {
            for (const unsigned rays : {64U, 128U, 256U}) {
                calls.push_back({kind, rays, coherent});
            }
        }
    }
    return calls;
}

std::string name_of(const EmbreeCall& call) {
    const auto kind = [&]() -> std::string {
        switch (call.kind) {
        case CallKind::single:
            return "rtcOccluded1";
        case CallKind::packets_8:
            return "rtcOccluded8";
        case CallKind::packets_16:
            return "rtcOccluded16";
        case CallKind::stream_of_records:
            return "rtcOccluded1M of " + std::to_string(call.rays);
        case CallKind::stream_of_packets:
            return "rtcOccludedNM of " + std::to_string(call.rays) + " in 16s";
        case CallKind::stream_of_rows:
            break;
        }
        return "rtcOccludedNp of " + std::to_string(call.rays);
    };
    return kind() + (call.coherent ? ", coherent" : ", incoherent");
}

std::unique_ptr<Contender> make_embree_contender(const EmbreeScene& scene, const EmbreeCall& call, const RaySet& rays,
                                                 Pass for_pass) {
    switch (call.kind) {
    case CallKind::single:
    case CallKind::stream_of_records:
        return std::make_unique<EmbreeContender<RayRecords>>(scene, call, rays, for_pass);
    case CallKind::packets_8:
        return std::make_unique<EmbreeContender<RayPackets<RTCRay8, 8>>>(scene, call, rays, for_pass);
    case CallKind::packets_16:
    case CallKind::stream_of_packets:
        return std::make_unique<EmbreeContender<RayPackets<RTCRay16, 16>>>(scene, call, rays, for_pass);
    case CallKind::stream_of_rows:
        break;
    }
    return std::make_unique<EmbreeContender<RayRows>>(scene, call, rays, for_pass);
}

} // namespace vkbake::bench
