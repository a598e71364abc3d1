#include "conformance/verdict.hpp"
#include "denhartog/elementary/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace denhartog::conformance {
namespace {

constexpr std::array<std::string_view, number_of_verdicts> names{"pass",    "pass-loose",   "inaccurate", "as-printed",
                                                                 "wrong",   "wrong-regime", "rejected",   "not-rejected",
                                                                 "skipped", "crash",        "timeout",    "stall"};

} // namespace

std::string_view name(Verdict verdict) { return names.at(static_cast<std::size_t>(verdict)); }

std::optional<Verdict> verdict_named(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Verdict>(found - names.begin());
}

bool is_right(Verdict verdict) {
    return verdict == Verdict::pass || verdict == Verdict::pass_loose || verdict == Verdict::rejected;
}

bool is_wrong_value(Verdict verdict) {
    return verdict == Verdict::inaccurate || verdict == Verdict::as_printed || verdict == Verdict::wrong ||
           verdict == Verdict::wrong_regime;
}

int badness(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass:
    case Verdict::rejected: return 0;
    case Verdict::pass_loose: return 1;
    case Verdict::inaccurate: return 2;
    case Verdict::skipped: return 3;
    case Verdict::as_printed:
    case Verdict::wrong:
    case Verdict::wrong_regime:
    case Verdict::not_rejected: return 4;
    case Verdict::crash:
    case Verdict::timeout:
    case Verdict::stall: return 5;
    }
    return 5;
}

double digits(double error) {
    constexpr double most = 17;
    if (!(error > 0)) return most;
    return error < 1 ? std::min(-elementary::log10(error), most) : 0;
}

} // namespace denhartog::conformance
