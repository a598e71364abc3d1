#include "denhartog/answer/modes_in_double.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/model/modal_damping.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

std::shared_ptr<const ContactSystem> rounded_system(const SceneSource& source, const Reasons& because) {
    return std::make_shared<const ContactSystem>(moving_by_reference(source, because));
}

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

constexpr std::size_t most_masses_by_reference = 200; // beyond, the reference takes too long

bool is_for_reference(const SceneSource& source, double error) {
    if (error <= tolerance_of(digits_by_default) || number_of_masses(source->in_double().system) > most_masses_by_reference)
        return false;
    count_precision_step();
    return true;
}

} // namespace

ModesInDouble modes_in_double(const SceneSource& source) {
    const auto found = tried([&] { return modes_with_errors(source->in_double().system, source->effort); });
    if (found.value) return {*found.value};
    return {std::make_shared<const ModalBasis<Bounded<double>>>(modes_by_reference(source, true)), found.why};
}

std::shared_ptr<const ContactSystem> moving_in_double(const SceneSource& source, const ModesInDouble& modes) {
    if (!modes.rounded_because.empty()) return rounded_system(source, modes.rounded_because);
    Tried<ContactSystem> held =
        tried([&] { return contact_system(source->in_double().system, *modes.basis, nullptr, source->effort); });
    return held.value ? std::make_shared<const ContactSystem>(*std::move(held.value)) : rounded_system(source, held.why);
}

ContactSystem moving_by_reference(const SceneSource& source, const Reasons& because) {
    const System<double>& system = source->in_double().system;
    const SystemByReference found = system_by_reference(source);
    ContactSystem moving = contact_system(system, found.basis, &found.held);
    moving.rounded_because = because;
    return moving;
}

std::optional<CoupledDamping> coupled_damping(const SceneSource& source) {
    const System<double>& system = source->in_double().system;
    if (system.damping_matrix.size() == 0) return std::nullopt;
    const SceneSource as_given = with_damping_tolerance(source, 0);
    std::shared_ptr<const ModalBasis<Bounded<double>>> modes = modes_in_double(as_given).basis;
    if (!modes->couples) modes = certain_modes(as_given, modes);
    if (!modes->couples) return std::nullopt;
    ModalBasis<double> basis = values_of(*modes);
    return CoupledDamping{basis.distance_from_classical > system.damping_tolerance, basis.distance_from_classical,
                          largest_coupling(basis.D), std::move(basis.zeta)};
}

std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    if (!is_for_reference(source, relative_error(*basis))) return basis;
    Tried<ModalBasis<Bounded<double>>> modes = tried([&] { return modes_by_reference(source, false); });
    return modes.value ? std::make_shared<const ModalBasis<Bounded<double>>>(*std::move(modes.value)) : basis;
}

ModeFunctionsInDouble certain_mode_functions(const SceneSource& source,
                                             const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    Tried<ModeFunctionsInDouble> functions = tried([&] { return mode_functions_at(*basis, as_input(*source->in_double().r)); });
    if (is_for_reference(source, functions.at_pole ? 1 : relative_error(functions.required()))) {
        Tried<ModeFunctionsInDouble> proved = tried([&] { return mode_functions_by_reference(source); });
        if (proved.value) return *std::move(proved.value);
    }
    return std::move(functions.required());
}

} // namespace denhartog
