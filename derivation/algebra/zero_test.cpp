#include "derivation/algebra/zero_test.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>

#include "derivation/algebra/kept_identities.hpp"
#include "derivation/kernel/coq_text.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

std::string to_string(Verdict v) {
    switch (v) {
    case Verdict::proved: return "proved";
    case Verdict::refuted: return "refuted";
    default: return "unknown";
    }
}

namespace {

/// splitmix64: the same sample points on every machine.
std::uint64_t next_random(std::uint64_t& state) {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

constexpr int least_samples = 24;
constexpr int least_evaluated = 16; // of these, points that have values
constexpr int most_patterns = 64;   // combinations of signs that are all sampled: of six symbols, those in functions first

KnownBounds known_bounds(const std::vector<Range>& domain) {
    KnownBounds known;
    for (const Range& range : domain) known[range.symbol] = range.bounds;
    return known;
}

/// The symbols that stand in functions and under roots: there a sign can be lost.
void collect_inside(const ex& e, bool inside, GiNaC::exset& found) {
    if (inside && GiNaC::is_a<GiNaC::symbol>(e)) found.insert(e);
    const bool root = GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer);
    for (const ex& part : e) collect_inside(part, inside || root || GiNaC::is_a<GiNaC::function>(e), found);
}

void collect_roots(const ex& e, GiNaC::exset& found) {
    if (GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer)) found.insert(GiNaC::sqrt(e.op(0)));
    for (const ex& part : e) collect_roots(part, found);
}

/// The domain in an order in which the first signed symbols are those whose signs matter.
std::vector<Range> where_signs_matter_first(std::vector<Range> domain, const ex& left, const ex& right) {
    GiNaC::exset inside;
    collect_inside(left, false, inside);
    collect_inside(right, false, inside);
    std::stable_partition(domain.begin(), domain.end(), [&inside](const Range& r) { return inside.count(r.symbol) > 0; });
    return domain;
}

/// Sample points one after the other. What a range has below and above zero takes its turn, in all combinations with the others.
class Samples {
public:
    explicit Samples(const std::vector<Range>& domain) : domain_(domain) {}

    /// The number of combinations, `most_patterns` at most.
    int patterns() const {
        int product = 1;
        for (const Range& range : domain_)
            if (product * range.parts <= most_patterns) product *= range.parts;
        return product;
    }

    Point next() {
        Point point;
        int turn = 1;
        for (const Range& range : domain_) {
            const numeric width = (range.high - range.low) / range.parts;
            const numeric within = numeric(static_cast<long>(next_random(state_) % 997 + 1)) / 999;
            const int drawn_part = static_cast<int>(next_random(state_) % range.parts);
            const int part = turn * range.parts <= most_patterns ? drawn_ / turn % range.parts : drawn_part;
            point.emplace_back(range.symbol, range.low + width * (part + within));
            if (turn * range.parts <= most_patterns) turn *= range.parts;
        }
        ++drawn_;
        return point;
    }

private:
    const std::vector<Range>& domain_;
    std::uint64_t state_ = 20220117;
    int drawn_ = 0;
};

/// The symbols in which two expressions are polynomials and which stand in no generator.
std::vector<ex> free_symbols(const ex& left, const ex& right, const std::vector<Range>& domain, const Generators& generators) {
    std::vector<ex> free;
    for (const Range& range : domain) {
        const ex& x = range.symbol;
        const auto in_meaning = [&x](const auto& generator) { return generator.second.has(x); };
        if (left.is_polynomial(x) && right.is_polynomial(x) &&
            std::none_of(generators.names.begin(), generators.names.end(), in_meaning))
            free.push_back(x);
    }
    return free;
}

/// The coefficients of an expression by the powers of its free symbols: it is zero where each of them is.
std::vector<ex> coefficients(const ex& e, const std::vector<ex>& free) {
    std::vector<ex> parts{e.expand()};
    for (const ex& x : free) {
        std::vector<ex> finer;
        for (const ex& part : parts)
            for (int n = part.ldegree(x); n <= part.degree(x); ++n)
                if (const ex c = part.coeff(x, n); !c.is_zero()) finer.push_back(c);
        parts = std::move(finer);
    }
    return parts;
}

bool is_real_value(const numeric& n) { return abs(n.imag()) <= abs(n.real()) * numeric("1e-50"); }

/// The value of an expression at a point, part by part: nothing is simplified on the way, and no function is computed twice. What is
/// rational stays exact.
class Evaluation : public GiNaC::map_function {
public:
    explicit Evaluation(const Point& point) : point_(point) {
        for (const auto& [symbol, value] : point) known_[symbol] = value;
    }

    bool is_at(const Point& point) const {
        return std::equal(point.begin(), point.end(), point_.begin(), point_.end(),
                          [](const auto& a, const auto& b) { return a.second == b.second && a.first.is_equal(b.first); });
    }

    // The value of a whole expression, known if it was asked for before.
    numeric whole(const ex& e) {
        const auto place = known_.find(e);
        return place != known_.end() ? place->second : known_[e] = of(e);
    }

