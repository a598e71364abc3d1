#include "conformance/diagnose.hpp"

namespace denhartog::conformance {

Signatures known_signatures() { return {mistakes(), answer_with_mistake}; }

} // namespace denhartog::conformance
