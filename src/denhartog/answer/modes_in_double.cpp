#include "denhartog/answer/modes_in_double.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/modes_by_reference.hpp"
#include "denhartog/model/modal_damping.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

// Decides whether the damping matrix, if that counts, couples the modes.
ModalBasis<Bounded<double>> with_damping(const System<double>& system, ModalBasis<Bounded<double>> basis) {
    if (certainly_couples(basis))
        check_passive(system.damping_matrix);
    else
        leave_out_coupling(basis);
    return basis;
}

std::shared_ptr<const ContactSystem> rounded_system(const SceneSource& source, const std::string& because) {
    return std::make_shared<const ContactSystem>(moving_by_reference(source, because));
}

// The modes with the damping matrix as it is.
ModalBasis<double> modes_as_given(const SceneSource& source) {
    try {
        System<double> system = source->in_double().system;
        system.damping_tolerance = 0;
        return modal_basis(system);
    } catch (const PrecisionError&) {
        ModalBasis<Bounded<double>> basis = modes_by_reference(with_damping_tolerance(source, 0), true);
        if (!certainly_couples(basis)) leave_out_coupling(basis);
        return values_of(basis);
    }
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

constexpr std::size_t most_masses = 200; // beyond, the reference takes too long

bool is_for_reference(const SceneSource& source, double error) {
    if (error <= tolerance_of(digits_by_default) || number_of_masses(source->in_double().system) > most_masses) return false;
    count_precision_step();
    return true;
}

} // namespace

bool certainly_couples(const ModalBasis<Bounded<double>>& basis) {
    for (Eigen::Index i = 0; i < basis.D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            if (std::abs(basis.D(i, k).x) > basis.D(i, k).e) return true;
    return false;
}

void leave_out_coupling(ModalBasis<Bounded<double>>& basis) {
    basis.left_out = basis.D.unaryExpr([](const Bounded<double>& entry) { return Bounded<double>(entry.most()); });
    basis.left_out.diagonal().setZero();
    basis.D.resize(0, 0);
}

ModesInDouble modes_in_double(const SceneSource& source) {
    try {
        return {modes_with_errors(source->in_double().system)};
    } catch (const PrecisionError& e) {
        return {std::make_shared<const ModalBasis<Bounded<double>>>(
                    with_damping(source->in_double().system, modes_by_reference(source, true))),
                e.what()};
    }
}

std::shared_ptr<const ContactSystem> moving_in_double(const SceneSource& source, const ModesInDouble& modes) {
    if (!modes.rounded_because.empty()) return rounded_system(source, modes.rounded_because);
    try {
        return std::make_shared<const ContactSystem>(contact_system(source->in_double().system, *modes.basis));
    } catch (const PrecisionError& e) { // of the system with the contact held
        return rounded_system(source, e.what());
    }
}

ContactSystem moving_by_reference(const SceneSource& source, const std::string& because) {
    const System<double>& system = source->in_double().system;
    const SystemByReference found = system_by_reference(source);
    ContactSystem moving = contact_system(system, with_damping(system, found.basis), &found.held);
    moving.rounded_because = because;
    return moving;
}

std::optional<CoupledDamping> coupled_damping(const SceneSource& source) {
    const System<double>& system = source->in_double().system;
    if (system.damping_matrix.size() == 0) return std::nullopt;
    ModalBasis<double> basis = modes_as_given(source);
    if (!basis.coupled()) return std::nullopt;
    return CoupledDamping{basis.distance_from_classical > system.damping_tolerance, basis.distance_from_classical,
                          largest_coupling(basis.D), std::move(basis.zeta)};
}

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
