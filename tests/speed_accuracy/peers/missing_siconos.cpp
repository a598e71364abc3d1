#include "tests/speed_accuracy/peers/peers.hpp"

namespace denhartog::tests {

std::vector<Peer> siconos_peers() { return {{"Siconos, Moreau-Jean", "not installed: libsiconos-kernel-dev", 0, {}}}; }

} // namespace denhartog::tests
