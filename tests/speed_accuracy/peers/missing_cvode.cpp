#include "tests/speed_accuracy/peers/peers.hpp"

namespace denhartog::tests {

std::vector<Peer> cvode_peers() { return {{"SUNDIALS CVODE", "not installed: libsundials-dev", 0, {}}}; }

} // namespace denhartog::tests
