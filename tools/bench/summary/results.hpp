// Results that the bench of rays has written, read again.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vkbake::bench {

/// One contender in one kind of pass.
struct PassResult {
    double rays_per_second = 0.0;
    double ours_to_it = 0.0;
};

struct Result {
    std::string scene;
    std::string commit;
    std::string processor;
    std::string clock;
    int size = 0;
    std::size_t triangles = 0;
    double occluded_share = 0.0;
    std::size_t ours_wrong = 0;   ///< by double precision
    std::size_t differences = 0;  ///< between ours and Embree robust
    double build_to_robust = 0.0; ///< our seconds to Embree's, all threads
    double build_to_fast = 0.0;
    double bytes_a_triangle = 0.0;
    double peak_to_embree = 0.0;               ///< our peak to Embree's robust, while building
    std::map<std::string, double> thread_gain; ///< by contender, making included
    int few = 1;                               ///< numbers of threads: least and most
    int many = 1;
    /// By contender, whether making is included, and threads.
    std::map<std::string, std::map<bool, std::map<int, PassResult>>> passes;

    [[nodiscard]] double ratio(const std::string& who, bool making, int threads) const {
        return passes.at(who).at(making).at(threads).ours_to_it;
    }
};

/// Throws Error{bad_input} for a file that is no such result.
[[nodiscard]] Result read_result(const std::filesystem::path& file);

} // namespace vkbake::bench
