#include "tests/speed_accuracy/answer_numbers.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace denhartog::tests {
namespace {

class Numbers {
public:
    void size(const std::string& name, const Certified& number, std::size_t place = 0) {
        all.push_back({name, place, number, 0, false});
    }
    void any(const std::string& name, const Certified& number, std::size_t place = 0) { all.push_back({name, place, number}); }
    void angle(const std::string& name, const Certified& number, std::size_t place, double period) {
        all.push_back({name, place, number, period});
    }

    void masses(const Solution& s) {
        for (std::size_t n = 0; n < s.masses.size(); ++n) {
            const SolvedMass& m = s.masses[n];
            const std::size_t k = s.only ? s.only->index + 1 : n + 1;
            size("amplitude", m.amplitude, k);
            if (m.phase) angle("phase", *m.phase, k, 2 * pi<double>());
            if (!m.sliding) continue;
            any("x0", m.sliding->x0, k);
            any("v0", m.sliding->v0, k);
            angle("instant", m.sliding->instant, k, pi<double>());
            size("amplitude_monoharmonic", m.sliding->amplitude_monoharmonic, k);
            angle("phase_monoharmonic", m.sliding->phase_monoharmonic, k, 2 * pi<double>());
        }
    }

    std::vector<NamedNumber> all;
};

Real100 value_of(const Certified& a) { return a.decimal.empty() ? Real100(a.value) : Real100(a.decimal); }

} // namespace

std::vector<NamedNumber> numbers_of(const Limits& limits) {
    Numbers n;
    n.size("beta_lim exact", limits.exact);
    n.size("beta_lim paper", limits.paper);
    n.size("beta_lim approximate", limits.approximate);
    if (limits.sticking) n.size("beta_lim sticking", *limits.sticking);
    return n.all;
}

std::vector<NamedNumber> numbers_of(const Solution& s) {
    Numbers n;
    n.size("r", s.r);
    n.size("mu", s.mu);
    if (s.beta) n.size("beta", *s.beta);
    if (s.limits)
        n.all = [&] {
            std::vector<NamedNumber> limits = numbers_of(*s.limits);
            limits.insert(limits.begin(), n.all.begin(), n.all.end());
            return limits;
        }();
    if (s.sticking_by_88) n.size("sticking by (88)", *s.sticking_by_88);
    n.masses(s);
    const double period = 2 * pi<double>() * s.periods;
    for (std::size_t i = 0; i < s.stops.size(); ++i) {
        n.angle("stop's start", s.stops[i].start, i + 1, period);
        n.angle("stop's end", s.stops[i].end, i + 1, period);
        n.any("stop's place", s.stops[i].x, i + 1);
    }
    if (s.start)
        for (std::size_t k = 0; k < s.start->x.size(); ++k) {
            n.any("x at the maximum of the force", s.start->x[k], k + 1);
            n.any("x' at the maximum of the force", s.start->x_prime[k], k + 1);
        }
    if (s.stability)
        for (std::size_t k = 0; k < s.stability->multipliers.size(); ++k)
            n.size("multiplier", s.stability->multipliers[k], k + 1);
    if (s.rest_interval) {
        n.any("rest interval from", s.rest_interval->from);
        n.any("rest interval to", s.rest_interval->to);
        if (s.rest_interval->rests_at) n.any("rests at", *s.rest_interval->rests_at);
    }
    return n.all;
}

std::vector<NamedNumber> numbers_of(const OtherMotion& motion) {
    Solution as_answer;
    as_answer.masses = motion.masses;
    as_answer.stops = motion.stops;
    as_answer.stability = motion.stability;
    as_answer.rest_interval = motion.rest_interval;
    std::vector<NamedNumber> all = numbers_of(as_answer);
    std::erase_if(all, [](const NamedNumber& n) { return n.name == "r" || n.name == "mu"; }); // those of the answer
    return all;
}

std::vector<NamedNumber> numbers_of(const Quantities<Bounded<double>>& q) {
    Numbers n;
    const auto certified = [](const Bounded<double>& a) { return Certified{a.x, a.e, {}}; };
    for (std::size_t k = 0; k < q.V.size(); ++k) {
        n.any("Re V", certified(q.V[k].re), k + 1);
        n.any("Im V", certified(q.V[k].im), k + 1);
        n.any("U", certified(q.U[k]), k + 1);
        n.any("G", certified(q.G[k]), k + 1);
    }
    n.any("H", certified(q.H_j));
    n.any("S", certified(q.S));
    n.size("beta_lim of quantities", certified(q.beta_lim));
    if (q.X_j) n.size("X_j", certified(*q.X_j));
    if (q.phi_j) n.angle("phi_j", certified(*q.phi_j), 0, 2 * pi<double>());
    for (std::size_t i = 0; i < q.x.size(); ++i) {
        n.any("x", certified(q.x[i]), i + 1);
        n.any("x'", certified(q.x_prime[i]), i + 1);
    }
    for (std::size_t k = 0; k < q.x_size.size(); ++k) n.size("(52)", certified(q.x_size[k]), k + 1);
    return n.all;
}

