#if !DENHARTOG_REFERENCE
#include "denhartog/answer/reference.hpp"
#include "denhartog/answer/reference_invariant_points.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {

bool has_reference() { return false; }

namespace {

[[noreturn]] void fail_by_name() {
    throw PrecisionError("this needs the reference, and the library was built without it (DENHARTOG_REFERENCE=OFF)");
}

} // namespace

Solution solution_by_reference(const SceneSource&, const ReferenceQuestion&, const std::function<std::vector<OrbitGuess>()>&) {
    fail_by_name();
}

std::vector<InvariantPointsOfMass<Certified>> invariant_points_by_reference(const SceneSource&, const RangeInText&, int, bool) {
    fail_by_name();
}

} // namespace denhartog
#endif