    numeric of(const ex& e) {
        if (GiNaC::is_a<numeric>(e)) return GiNaC::ex_to<numeric>(e);
        if (GiNaC::is_a<GiNaC::add>(e)) {
            numeric sum = 0;
            for (const ex& part : e) sum += of(part);
            return sum;
        }
        if (GiNaC::is_a<GiNaC::mul>(e)) {
            numeric product = 1;
            for (const ex& part : e) product *= of(part);
            return product;
        }
        if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::integer)) {
            const numeric base = of(e.op(0)), exponent = GiNaC::ex_to<numeric>(e.op(1));
            if (base.is_zero() && exponent.is_negative()) throw GiNaC::pole_error("division by zero", 1);
            return GiNaC::pow(base, exponent);
        }
        const auto known = known_.find(e);
        if (known != known_.end()) return known->second;
        return known_[e] = as_numeric(e.map(*this).evalf());
    }
    ex operator()(const ex& part) override { return of(part); }

private:
    static numeric as_numeric(const ex& value) {
        if (!GiNaC::is_a<numeric>(value)) throw std::domain_error("a symbol without a value");
        return GiNaC::ex_to<numeric>(value);
    }

    Point point_;
    std::map<ex, numeric, GiNaC::ex_is_less> known_;
};

std::string text(const numeric& n) {
    std::ostringstream out;
    out << n;
    return out.str();
}

bool refute_by_samples(Decision& decision, const ex& left, const ex& right, const std::vector<Range>& domain,
                       const std::vector<ex>& real, int& evaluated) {
    const std::vector<Range> ordered = where_signs_matter_first(domain, left, right);
    Samples samples(ordered);
    const int enough = std::max(least_samples, samples.patterns());
    evaluated = 0;
    for (int drawn = 0; drawn < enough || (drawn < 4 * enough && evaluated < least_evaluated); ++drawn) {
        const Point point = samples.next();
        numeric l, r;
        try {
            r = evaluate(right, point);
            bool inside = is_real_value(r);
            for (const ex& e : real) inside = inside && is_real_value(evaluate(e, point));
            if (!inside) throw std::domain_error("no real value at a point of the domain");
            l = evaluate(left, point);
        } catch (const std::exception& e) {
            decision.reason = e.what();
            continue;
        }
        ++evaluated;
        if (abs(l - r) > (abs(l) + abs(r) + 1) * numeric("1e-35")) {
            decision.verdict = Verdict::refuted;
            decision.witness = point;
            decision.left = text(l);
            decision.right = text(r);
            return true;
        }
    }
    return false;
}

} // namespace

ex remainder(const ex& e, const std::vector<Range>& domain) {
    Generators generators(known_bounds(domain));
    generators.collect(e, true);
    return generators.reduced_numerator(generators.rewrite(e, true));
}

numeric evaluate(const ex& e, const Point& point) {
    // The twins of a claim are all compared with the same expression at the same points.
    constexpr std::size_t most_points = 64;
    static std::vector<Evaluation> met;
    GiNaC::Digits = 60;
    auto place = std::find_if(met.begin(), met.end(), [&point](const Evaluation& at) { return at.is_at(point); });
    if (place == met.end()) {
        if (met.size() == most_points) met.clear();
        place = met.emplace(met.end(), point);
    }
    return GiNaC::ex_to<numeric>(ex(place->whole(e)).evalf());
}

std::vector<Point> sample_points(const std::vector<Range>& domain, int count) {
    std::vector<Point> points;
    Samples samples(domain);
    for (int k = 0; k < count; ++k) points.push_back(samples.next());
    return points;
}

std::vector<ex> roots_in(const std::vector<ex>& expressions) {
    GiNaC::exset found;
    for (const ex& e : expressions) collect_roots(e, found);
    std::vector<ex> roots(found.begin(), found.end());
    sort_by_text(roots.begin(), roots.end());
    return roots;
}

bool differs_at_samples(const ex& left, const ex& right, const std::vector<Range>& domain, const std::vector<ex>& real) {
    Decision decision;
    int evaluated = 0;
    return refute_by_samples(decision, left, right, domain, real, evaluated);
}

Decision decide_equal(const ex& left, const ex& right, const std::vector<Range>& domain, const std::vector<ex>& real) {
    Decision decision;
    Identity identity{left, right, domain, {}, {}, {}, {}, {}};
    bool zero = false;
    try {
        Generators generators(known_bounds(domain));
        for (const ex& e : real) generators.collect(e, true);
        generators.collect(right, true);
        generators.collect(left, false);
        for (const ex& e : real) (void)generators.rewrite(e, true);
        const ex r = generators.rewrite(right, true), l = generators.rewrite(left, false);
        const std::vector<ex> free = free_symbols(l, r, domain, generators);
        zero = true;
        for (const ex& c : coefficients(l - r, free)) zero = zero && generators.reduced_numerator(c).is_zero();
        if (zero)
            for (const ex& side : {l, r}) generators.note_divisions(side);
        decision.denominators = generators.denominators;
        decision.generators = generators.names;
        decision.roots = generators.roots;
        identity = {left, right, domain, l, r, generators.names, generators.relations(), generators.functions};
    } catch (const std::exception& e) {
        decision.reason = e.what();
        zero = false;
    }
    int evaluated = 0;
    if (refute_by_samples(decision, left, right, domain, real, evaluated)) {
        if (zero) throw std::logic_error("reduced to zero, yet not zero: " + decision.left + " against " + decision.right);
        return decision;
    }
    if (zero && evaluated >= least_evaluated) {
        decision.verdict = Verdict::proved;
        keep(identity);
    } else if (zero) {
        decision.reason = "only " + std::to_string(evaluated) + " points of the domain have values";
    }
    return decision;
}

} // namespace denhartog::derivation
