// Embree's handles, and one geometry of triangles in a scene.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/vec3.hpp>

#include "vkbake/surface.hpp"

namespace vkbake::bench {

/// The triangles as Embree reads them, shared by all its scenes: what a host holds anyhow is not Embree's memory.
class EmbreeTriangles {
public:
    explicit EmbreeTriangles(const Surface& surface);
    [[nodiscard]] const std::vector<glm::vec3>& corners() const { return m_corners; } ///< and one more, see the .cpp
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return m_indices; }

private:
    std::vector<glm::vec3> m_corners;
    std::vector<std::uint32_t> m_indices;
};

/// A device that counts the bytes Embree holds. Only one may live at a time: Embree takes its number of threads from
/// the one that asks for the most.
class EmbreeDevice {
public:
    explicit EmbreeDevice(int threads);

    [[nodiscard]] RTCDevice get() const { return m_device.get(); }
    [[nodiscard]] std::int64_t bytes() const { return m_memory->now; }
    [[nodiscard]] std::int64_t peak_bytes() const { return m_memory->peak; }

private:
    struct Memory {
        std::atomic<std::int64_t> now{0};
        std::atomic<std::int64_t> peak{0};
    };
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    };
    static bool count(void* memory, ssize_t bytes, bool after);

    std::unique_ptr<Memory> m_memory; ///< before the device, which uses it to the end
    std::unique_ptr<RTCDeviceTy, Release> m_device;
};

struct EmbreeQuality {
    bool robust = true;
    RTCBuildQuality build = RTC_BUILD_QUALITY_HIGH;

    [[nodiscard]] std::string name() const;
};

class EmbreeScene {
public:
    /// `triangles` must outlive it. The build runs on the device's threads.
    EmbreeScene(const EmbreeDevice& device, const EmbreeTriangles& triangles, const EmbreeQuality& quality);

    [[nodiscard]] RTCScene get() const { return m_scene.get(); }
    [[nodiscard]] const EmbreeQuality& quality() const { return m_quality; }
    [[nodiscard]] double build_seconds() const { return m_seconds; } ///< committing geometry and scene

private:
    struct Release {
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };
    std::unique_ptr<RTCSceneTy, Release> m_scene;
    EmbreeQuality m_quality;
    double m_seconds = 0.0;
};

} // namespace vkbake::bench
