// The check of the selections: a form taken where it is not proved is found.
#include "derivation/selections/selections.hpp"

#include "derivation/algebra/symbols.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;
namespace evaluation = denhartog::evaluation;
namespace paper = denhartog::paper;
using GiNaC::ex;

namespace {

std::vector<ex> paper_response(const ex&, const ex& R, const ex& zeta) {
    const denhartog::Complex<Symbolic> v = paper::complex_response(Symbolic(R), Symbolic(zeta));
    return {v.re.expression(), v.im.expression()};
}

std::vector<Placed> parts_of(const denhartog::Complex<Placed>& v) { return {v.re, v.im}; }

derivation::Outcome outcome_of(const std::function<denhartog::Complex<Placed>(const Placed& R, const Placed& zeta)>& take) {
    const Selection selection{"under test",
                              [&take](const Placed&, const Placed& R, const Placed& zeta) { return parts_of(take(R, zeta)); },
                              paper_response};
    return check_selection(selection);
}

std::string words_of(const derivation::Outcome& outcome) { return outcome.steps.empty() ? "" : outcome.steps.front().text; }

} // namespace

TEST_CASE("the shipped selection takes no form outside the domain of its proof", "[selection]") {
    const derivation::Outcome outcome = outcome_of([](const Placed& R, const Placed& zeta) { return evaluation::complex_response(R, zeta); });
    CHECK(outcome.verdict == Verdict::proved);
    CHECK(outcome.steps.size() > 4); // its conditions, each seen on both sides
}

TEST_CASE("a selection that takes a form where that divides by zero is refuted", "[selection]") {
    const derivation::Outcome without_damping =
        outcome_of([](const Placed& R, const Placed& zeta) { return evaluation::complex_response_near_resonance(R, zeta); });
    CHECK(without_damping.verdict == Verdict::refuted);
    CHECK(words_of(without_damping).find("zeta = 0.000000") != std::string::npos);
    const derivation::Outcome at_resonance = outcome_of([](const Placed& R, const Placed& zeta) {
        return zeta > 0 ? evaluation::complex_response_off_resonance(R, zeta, Placed(4))
                        : evaluation::complex_response_high_frequency(R, zeta);
    });
    CHECK(at_resonance.verdict == Verdict::refuted);
    CHECK(words_of(at_resonance).find("R = 1.000000") != std::string::npos);
}

TEST_CASE("a selection is refuted that takes a wrong form on one side of a condition alone, and on the condition alone",
          "[selection]") {
    const auto wrong_from = [](const Placed& R, const Placed& zeta) {
        if (R >= 7) return evaluation::complex_response_high_frequency(Placed(R + 1), zeta);
        return evaluation::complex_response_high_frequency(R, zeta);
    };
    CHECK(outcome_of(wrong_from).verdict == Verdict::refuted);
    const auto wrong_at = [](const Placed& R, const Placed& zeta) {
        if (R == 7) return evaluation::complex_response_high_frequency(Placed(R + 1), zeta);
        return evaluation::complex_response_high_frequency(R, zeta);
    };
    CHECK(outcome_of(wrong_at).verdict == Verdict::refuted);
}