std::vector<std::string> faults_of(const std::vector<NamedNumber>& numbers) {
    std::vector<std::string> faults;
    for (const NamedNumber& n : numbers) {
        const auto fault = [&](const char* what) { faults.push_back(n.name + what); };
        if (!std::isfinite(n.number.value) && n.number.decimal.empty()) fault(" is not finite"); // else it is beyond a double
        if (n.number.value < 0 && !n.negative) fault(" is negative");
        if (!(n.number.error >= 0)) fault(" has a bound that is none");
        if (n.number.decimal.empty()) continue;
        try {
            if (!isfinite(value_of(n.number))) fault(" has decimals that are not finite");
        } catch (const std::exception&) {
            fault(" has decimals that are no number");
        }
    }
    return faults;
}

std::vector<std::string> contradictions_within(const Solution& s) {
    std::vector<std::string> found;
    // Whether a number is larger than another, by more than both bounds and some part of itself.
    const auto larger = [](const Certified& a, const Certified& b, double part = 0) {
        const Real100 size_of_a = abs(value_of(a));
        return size_of_a - abs(value_of(b)) > Real100(a.error) + Real100(b.error) + part * size_of_a;
    };
    const auto need = [&found](bool holds, const char* what) {
        if (!holds) found.emplace_back(what);
    };
    if (s.limits) {
        constexpr double rounding = 1e-9; // (56) leaves out the coupling of modes that makes no larger a difference
        need(!larger(s.limits->paper, s.limits->exact, rounding), "beta_lim by (56) is above the exact one");
        need(!larger(s.limits->exact, s.limits->approximate), "beta_lim is above that of (67)");
        if (s.slides_below) need(!larger(*s.slides_below, s.limits->exact), "the lower bound of beta_lim is above it");
    }
    for (std::size_t k = 0; k < s.masses.size(); ++k) {
        const SolvedMass& mass = s.masses[k];
        if (mass.sliding) need(!larger(mass.sliding->x0, mass.amplitude), "x0 is larger than the amplitude");
        if (s.start && !s.only)
            need(!larger(s.start->x[k], mass.amplitude),
                 "a displacement at the maximum of the force is larger than the amplitude");
    }
    return found;
}

std::vector<std::string> faults_of(const Solution& s) {
    std::vector<std::string> faults = faults_of(numbers_of(s));
    for (std::string& each : contradictions_within(s)) faults.push_back(std::move(each));
    const auto add = [&faults](const std::vector<std::string>& more, const std::string& of) {
        for (const std::string& each : more) faults.push_back(of + each);
    };
    if (s.slides_below) add(faults_of({{"slides below", 0, *s.slides_below, 0, false}}), "");
    if (!(s.relative_error >= 0)) faults.emplace_back("the largest error is no number");
    for (const OtherMotion& motion : s.motions) {
        add(faults_of(numbers_of(motion)), "another motion's ");
        for (const std::vector<double>* numbers : {&motion.start.x, &motion.start.x_prime, &motion.from.x, &motion.from.x_prime})
            for (const double x : *numbers)
                if (!std::isfinite(x)) faults.emplace_back("another motion's state is not finite");
    }
    return faults;
}

std::vector<ComparedNumber> compared(const std::vector<NamedNumber>& a, const std::vector<NamedNumber>& b) {
    std::map<std::pair<std::string, std::size_t>, const NamedNumber*> others;
    for (const NamedNumber& n : b) others[{n.name, n.place}] = &n;
    std::vector<ComparedNumber> all;
    for (const NamedNumber& n : a) {
        const auto found = others.find({n.name, n.place});
        if (found == others.end()) continue;
        const Certified &mine = n.number, &other = found->second->number;
        Real100 difference = value_of(mine) - value_of(other);
        if (n.period > 0) {
            const Real100 period = pi<Real100>() * static_cast<int>(std::lround(n.period / pi<double>()));
            difference -= period * round(Real100(difference / period));
        }
        all.push_back({n.name, static_cast<double>(Real100(abs(difference))), mine.error + other.error});
    }
    return all;
}

} // namespace denhartog::tests
