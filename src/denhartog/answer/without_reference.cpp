// The functions of the reference in a build without it: an answer that double cannot give is then refused, or given with the
// estimate of double. `reference.cpp` and the files beside it have the functions themselves.
#if !DENHARTOG_REFERENCE
#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {
namespace {

const Refusal none{Outcome::digits_missing, Why::no_reference};

[[noreturn]] void refuse() { throw PrecisionError(none.why); }

} // namespace

AnswerByReference solution_by_reference(const SceneSource&, const ReferenceQuestion&,
                                        const std::function<std::vector<OrbitGuess>()>&) {
    return {{none}};
}

Tried<std::vector<State>> samples_by_reference(const SceneSource&, const Solution&, const std::vector<double>&, double,
                                               const std::function<std::vector<OrbitGuess>()>&) {
    return none;
}

Energies energies_by_reference(const SceneSource&, const Solution&, int, const std::function<std::vector<OrbitGuess>()>&) {
    refuse();
}

std::vector<InvariantPointsOfMass<Certified>> invariant_points(const SceneSource&, const RangeInText&, std::optional<int>) {
    refuse();
}

Tried<ModalBasis<Bounded<double>>> modes_by_reference(const SceneSource&, bool) { return none; }

Tried<std::vector<evaluation::ModeFunctions<Bounded<double>>>> mode_functions_by_reference(const SceneSource&) { return none; }

Tried<ContactSystem> moving_by_reference(const SceneSource&, const Reasons&) { return none; }

std::vector<Certified> place_of_rest(const SceneSource& source) {
    if (source->in_double().static_load.empty()) return {};
    refuse();
}

FreeDecay free_decay(const SceneSource&, const State&, const std::optional<double>&) { refuse(); }

} // namespace denhartog
#endif
