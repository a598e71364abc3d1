#include "tests/speed_accuracy/peers/peers.hpp"

#include <cmath>

#include "denhartog/number/number.hpp"
#include "tests/speed_accuracy/peers/contact_receptance.hpp"

namespace denhartog::tests {
namespace {

/// With x_j = X cos(tau - phi), friction is i b e^(-i phi), b = 4 beta / pi, and X + i b h_f = h_l e^(i phi). Its modulus is an
/// equation of second order in X; the other root is never positive, as damping makes Im h_f negative.
PeerAnswer answer(const ContactReceptance& system, const ChartPoint& at) {
    const std::complex<double> h_f = system.of_friction(1, at.r), h_l = system.of_load(at.r);
    const double b = 4 * at.beta / pi<double>();
    const double square = std::norm(h_l) - b * b * h_f.real() * h_f.real();
    const double X = b * h_f.imag() + std::sqrt(square);
    PeerAnswer found;
    found.evaluations = 1;
    if (std::isnan(square) || std::isinf(X))
        found.ending = Ending::not_a_number;
    else if (X > 0)
        found.amplitude = X;
    else
        found.ending = Ending::outside_domain; // X is no number where the square is negative
    return found;
}

} // namespace

std::vector<Peer> monoharmonic_peers() {
    return {{"monoharmonic", "one harmonic", 0, [](const System<double>& s) {
                 return [system = ContactReceptance(s)](const ChartPoint& at) { return answer(system, at); };
             }}};
}

} // namespace denhartog::tests
