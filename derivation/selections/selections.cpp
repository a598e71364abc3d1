// Which form where: the selections compare numbers and stay outside the proofs. This checks, with the selections as shipped, that
// a form is proved on a domain that contains every place where it is taken.
#include "derivation/selections/selections.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "denhartog/evaluation/demand.hpp"
#include "derivation/algebra/kept_identities.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/forms/overdamped_motion.hpp"
#include "derivation/typeset/latex.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace scalar {

std::vector<Comparison>& comparisons() {
    static std::vector<Comparison> all;
    return all;
}

bool noted(const Placed& a, const Placed& b, bool equality, bool outcome) {
    comparisons().push_back({(a.symbolic().expression() - b.symbolic().expression()).expand(), equality, outcome});
    return outcome;
}

SineCosine<Placed> sine_cosine_of_half_period(const Placed& R, const Placed& y) {
    const SineCosine<Symbolic> e = sine_cosine_of_half_period(R.symbolic(), y.symbolic());
    const SineCosine<double> v = denhartog::sine_cosine_of_half_period(R.value(), y.value());
    return {{e.s, v.s}, {e.c, v.c}};
}

} // namespace scalar

namespace {

/// The symbols of a place's coordinates; its numbers, where they take their place.
struct Coordinates {
    ex tau, R, zeta;
};

const numeric& end_of_half_period() {
    GiNaC::Digits = 60;
    static const numeric end = GiNaC::ex_to<numeric>(GiNaC::Pi.evalf());
    return end;
}

/// The arguments for which a selection shows its conditions.
Coordinates symbols_at(const Place& place) {
    const Symbols& s = symbols();
    return {s.tau, s.R, place.zeta < 1 ? s.zeta : place.zeta > 1 ? heavy() : ex(1)};
}

/// The arguments with the ends of the half-period as numbers: there the meaning is a limit.
Coordinates with_ends(const Place& place) {
    Coordinates at = symbols_at(place);
    if (place.tau.is_zero()) at.tau = 0;
    if (place.tau == end_of_half_period()) at.tau = GiNaC::Pi;
    return at;
}

Point point_at(const Place& place) {
    const Symbols& s = symbols();
    Point point{{s.tau, place.tau}, {s.R, place.R}, {s.zeta, place.zeta}, {heavy(), place.zeta}};
    int n = 2; // any values do for the others
    for (const ex& other : {s.u, s.g, s.psi_ji, s.psi_li, s.beta, s.eta_0, s.eta_prime_0, s.phi_j})
        point.emplace_back(other, numeric(1, ++n));
    return point;
}

/// Whether an expression vanishes at a place; a number that is merely small does not.
bool vanishes(const ex& e, const Place& place) {
    const numeric value = evaluate(e, point_at(place));
    const bool extreme = (!place.zeta.is_zero() && place.zeta < numeric("1e-40")) || place.R > numeric("1e20");
    return extreme ? value.is_zero() : abs(value) < numeric("1e-45");
}

/// True if a divisor in an expression vanishes at a place, even if it cancels in the end.
bool divides_by_zero(const ex& e, const Place& place) {
    const bool quotient = GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::negative);
    if (quotient && vanishes(e.op(0), place)) return true;
    return std::any_of(e.begin(), e.end(), [&place](const ex& part) { return divides_by_zero(part, place); });
}

/// The form that a selection takes at a place, with these coordinates in the expressions.
std::vector<ex> form_taken(const Selection& selection, const Place& place, const Coordinates& at) {
    scalar::comparisons().clear();
    const auto placed = [](const ex& e, const numeric& value) { return Placed(Symbolic(e), value.to_double()); };
    std::vector<ex> form;
    for (const Placed& component : selection.take(placed(at.tau, place.tau), placed(at.R, place.R), placed(at.zeta, place.zeta)))
        form.push_back(component.symbolic().expression());
    return form;
}

/// Decides forms, each once, and keeps the conditions that the selection has asked.
class Checker {
public:
    explicit Checker(const Selection& selection) : selection_(selection) {}

