#include "denhartog/answer/scene_source.hpp"
#include "tests/speed_accuracy/peers/closed_form_peers.hpp"
#include "tests/support/closed_form.hpp"

namespace denhartog::tests {
namespace {

ModalBasis<Real50> basis_in_50_digits(const System<double>& system) {
    Scene<double> scene;
    scene.system = system;
    return modal_basis(converted<Real50>(scene).system);
}

} // namespace

std::vector<Peer> closed_form_peers_in_50_digits() {
    return {printed_form_peer<Real50>("50 digits", basis_in_50_digits),
            shipped_form_peer<Real50>("50 digits", basis_in_50_digits)};
}

} // namespace denhartog::tests
