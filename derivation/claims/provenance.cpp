#include "derivation/claims/provenance.hpp"

namespace denhartog::derivation {

namespace {
Watch* watching = nullptr;
}

Watch::Watch() : before_(watching) { watching = this; }

Watch::~Watch() { watching = before_; }

bool Watch::premise_called() const { return premise_; }

void from_premise() {
    if (watching != nullptr) watching->premise_ = true;
}

} // namespace denhartog::derivation
