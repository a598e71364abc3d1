// The numbers of a point, (33) to (39), (56), (64) and (69), each with its bound: in double, or else by the reference. Read
// `quantities` first; a number that is zero within its bound is made zero by `tell_zeros`.
#include "denhartog/solve/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/answer/certify.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#if DENHARTOG_REFERENCE
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/reference/sliding.hpp"
#endif

namespace denhartog {
namespace {

constexpr double nothing = 1e-280;    // bounds below it are of numbers that their formula makes zero
constexpr double zero_beside = 1e-25; // of the largest of its kind: what the reference does not tell from zero there is zero
constexpr int most_digits_of_quantities = 15;

struct Largest {
    double relative = 0;
    std::string name;
};

bool is_motion(std::string_view name) { return name == "x" || name == "x'"; }

bool is_asked_for(std::string_view name, PointNumbers asked) {
    if (asked == PointNumbers::all) return true;
    const bool belongs_to_motion = is_motion(name) || name == "X_j" || name == "phi_j";
    return asked == PointNumbers::sums ? !belongs_to_motion : is_motion(name);
}

// With zeros told apart a number without a size is one.
Largest largest_bound(const Quantities<Bounded<double>>& q, PointNumbers asked, bool zeros_told = false) {
    Largest largest;
    list<Bounded<double>>(q, [&](const char* name, std::size_t mass, const Bounded<double>& value, const Bounded<double>& size) {
        if (value.e <= nothing || !is_asked_for(name, asked) || (zeros_told && value.x == 0 && size.x == 0)) return;
        const double relative = value.e / std::abs(size.x);
        if (relative <= largest.relative) return;
        largest = {relative <= std::numeric_limits<double>::max() ? relative : std::numeric_limits<double>::infinity(),
                   std::string(name) + (mass > 0 ? " of mass " + std::to_string(mass) : "")};
    });
    return largest;
}

// Makes zero of a number that is zero within its bound, if both are small beside the largest of its kind; counts them.
std::size_t tell_zeros(const std::vector<std::vector<Bounded<double>*>>& kind, double tolerance) {
    const auto size_of = [](const std::vector<Bounded<double>*>& parts) {
        Bounded<double> size(0);
        for (const Bounded<double>* part : parts) size = larger(size, {std::abs(part->x), part->e});
        return size;
    };
    double largest = 0;
    for (const std::vector<Bounded<double>*>& number : kind) largest = std::max(largest, size_of(number).x);
    std::size_t zeros = 0;
    for (const std::vector<Bounded<double>*>& number : kind) {
        const Bounded<double> size = size_of(number);
        if (size.e <= tolerance * size.x || !(size.x + size.e <= zero_beside * largest)) continue;
        ++zeros;
        for (Bounded<double>* part : number) *part = {0, std::abs(part->x) + part->e};
    }
    return zeros;
}

std::size_t tell_zeros(Quantities<Bounded<double>>& q, double tolerance) {
    std::vector<std::vector<Bounded<double>*>> V, U, G, x;
    for (std::size_t k = 0; k < q.V.size(); ++k) {
        V.push_back({&q.V[k].re, &q.V[k].im});
        U.push_back({&q.U[k]});
        G.push_back({&q.G[k]});
    }
    for (std::size_t k = 0; k < q.x_size.size(); ++k) {
        x.push_back({&q.x_size[k]});
        for (std::size_t n = k; n < q.x.size(); n += q.x_size.size()) x.back().insert(x.back().end(), {&q.x[n], &q.x_prime[n]});
    }
    std::size_t zeros = 0;
    for (const auto& kind : {V, U, G, x}) zeros += tell_zeros(kind, tolerance);
    return zeros;
}

// Takes a contact that does not move as one mass, which comes last, out of the lists over masses.
void take_contact_between(const System<double>& s, Quantities<Bounded<double>>& q) {
    if (!contact_moves_apart(s)) return;
    const std::size_t count = q.V.size();
    for (std::vector<Bounded<double>>* motion : {&q.x, &q.x_prime}) {
        std::size_t n = 0;
        std::erase_if(*motion, [&](const Bounded<double>&) { return ++n % count == 0; });
    }
    q.V.pop_back();
    q.U.pop_back();
    q.G.pop_back();
    if (!q.x_size.empty()) q.x_size.pop_back();
}

#if DENHARTOG_REFERENCE

using namespace reference;

// An instant, whole half-periods taken off; the motion of every second half-period is mirrored.
struct InHalfPeriod {
    Ball tau{};
    bool mirrored = false;

