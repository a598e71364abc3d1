#include "denhartog/solve/quantities.hpp"

#if DENHARTOG_REFERENCE

#include "denhartog/answer/printed.hpp"
#include "denhartog/answer/reference_attempts.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/reference/sliding.hpp"

namespace denhartog {

using namespace reference;

namespace {

// An instant, whole half-periods taken off; the motion of every second half-period is mirrored.
struct InHalfPeriod {
    Ball tau{};
    bool mirrored = false;

    explicit InHalfPeriod(const Ball& instant) {
        const Ball halves = instant / pi<Ball>();
        Ball whole;
        arb_floor(whole.a, halves.a, ball_bits);
        fmpz_t n;
        fmpz_init(n);
        const bool certain = arb_get_unique_fmpz(n, whole.a) != 0;
        mirrored = fmpz_is_odd(n) != 0;
        arb_set_fmpz(whole.a, n);
        fmpz_clear(n);
        if (!certain) throw Unproved(Why::may_be_half_period);
        tau = instant - whole * pi<Ball>();
    }
};

void add_motion(const PointInBalls& p, std::span<const double> tau, Quantities<Bounded<double>>& q) {
    const ResponsesInBalls& r = *p.responses;
    const Ball& beta = *p.scene.beta;
    const SlidingContactInBalls contact = contact_in_balls(r, beta);
    q.X_j = in_double(contact.X_j);
    q.phi_j = in_double(contact.phi_j);
    std::vector<SlidingMassInBalls> starts;
    for (std::size_t k = 0; k < r.contact(); ++k) {
        const bool is_contact = p.scene.is_the_contact(static_cast<slong>(k));
        const SlidingMassInBalls& m = starts.emplace_back(start_of_mass_in_balls(r, contact, beta, k, is_contact));
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
    q.S = in_double(p.boundary->S);
    q.beta_lim = in_double(p.boundary->exact);
    if (!p.scene.beta || *p.scene.beta >= p.boundary->exact) return q;
    if (!(*p.scene.beta < p.boundary->exact)) throw Unproved({Why::may_be_boundary, 0});
    add_motion(p, tau, q);
    return q;
}

} // namespace

QuantitiesAnswer quantities_by_reference(const SceneSource& source, std::span<const double> tau,
                                         const std::function<bool(Quantities<Bounded<double>>&)>& accept) {
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

} // namespace denhartog

#else

namespace denhartog {

QuantitiesAnswer quantities_by_reference(const SceneSource&, std::span<const double>,
                                         const std::function<bool(Quantities<Bounded<double>>&)>&) {
    throw PrecisionError(Why::no_reference);
}

} // namespace denhartog
#endif
