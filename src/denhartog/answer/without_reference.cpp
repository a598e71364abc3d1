#if !DENHARTOG_REFERENCE
#include "denhartog/answer/modes_by_reference.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {
namespace {

[[noreturn]] void fail() {
    throw PrecisionError("this needs the reference, and the library was built without it (DENHARTOG_REFERENCE=OFF)");
}

} // namespace

bool has_reference() { return false; }

Solution solution_by_reference(const SceneSource&, const ReferenceQuestion&, const std::function<std::vector<OrbitGuess>()>&) {
    fail();
}

ModalBasis<Bounded<double>> modes_by_reference(const SceneSource&, bool) { fail(); }

std::vector<evaluation::ModeFunctions<Bounded<double>>> mode_functions_by_reference(const SceneSource&) { fail(); }

SystemByReference system_by_reference(const SceneSource&) { fail(); }

} // namespace denhartog
#endif
