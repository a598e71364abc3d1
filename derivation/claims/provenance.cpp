#include "derivation/claims/provenance.hpp"

namespace denhartog::derivation {

namespace {
Watch* watching = nullptr;
int false_premises = 0;
} // namespace

FalsePremise::FalsePremise() { ++false_premises; }

FalsePremise::~FalsePremise() { --false_premises; }

Watch::Watch() : before_(watching) { watching = this; }

Watch::~Watch() { watching = before_; }

bool Watch::premise_called() const { return premise_; }

GiNaC::ex from_premise() {
    if (watching != nullptr) watching->premise_ = true;
    return false_premises > 0 ? GiNaC::numeric(9, 7) : GiNaC::numeric(1);
}

} // namespace denhartog::derivation
