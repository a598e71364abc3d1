#include "denhartog/answer/moving_system.hpp"

#include "denhartog/number/errors.hpp"
#include "denhartog/stick_slip/rounded_system.hpp"

namespace denhartog {

std::shared_ptr<const ContactSystem<double>> moving_in_double(const SceneSource& source) {
    try {
        return std::make_shared<const ContactSystem<double>>(contact_system(source->in_double().system));
    } catch (const PrecisionError& e) {
        const ContactSystem<Real50> in_50_digits = contact_system(scene_in<Real50>(source).system);
        return std::make_shared<const ContactSystem<double>>(rounded(in_50_digits, e.what()));
    }
}

} // namespace denhartog