    /// The fault of the form taken at a place; empty if it is proved there, or if its meaning has a pole.
    std::string fault_at(const Place& place) {
        const Coordinates symbolic = symbols_at(place);
        Coordinates at = with_ends(place);
        try {
            (void)form_taken(selection_, place, symbolic);
        } catch (const GiNaC::pole_error&) {
        } // taken again below, with numbers
        for (const scalar::Comparison& c : scalar::comparisons()) {
            if (!GiNaC::is_a<numeric>(symbolic.zeta))
                conditions_[c.difference].insert(c.outcome); // as it stands, with its symbols
            if (c.equality && c.outcome && c.difference.has(symbolic.R)) at.R = place.R;
            if (c.equality && c.outcome && c.difference.has(symbolic.zeta)) at.zeta = place.zeta;
        }
        if (has_pole(place)) {
            ++poles;
            return "";
        }
        std::vector<Coordinates> attempts{at};
        if (place.zeta.is_zero()) attempts.push_back({at.tau, at.R, place.zeta}); // what divides by zeta there is another form
        std::string fault;
        for (const Coordinates& attempt : attempts) {
            fault = fault_of_form(attempt, place);
            if (fault.empty()) return "";
        }
        return fault;
    }

    /// The number of different forms, component by component, that were decided.
    [[nodiscard]] std::size_t forms() const { return decisions_.size() - meanings_; }
    /// The conditions with the outcomes that were seen.
    [[nodiscard]] const std::map<ex, std::set<bool>, GiNaC::ex_is_less>& conditions() const { return conditions_; }
    int poles = 0; ///< places at which the meaning has no value

private:
    struct Less {
        bool operator()(const std::pair<ex, ex>& a, const std::pair<ex, ex>& b) const {
            const int first = a.first.compare(b.first);
            return first != 0 ? first < 0 : a.second.compare(b.second) < 0;
        }
    };

    const Decision& decision(const ex& left, const ex& right) {
        const auto known = decisions_.find({left, right});
        if (known != decisions_.end()) return known->second;
        const Decision made = decide_equal(left, right, domain_of({left, right}));
        if (made.verdict == Verdict::proved && !left.is_equal(right) &&
            decide_equal(left, right + 1, domain_of({left, right})).verdict == Verdict::refuted)
            ++altered_statements_refuted();
        return decisions_.emplace(std::pair(left, right), made).first->second;
    }

    static bool meets_pole(const Decision& d, const Place& place) {
        const GiNaC::exmap stand_for(d.generators.begin(), d.generators.end());
        return std::any_of(d.denominators.begin(), d.denominators.end(),
                           [&](const ex& denominator) { return vanishes(denominator.subs(stand_for), place); });
    }

    bool has_pole(const Place& place) {
        const Coordinates at = with_ends(place);
        bool pole = false;
        for (const ex& meaning : selection_.meaning(at.tau, at.R, at.zeta)) {
            const std::size_t before = decisions_.size();
            pole = meets_pole(decision(meaning, meaning), place) || pole;
            meanings_ += decisions_.size() - before;
        }
        return pole;
    }

    std::string fault_of_form(const Coordinates& at, const Place& place) {
        try {
            const std::vector<ex> form = form_taken(selection_, place, at), meaning = selection_.meaning(at.tau, at.R, at.zeta);
            if (form.size() != meaning.size()) throw std::logic_error("a selection with other components than its meaning");
            for (std::size_t i = 0; i < form.size(); ++i) {
                const Decision& d = decision(form[i], meaning[i]);
                if (d.verdict != Verdict::proved) return "a form is " + to_string(d.verdict) + " " + d.reason;
                if (divides_by_zero(form[i], place)) return "a form divides by zero";
            }
            return "";
        } catch (const GiNaC::pole_error&) {
            return "a form divides by zero";
        }
    }

    const Selection& selection_;
    std::map<std::pair<ex, ex>, Decision, Less> decisions_;
    std::size_t meanings_ = 0; // decisions on meanings, not on forms
    std::map<ex, std::set<bool>, GiNaC::ex_is_less> conditions_;
};

struct NumericLess {
    bool operator()(const numeric& a, const numeric& b) const { return a < b; }
};
using Axis = std::set<numeric, NumericLess>;

/// The places of a coordinate where a condition on it alone changes its outcome, and what lies between, beyond and next to them.
void add_edges(Axis& axis, const ex& coordinate, const std::vector<ex>& conditions) {
    for (const ex& condition : conditions) {
        if (!condition.is_polynomial(coordinate) || condition.degree(coordinate) != 1) continue;
        const ex slope = condition.coeff(coordinate, 1), at_zero = condition.coeff(coordinate, 0);
        if (!GiNaC::is_a<numeric>(slope) || !GiNaC::is_a<numeric>(at_zero)) continue;
        const numeric edge = GiNaC::ex_to<numeric>(-at_zero / slope);
        if (!edge.is_negative()) axis.insert(edge);
    }
    const Axis edges = axis;
    for (auto next = edges.begin(), before = next++; next != edges.end(); before = next++) axis.insert((*before + *next) / 2);
}

