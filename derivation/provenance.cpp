#include "provenance.hpp"

namespace denhartog::derivation {

namespace {
Watch* watching = nullptr;
}

Watch::Watch() : before_(watching) { watching = this; }

Watch::~Watch() { watching = before_; }

bool Watch::template_called() const { return none_.operations() > 0; }

bool Watch::equation_of_motion_called() const { return equation_of_motion_; }

void from_equation_of_motion() {
    if (watching != nullptr) watching->equation_of_motion_ = true;
}

} // namespace denhartog::derivation