    explicit InHalfPeriod(const Ball& instant) {
        Ball whole;
        arb_floor(whole.a, Ball(instant / pi<Ball>()).a, ball_bits);
        if (arb_is_exact(whole.a) == 0) throw Unproved(Why::may_be_half_period);
        mirrored = arb_is_int(Ball(whole * power_of_two(-1)).a) == 0;
        tau = instant - whole * pi<Ball>();
    }
};

void add_motion(const PointInBalls& p, std::span<const double> tau, Quantities<Bounded<double>>& q) {
    const ResponsesInBalls& r = *p.responses;
    const Ball& beta = *p.scene.beta;
    const SteadyState<Ball> contact = contact_in_balls(r, beta);
    q.X_j = in_double(contact.X_j);
    q.phi_j = in_double(contact.phi_j);
    std::vector<MassResponse<Ball>> starts;
    for (std::size_t k = 0; k < r.contact(); ++k) {
        const bool is_contact = p.scene.is_the_contact(static_cast<slong>(k));
        const MassResponse<Ball>& m = starts.emplace_back(start_of_mass_in_balls(r, contact, k, is_contact));
        q.x_size.push_back(in_double(root_of_positive(m.x0 * m.x0 + m.v0 * m.v0))); // (52), also of a mass that does not move
    }
    for (const double instant : tau) {
        const InHalfPeriod at{Ball(instant)};
        for (std::size_t k = 0; k < starts.size(); ++k) {
            const Series x = displacement_in_balls(r, starts[k], beta, k, at.tau);
            q.x.push_back(in_double(at.mirrored ? -x.rate(0) : x.rate(0)));
            q.x_prime.push_back(in_double(at.mirrored ? -x.rate(1) : x.rate(1)));
        }
    }
}

Quantities<Bounded<double>> numbers_of(const PointInBalls& p, std::span<const double> tau) {
    const ResponsesInBalls& r = *p.responses;
    Quantities<Bounded<double>> q;
    for (std::size_t k = 0; k < r.contact(); ++k) {
        q.V.push_back({in_double(r.V[k].re), in_double(r.V[k].im)});
        q.U.push_back(in_double(r.U[k]));
        q.G.push_back(in_double(r.G[k]));
    }
    q.H_j = in_double(r.H);
    q.S = in_double(p.boundary->S_exact);
    q.beta_lim = in_double(p.boundary->exact);
    if (!p.scene.beta || *p.scene.beta >= p.boundary->exact) return q;
    if (!(*p.scene.beta < p.boundary->exact)) throw Unproved({Why::may_be_boundary, 0});
    add_motion(p, tau, q);
    return q;
}

// The numbers of a point by the reference, proved and rounded to double. Bits are doubled until they are accepted; `accept` may
// put zeros for some.
template <class Accept>
Tried<QuantitiesAnswer> quantities_by_reference(const SceneSource& source, std::span<const double> tau, const Accept& accept) {
    constexpr slong first = 192, most = 1024;
    return with_more_bits(source, first, most, [&](const SceneSource& paid, slong bits, bool) {
        std::optional<QuantitiesAnswer> answer(std::in_place);
        answer->numbers = numbers_of(point_in_balls(paid, true), tau);
        answer->method = {"closed form", "reference", {Why::proved, bits}};
        answer->method.proved = true;
        if (!accept(answer->numbers)) answer.reset();
        return answer;
    });
}

#else

template <class Accept>
Tried<QuantitiesAnswer> quantities_by_reference(const SceneSource&, std::span<const double>, const Accept&) {
    return {Outcome::digits_missing, Why::no_reference};
}

#endif

} // namespace

QuantitiesAnswer quantities(const SceneSource& asked_source, std::span<const double> tau, int digits, PointNumbers asked,
                            std::shared_ptr<const ModalBasis<Bounded<double>>> basis) {
    if (digits < 1 || digits > most_digits_of_quantities)
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits_of_quantities), std::to_string(digits));
    const ScenePaidFor paid(asked == PointNumbers::sums ? without_friction_ratio(asked_source) : asked_source);
    const SceneSource& source = paid.source();
    const Scene<double>& scene = source->in_double();
    check(scene);
    (void)frequency_ratio_of(scene);
    if (asked != PointNumbers::sums) (void)friction_ratio_of(scene);
    if (!tau.empty()) check_samples("the number of instants tau", tau.size(), number_of_masses(scene.system));
    for (const double instant : tau)
        if (!std::isfinite(instant)) throw InputError("tau", "must be finite", number_to_text(instant));
    const Aim aim = aim_of(digits);
    Refusal none; // of double
    Reasons why;
    if (digits <= most_digits_in_double) {
        Tried<Quantities<Bounded<double>>> seen = tried([&] {
            if (!basis || load_depends_on_frequency(scene.system)) basis = modes_with_errors(scene.system, source->effort);
            return quantities_in_double(scene, bounded_sums(scene.system, *basis, as_input(*scene.r), source->effort), tau,
                                        source->effort);
        });
        if (seen.is_answered()) {
            const Largest largest = largest_bound(*seen.value, asked);
            const Bounded<double>& limit = seen.value->beta_lim;
            // A boundary that is no number in double is open as well.
            const bool open = scene.beta && !(std::abs(limit.x - *scene.beta) > limit.e);
            why = verdict({largest.relative, !open}, aim);
            if (largest.relative <= aim.tolerance && !open) {
                take_contact_between(scene.system, *seen.value);
                return {*std::move(seen.value), {"closed form", "double", why}, largest.relative};
            }
            if (!largest.name.empty()) why.push_back({Why::of_number, {}, largest.name});
        } else if (seen.outcome != Outcome::at_a_pole && is_exhausted(source->effort)) {
            require({Outcome::budget_spent, seen.why});
        }
        none = std::move(seen);
        why = Why::in_double + why + none.why;
        count_precision_step();
    }
    bool has_zeros = false;
    double relative = 0;
    Tried<QuantitiesAnswer> proved = quantities_by_reference(source, tau, [&](Quantities<Bounded<double>>& q) {
        has_zeros = tell_zeros(q, aim.tolerance) > 0;
        relative = largest_bound(q, asked, true).relative;
        return relative <= aim.tolerance;
    });
    if (!proved.is_answered()) require(none.outcome == Outcome::at_a_pole ? none : Refusal{proved.outcome, why + proved.why});
    QuantitiesAnswer answer = *std::move(proved.value);
    answer.relative = relative;
    answer.method.why = why + answer.method.why;
    if (has_zeros) answer.method.why += Why::zeros_given;
    return answer;
}

Quantities<Bounded<double>> quantities_in_double(const Scene<double>& scene, const ModeSums<Bounded<double>>& sums,
                                                 std::span<const double> tau, Effort* effort) {
    const double instant = instant_of_largest_demand(values_of(sums), effort);
    Quantities<Bounded<double>> q =
        quantities_without_motion(sums, as_input(scene.mu), Bounded<double>(std::min(instant, pi<double>())));
    if (!scene.beta) return q;
    std::vector<Bounded<double>> instants;
    for (const double each : tau) instants.push_back(as_input(each));
    add_motion(q, sums, as_input(*scene.beta), instants);
    return q;
}

} // namespace denhartog
