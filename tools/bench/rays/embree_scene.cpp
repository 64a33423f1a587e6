#include "bench/rays/embree_scene.hpp"

#include <chrono>
#include <numeric>

#include "vkbake/error.hpp"

namespace vkbake::bench {

EmbreeTriangles::EmbreeTriangles(const Surface& surface)
    : m_corners(surface.positions), m_indices(surface.positions.size()) {
    m_corners.emplace_back(0.0F); // Embree reads 16 bytes where the last corner has 12
    std::iota(m_indices.begin(), m_indices.end(), 0U);
}

EmbreeDevice::EmbreeDevice(int threads)
    : m_memory(std::make_unique<Memory>()), m_device(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())) {
    if (!m_device) {
        throw Error(ErrorKind::bake_failed, "embree: no device; check the installed library");
    }
    rtcSetDeviceMemoryMonitorFunction(m_device.get(), count, m_memory.get());
}

bool EmbreeDevice::count(void* memory, ssize_t bytes, bool /*after*/) {
    auto& total = *static_cast<Memory*>(memory);
    const std::int64_t now = total.now += bytes;
    std::int64_t peak = total.peak;
    while (now > peak && !total.peak.compare_exchange_weak(peak, now)) {
    }
    return true;
}

std::string EmbreeQuality::name() const {
    return std::string(robust ? "robust" : "fast") + (build == RTC_BUILD_QUALITY_HIGH ? ", high" : ", medium");
}

EmbreeScene::EmbreeScene(const EmbreeDevice& device, const EmbreeTriangles& triangles, const EmbreeQuality& quality)
    : m_scene(rtcNewScene(device.get())), m_quality(quality) {
    rtcSetSceneFlags(m_scene.get(), quality.robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(m_scene.get(), quality.build);
    RTCGeometryTy* const geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, quality.build);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, triangles.corners().data(), 0,
                               sizeof(glm::vec3), triangles.indices().size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.indices().data(), 0,
                               3 * sizeof(std::uint32_t), triangles.indices().size() / 3);
    const auto start = std::chrono::steady_clock::now();
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(m_scene.get(), geometry);
    rtcCommitScene(m_scene.get());
    m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rtcReleaseGeometry(geometry);
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) {
        throw Error(ErrorKind::bake_failed, "embree: the scene could not be built; check the memory at hand");
    }
}

} // namespace vkbake::bench
