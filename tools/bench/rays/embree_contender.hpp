// Embree as a contender: a scene, asked in one of its ways.
#pragma once

#include <memory>
#include <vector>

#include "bench/common/contender.hpp"
#include "bench/rays/embree_layouts.hpp"
#include "bench/rays/embree_scene.hpp"

namespace vkbake::bench {

/// Every way that is tried.
[[nodiscard]] std::vector<EmbreeCall> all_calls();
[[nodiscard]] std::string name_of(const EmbreeCall& call);

/// What it is made from must outlive it. Holds the rays that are made beforehand in the form that the call takes;
/// `for_pass`: the only kind of pass it will be asked for, so that nothing is held for the other.
[[nodiscard]] std::unique_ptr<Contender> make_embree_contender(const EmbreeScene& scene, const EmbreeCall& call,
                                                               const RaySet& rays, Pass for_pass);

} // namespace vkbake::bench
