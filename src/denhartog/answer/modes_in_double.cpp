#include "denhartog/answer/modes_in_double.hpp"

#include "denhartog/answer/modes_by_reference.hpp"
#include "denhartog/model/modal_damping.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

// A damping matrix, if that counts, has to take energy out of every motion.
ModalBasis<Bounded<double>> checked(const System<double>& system, ModalBasis<Bounded<double>> basis) {
    if (basis.coupled()) check_passive(system.damping_matrix);
    return basis;
}

std::shared_ptr<const ContactSystem<double>> rounded_system(const SceneSource& source, const std::string& because) {
    return std::make_shared<const ContactSystem<double>>(moving_by_reference(source, because));
}

} // namespace

ModesInDouble modes_in_double(const SceneSource& source) {
    try {
        return {modes_with_errors(source->in_double().system)};
    } catch (const PrecisionError& e) {
        return {std::make_shared<const ModalBasis<Bounded<double>>>(
                    checked(source->in_double().system, modes_by_reference(source, true))),
                e.what()};
    }
}

std::shared_ptr<const ContactSystem<double>> moving_in_double(const SceneSource& source, const ModesInDouble& modes) {
    if (!modes.rounded_because.empty()) return rounded_system(source, modes.rounded_because);
    try {
        return std::make_shared<const ContactSystem<double>>(contact_system(source->in_double().system, *modes.basis));
    } catch (const PrecisionError& e) { // of the system with the contact held
        return rounded_system(source, e.what());
    }
}

ContactSystem<double> moving_by_reference(const SceneSource& source, const std::string& because) {
    const System<double>& system = source->in_double().system;
    const SystemByReference found = system_by_reference(source);
    ContactSystem<double> moving = contact_system(system, checked(system, found.basis), &found.held);
    moving.rounded_because = because;
    return moving;
}

} // namespace denhartog
