#if !DENHARTOG_REFERENCE
#include "denhartog/answer/reference.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {

bool has_reference() { return false; }

Solution solution_by_reference(const SceneSource&, const ReferenceQuestion&, const std::function<std::vector<OrbitGuess>()>&) {
    throw PrecisionError("this needs the reference, and the library was built without it (DENHARTOG_REFERENCE=OFF)");
}

} // namespace denhartog
#endif
