#include "denhartog/answer/modes_in_double.hpp"

#include "denhartog/number/errors.hpp"
#include "denhartog/stick_slip/rounded_system.hpp"

namespace denhartog {
namespace {

std::shared_ptr<const ContactSystem<double>> rounded_system(const SceneIn<Real50>& wide, const std::string& because) {
    return std::make_shared<const ContactSystem<double>>(rounded(contact_system(wide.scene.system, *wide.basis), because));
}

} // namespace

ModesInDouble modes_in_double(const SceneSource& source) {
    try {
        return {modes_with_errors(source->in_double().system)};
    } catch (const PrecisionError& e) {
        const auto wide = std::make_shared<const SceneIn<Real50>>(scene_with_modes<Real50>(source));
        return {std::make_shared<const ModalBasis<Bounded<double>>>(in_double(*wide->basis)), wide, e.what()};
    }
}

std::shared_ptr<const ContactSystem<double>> moving_in_double(const SceneSource& source, const ModesInDouble& modes) {
    if (modes.rounded_from) return rounded_system(*modes.rounded_from, modes.rounded_because);
    try {
        return std::make_shared<const ContactSystem<double>>(contact_system(source->in_double().system, *modes.basis));
    } catch (const PrecisionError& e) { // of the system with the contact held
        return rounded_system(scene_with_modes<Real50>(source), e.what());
    }
}

} // namespace denhartog
