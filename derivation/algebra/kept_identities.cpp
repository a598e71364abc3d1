#include "derivation/algebra/kept_identities.hpp"

#include <utility>

namespace denhartog::derivation {

namespace {
Keeper* listening = nullptr;
}

Keeper::Keeper() : before_(std::exchange(listening, this)) {}
Keeper::~Keeper() { listening = before_; }

KeepNothing::KeepNothing() : before_(std::exchange(listening, nullptr)) {}
KeepNothing::~KeepNothing() { listening = before_; }

void keep(const Identity& identity) {
    if (listening != nullptr) listening->identities.push_back(identity);
}

void keep(Ground ground) {
    if (listening != nullptr) listening->grounds.insert(ground);
}

} // namespace denhartog::derivation
