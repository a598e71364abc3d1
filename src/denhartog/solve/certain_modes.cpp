#include "denhartog/solve/certain_modes.hpp"

#include <algorithm>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/modes_by_reference.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {
namespace {

// A mode shape has its digits beside its largest entry.
double relative_error(const ModalBasis<Bounded<double>>& basis) {
    double largest = 0;
    const auto take = [&](const Bounded<double>& x) { largest = std::max(largest, relative_error(x)); };
    for (const auto& shape : basis.phi.colwise()) {
        Bounded<double> of_shape(0);
        for (const Bounded<double>& entry : shape) of_shape = larger(of_shape, {size_of_number(entry.x), entry.e});
        take(of_shape);
    }
    std::ranges::for_each(basis.r_n, take);
    std::ranges::for_each(basis.zeta, take);
    return largest;
}

using ModeFunctionsInDouble = std::vector<evaluation::ModeFunctions<Bounded<double>>>;

double relative_error(const ModeFunctionsInDouble& functions) {
    double largest = 0;
    for (const auto& f : functions)
        largest = std::max({largest, relative_error(modulus(f.v)), relative_error(f.u), relative_error(f.g)});
    return largest;
}

constexpr std::size_t most_masses = 200; // beyond, the reference takes too long

bool is_for_reference(const SceneSource& source, double error) {
    if (error <= tolerance_of(digits_by_default) || number_of_masses(source->in_double().system) > most_masses) return false;
    count_precision_step();
    return true;
}

} // namespace

std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    if (!is_for_reference(source, relative_error(*basis))) return basis;
    try {
        auto modes = std::make_shared<ModalBasis<Bounded<double>>>(modes_by_reference(source, false));
        if (!basis->coupled() && modes->coupled()) leave_out_coupling(*modes); // rounding of the damping matrix couples them
        return modes;
    } catch (const PrecisionError&) {
        return basis;
    }
}

ModeFunctionsInDouble certain_mode_functions(const SceneSource& source,
                                             const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    ModeFunctionsInDouble functions;
    std::optional<DomainError> pole;
    try {
        functions = mode_functions_at(*basis, as_input(*source->in_double().r));
    } catch (const DomainError& e) {
        pole = e;
    }
    if (!is_for_reference(source, pole ? 1 : relative_error(functions))) return functions;
    try {
        return mode_functions_by_reference(source);
    } catch (const PrecisionError&) {
        if (pole) throw *pole;
        return functions;
    }
}

} // namespace denhartog
