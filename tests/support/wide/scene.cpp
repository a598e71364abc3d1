// Scenes in 50 and 100 digits.
#include "tests/support/multiprecision.hpp" // first: what follows takes its functions

#include "denhartog/scene/scene.cpp"
#include "denhartog/scene/scene_json.cpp"

namespace denhartog {

template void check_under_names(const Scene<Real50>&, const SceneNames&);
template void check_under_names(const Scene<Real100>&, const SceneNames&);
template void check(const Scene<Real50>&);
template void check(const Scene<Real100>&);
template void check(const System<Real50>&);
template void check(const System<Real100>&);
template Scene<Real50> converted(const Scene<double>&);
template Scene<Real100> converted(const Scene<double>&);
template Scene<Real50> scene_from_json(const json&);
template Scene<Real100> scene_from_json(const json&);

} // namespace denhartog
