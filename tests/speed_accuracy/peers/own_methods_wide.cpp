#include "denhartog/answer/scene_source.hpp"
#include "tests/speed_accuracy/peers/closed_form_peers.hpp"
#include "tests/speed_accuracy/peers/exact_solver_peer.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::tests {
namespace {

System<Real50> in_50_digits(const System<double>& system) {
    Scene<double> scene;
    scene.system = system;
    return converted<Real50>(scene).system;
}

ModalBasis<Real50> basis_in_50_digits(const System<double>& system) { return modal_basis(in_50_digits(system)); }

} // namespace

std::vector<Peer> closed_form_peers_in_50_digits() {
    return {printed_form_peer<Real50>("50 digits", basis_in_50_digits),
            shipped_form_peer<Real50>("50 digits", basis_in_50_digits)};
}

Peer exact_solver_peer_in_50_digits() { return exact_solver_peer<Real50>("50 digits", in_50_digits); }

} // namespace denhartog::tests