std::string text(const numeric& n) { return std::to_string(n.to_double()); }

/// LaTeX with the numbers of many digits, the limits of double, as powers of two.
std::string with_powers_of_two(std::string latex) {
    constexpr std::size_t many = 15;
    for (std::size_t from = 0; (from = latex.find_first_of("0123456789", from)) != std::string::npos;) {
        const std::size_t digits = std::min(latex.find_first_not_of("0123456789", from), latex.size()) - from;
        std::string shown = latex.substr(from, digits);
        if (digits > many) {
            int exponent = 0;
            for (numeric n(shown.c_str()); n.is_even(); n = n / 2) ++exponent;
            if (GiNaC::pow(numeric(2), numeric(exponent)) == numeric(shown.c_str()))
                shown = "2^{" + std::to_string(exponent) + "}";
        }
        latex.replace(from, digits, shown);
        from += shown.size();
    }
    return latex;
}

} // namespace

Outcome check_selection(const Selection& selection) {
    keep(Ground::places);
    const Symbols& s = symbols();
    Checker checker(selection);
    Axis tau{numeric(1, 100), numeric(1), numeric(3)};
    Axis R{numeric(1, 10), numeric(1, 3), numeric(63, 64), numeric(1), numeric(10)};
    Axis zeta{numeric(0), numeric(1, 100), numeric(1), numeric(5)};
    std::string fault;
    int places = 0;
    const auto visit = [&] {
        for (const numeric& t : tau)
            for (const numeric& ratio : R)
                for (const numeric& damping : zeta) {
                    if (!fault.empty()) return;
                    ++places;
                    fault = checker.fault_at({t, ratio, damping});
                    if (!fault.empty()) fault += " at tau = " + text(t) + ", R = " + text(ratio) + ", zeta = " + text(damping);
                }
    };
    visit(); // the first round finds the conditions, the second goes to their edges
    std::vector<ex> conditions;
    for (const auto& [condition, outcomes] : checker.conditions()) conditions.push_back(condition.subs(heavy() == s.zeta));
    add_edges(tau, s.tau, conditions);
    if (std::any_of(conditions.begin(), conditions.end(), [&s](const ex& c) { return c.is_equal(s.tau); })) {
        tau.insert(numeric(0)); // it asks for the ends
        tau.insert(end_of_half_period());
    }
    add_edges(R, s.R, conditions);
    R.insert({*R.begin() / 2, *R.rbegin() * 2});
    add_edges(zeta, s.zeta, conditions);
    places = checker.poles = 0;
    visit();
    std::map<ex, std::set<bool>, GiNaC::ex_is_less> seen; // the same condition, asked of either symbol for zeta
    for (const auto& [condition, outcomes] : checker.conditions())
        seen[condition.subs(heavy() == s.zeta)].insert(outcomes.begin(), outcomes.end());
    Outcome outcome;
    const std::string count = std::to_string(places) + " places, " + std::to_string(checker.poles) + " of them poles, " +
                              std::to_string(checker.forms()) + " forms";
    add_statement(outcome, fault.empty() ? Verdict::proved : Verdict::refuted,
                  selection.name + ": " + (fault.empty() ? "every form is proved where it is taken; " + count : fault), "");
    for (const auto& [condition, outcomes] : seen) {
        if (GiNaC::is_a<numeric>(condition)) continue;
        const bool both = outcomes.size() == 2;
        add_statement(outcome, both ? Verdict::proved : Verdict::unknown,
                      both ? "A condition of the selection, seen on both sides"
                           : "A condition of the selection of which one side was not seen",
                      with_powers_of_two(latex(condition)));
    }
    return outcome;
}

} // namespace denhartog::derivation

denhartog::derivation::Placed std::numeric_limits<denhartog::derivation::Placed>::epsilon() {
    using namespace denhartog::derivation;
    return {Symbolic(1 / GiNaC::pow(GiNaC::ex(2), 52)), std::numeric_limits<double>::epsilon()};
}

denhartog::derivation::Placed(std::numeric_limits<denhartog::derivation::Placed>::min)() {
    using namespace denhartog::derivation;
    return {Symbolic(1 / GiNaC::pow(GiNaC::ex(2), 1022)), (std::numeric_limits<double>::min)()};
}
