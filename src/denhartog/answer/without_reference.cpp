#if !DENHARTOG_REFERENCE
#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {
namespace {

[[noreturn]] void refuse() { throw PrecisionError(Why::no_reference); }

} // namespace

bool has_reference() { return false; }

AnswerOrNone solution_by_reference(const SceneSource&, const ReferenceQuestion&,
                                   const std::function<std::vector<OrbitGuess>()>&) {
    return {Outcome::not_certain, {}, Why::no_reference};
}

std::vector<State> samples_by_reference(const SceneSource&, const Solution&, const std::vector<double>&, double,
                                        const std::function<std::vector<OrbitGuess>()>&) {
    refuse();
}

Energies energies_by_reference(const SceneSource&, const Solution&, int, const std::function<std::vector<OrbitGuess>()>&) {
    refuse();
}

std::vector<InvariantPointsOfMass<Certified>> invariant_points(const SceneSource&, const RangeInText&, std::optional<int>) {
    refuse();
}

ModalBasis<Bounded<double>> modes_by_reference(const SceneSource&, bool) { refuse(); }

std::vector<evaluation::ModeFunctions<Bounded<double>>> mode_functions_by_reference(const SceneSource&) { refuse(); }

SystemByReference system_by_reference(const SceneSource&) { refuse(); }

std::vector<Certified> place_of_rest(const SceneSource& source) {
    if (source->in_double().static_load.empty()) return {};
    refuse();
}

FreeDecay free_decay(const SceneSource&, const State&, const std::optional<double>&) { refuse(); }

} // namespace denhartog
#endif
