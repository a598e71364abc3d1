// The first route: the reference, every number proved.
#include <algorithm>
#include <map>
#include <memory>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/reference/orbit.hpp"
#include "denhartog/reference/sliding.hpp"
#include "tests/conformance/generator/route.hpp"

namespace denhartog::conformance::generator {

using namespace reference;

namespace {

constexpr long most_operations = 1'000'000'000'000;

// A scene whose numbers are exact; a moving base is the load that it is, to all bits.
SceneSource source_of(const ProtocolQuestion& q) {
    const auto in_balls = [scene = question_json(q).at("scene")](Scene<Ball>& out) { out = scene_from_json<Ball>(scene); };
    return std::make_shared<const SceneReader>(
        SceneReader{std::make_shared<const Scene<double>>(scene_of(q)), {}, in_balls, std::make_shared<KeptModes>()});
}

OrbitGuess guess_of(const OrbitSeen& seen) {
    const bool mirrored = seen.halves % 2 == 1;
    OrbitGuess guess{{seen.sign() * seen.phases.back().direction},
                     mirrored,
                     mirrored ? seen.halves : seen.halves / 2,
                     seen.at_rest.x,
                     seen.at_rest.x_prime,
                     {},
                     {}};
    for (const Phase& p : seen.phases) {
        guess.directions.push_back(p.direction);
        guess.events.push_back(p.start);
    }
    return guess;
}

// A scene in the bits of the moment.
class InBits {
public:
    InBits(const SceneSource& source, Regime regime, const OrbitSeen* seen, slong bits)
        : source_(source), regime_(regime), bits_(bits), point_(point_in_balls(source, false)) {
        if (seen != nullptr) guess_ = guess_of(*seen);
    }

    // The numbers of a question; none of a quantity that is not served.
    std::vector<Ball> numbers(const ProtocolQuestion& q) {
        const std::string& name = q.quantity;
        const std::size_t k = q.mass == 0 ? static_cast<std::size_t>(point_.scene.N()) : static_cast<std::size_t>(q.mass - 1);
        if (quantity(name).absolute &&
            base_motion() == BaseMotion::alone) { // displacements are absolute, and the base moves by 1
            ProtocolQuestion relative = q;
            relative.quantity = name == "absolute_phase" ? "phase" : "amplitude";
            return numbers(relative);
        }
        if (guess_) return of_orbit(q, k);
        if (name == "natural_frequency_ratios" || name == "modal_frequency_ratios" || name == "mode_shape_products")
            return of_modes(name, k);
        if (name == "beta_lim_high_frequency") return {limit_at_high_frequency(q)};
        if (name == "beta_lim_sticking") return point_.sticking ? std::vector<Ball>{*point_.sticking} : std::vector<Ball>{};
        if (regime_ == Regime::permanent_sticking) {
            const std::vector<Ball> held = of_held(q, k);
            if (!held.empty()) return held;
        }
        if (!point_.boundary) throw DomainError("an undamped mode may resonate");
        if (name == "complex_response") return {responses().V[k].re, responses().V[k].im};
        if (name == "first_damping_function") return {responses().U[k]};
        if (name == "second_damping_function") return {responses().G[k]};
        if (name == "H_j") return {responses().H};
        if (name == "S_j") return {point_.boundary->S_exact};
        if (name == "beta_lim_exact") return {point_.boundary->exact};
        if (name == "beta_lim_paper") return {point_.boundary->paper};
        if (name == "beta_lim_approximate") return {point_.boundary->approximate};
        return regime_ == Regime::continuous ? of_sliding(q, k) : std::vector<Ball>{};
    }

private:
    SceneSource source_;
    Regime regime_;
    slong bits_;
    PointInBalls point_;
    std::optional<OrbitGuess> guess_{};
    std::optional<OrbitInBalls> orbit_{}; // both when they are first needed
    std::optional<OrbitInPhases> phases_{};

    [[nodiscard]] const ResponsesInBalls& responses() const { return *point_.responses; }

    [[nodiscard]] bool is_contact(std::size_t k) const {
        const auto N = static_cast<std::size_t>(point_.scene.N());
        return k == N || point_.scene.is_the_contact(static_cast<slong>(k));
    }

    // A displacement from those of the masses; of a contact between two of them the difference.
    [[nodiscard]] Ball displacement(const BallMatrix& state, std::size_t k) const {
        const slong N = point_.scene.N();
        if (static_cast<slong>(k) < N) return state(static_cast<slong>(k));
        Ball x(0);
        for (slong n = 0; n < N; ++n) x += point_.scene.w(n) * state(n);
        return x;
    }

    template <class At>
    [[nodiscard]] std::vector<Ball> samples(const ProtocolQuestion& q, std::size_t k, const At& at) const {
        std::vector<Ball> x;
        for (int n = 0; n < q.samples; ++n) x.push_back(displacement(at(2 * n * pi<Ball>() / q.samples), k));
        return x;
    }

    // (86), times what the contact bears of the load where inertia is all that counts, over a unit force on it.
    [[nodiscard]] Ball limit_at_high_frequency(const ProtocolQuestion& q) const {
        const Ball limit = paper::friction_ratio_limit_at_high_frequency(point_.scene.mu);
        if (is_of_the_paper(q)) return limit; // j = l
        const ModesInBalls m = modes_in_balls(point_.scene);
        const auto with_contact = [&](const std::vector<Ball>& row) {
            Ball sum(0);
            for (std::size_t i = 0; i < row.size(); ++i) sum += m.at_contact()[i] * row[i];
            return sum;
        };
        const std::vector<Ball>* ahead = m.at_load_i();
        const Complex<Ball> load{with_contact(m.at_load()), ahead != nullptr ? with_contact(*ahead) : Ball(0)};
        return limit * modulus(load) / with_contact(m.at_contact());
    }

    [[nodiscard]] BaseMotion base_motion() const { return source_->scene->system.base_motion; }
    [[nodiscard]] Ball base() const { return amplitude_of_base(base_motion(), point_.scene.r).value(); }

    // The answer to a question of the motion that is seen from the ground.
    [[nodiscard]] std::vector<Ball> from_ground(const ProtocolQuestion& q, const Ball& amplitude,
                                                const std::optional<Ball>& phase) const {
        if (q.quantity == "absolute_phase") return phase ? std::vector<Ball>{*phase} : std::vector<Ball>{};
        return {q.quantity == "transmissibility" ? amplitude / base() : amplitude};
    }

    [[nodiscard]] std::vector<Ball> of_modes(const std::string& name, std::size_t k) const {
        const ModesInBalls m = modes_in_balls(point_.scene);
        std::vector<Ball> all;
        for (std::size_t i = 0; i < m.R.size(); ++i)
            all.push_back(name == "natural_frequency_ratios" ? point_.scene.r / m.R[i]
                          : name == "modal_frequency_ratios" ? m.R[i]
                                                             : m.psi[k][i] * m.at_contact()[i]);
        return all;
    }

    [[nodiscard]] std::vector<Ball> of_held(const ProtocolQuestion& q, std::size_t k) const {
        if (!point_.stuck) throw DomainError("the system may resonate with the contact held");
        const Ball reach = point_.scene.mu * *point_.scene.beta - modulus(point_.stuck->load);
        if (q.quantity == "rest_interval") return {reach * point_.stuck->compliance};
        if (quantity(q.quantity).absolute) {
            const Complex<Ball> X{point_.stuck->X[k].re + base(), point_.stuck->X[k].im};
            return from_ground(q, root_of_positive(squared_modulus(X)), wrapped_in_balls(-argument(X)));
        }
        const Complex<Ball> X = is_contact(k) ? Complex<Ball>{Ball(0), Ball(0)} : point_.stuck->X[k];
        const bool rests = X.re.is_zero() && X.im.is_zero();
        if (q.quantity == "amplitude") return {root_of_positive(squared_modulus(X))};
        if (q.quantity == "phase") return rests ? std::vector<Ball>{} : std::vector<Ball>{wrapped_in_balls(-argument(X))};
        if (q.quantity != "motion_under_force") return {};
        const auto N = point_.scene.N();
        return samples(q, k, [&](const Ball& tau) { return harmonic_in_balls(point_.stuck->X, N, tau); });
    }

    [[nodiscard]] std::vector<Ball> of_sliding(const ProtocolQuestion& q, std::size_t k) const {
        const Ball& beta = *point_.scene.beta;
        const SteadyState<Ball> contact = contact_in_balls(responses(), beta);
        if (q.quantity == "displacement" || q.quantity == "motion_under_force") {
            const SteadyState<Ball> motion = sliding_motion_in_balls(responses(), beta);
            const auto at = [&](const Ball& tau) { return state_in_balls(responses(), motion, tau); };
            if (q.quantity == "displacement") return {displacement(at(Ball(q.tau) + contact.phi_j), k)};
            return samples(q, k, at);
        }
        if (quantity(q.quantity).absolute) {
            ResponsesInBalls seen = responses();
            seen.V[k] = response_from_ground(seen.V[k], base_motion(), base());
            const MassResponse<Ball> absolute = mass_in_balls(seen, contact, k, false);
            return from_ground(q, absolute.amplitude, absolute.phase);
        }
        return numbers_of_sliding(mass_in_balls(responses(), contact, k, is_contact(k)), q.quantity);
    }

    [[nodiscard]] std::vector<Ball> of_orbit(const ProtocolQuestion& q, std::size_t k) {
        const auto scene = [&] { return damped_scene_in_balls(source_); };
        if (q.quantity == "motion_under_force") {
            if (!phases_) phases_ = orbit_in_phases(scene, *guess_, bits_);
            return samples(q, k, [&](const Ball& tau) { return phases_->at(tau); });
        }
        const bool frame_moves = base_motion() == BaseMotion::with_wall || base_motion() == BaseMotion::wall;
        if (!orbit_) orbit_ = proved_orbit(scene, *guess_, bits_, {}, false, frame_moves ? std::optional(base()) : std::nullopt);
        if (quantity(q.quantity).absolute) return from_ground(q, orbit_->from_ground[k].size, orbit_->from_ground[k].phase);
        if (q.quantity == "amplitude") return {orbit_->masses[k].size};
        if (q.quantity == "phase")
            return orbit_->masses[k].phase ? std::vector<Ball>{*orbit_->masses[k].phase} : std::vector<Ball>{};
        if (q.quantity == "stops_per_period") return {Ball(orbit_->stops.size())};
        if (q.quantity != "stop_durations") return {};
        std::vector<Ball> lengths;
        for (const StopOf<Ball>& stop : orbit_->stops) lengths.push_back(stop.end - stop.start);
        std::ranges::sort(lengths, {}, [](const Ball& x) { return static_cast<double>(x); });
        return lengths;
    }
};

// Numbers that all have the digits of T. What is zero to more than these, beside a load of one, is zero; a number that is small
// beside the largest of a list may be zero.
template <class T>
std::optional<std::vector<T>> certain(const std::vector<Ball>& numbers, bool angle) {
    Ball largest(angle ? 1 : 0);
    for (const Ball& x : numbers) largest = larger(largest, abs(x));
    const Ball tolerance = 1 / Ball::of_text("1e" + std::to_string(std::numeric_limits<T>::digits10));
    const Ball zero = tolerance * tolerance;
    std::vector<T> rounded;
    for (const Ball& x : numbers) {
        if (x.may_vanish() && radius_of(x) <= zero) {
            rounded.emplace_back(0);
            continue;
        }
        const Ball size = angle || x.may_vanish() ? largest : abs(x);
        if (!(x.finite() && radius_of(x) <= tolerance * size)) return std::nullopt;
        arf_get_mpfr(rounded.emplace_back().backend().data(), arb_midref(x.a), MPFR_RNDN);
    }
    return rounded;
}

template <class T>
class ByReference : public Route<T> {
public:
    ByReference(const ProtocolQuestion& q, Regime regime, const OrbitSeen* seen)
        : effort_(masses_of(q), most_operations), source_(with_effort(source_of(q), &effort_)), regime_(regime) {
        if (seen != nullptr) seen_ = *seen;
    }

    std::vector<T> numbers(const ProtocolQuestion& q) override {
        const auto first = static_cast<slong>(4 * std::numeric_limits<T>::digits10 + 64);
        effort_.spent = 0;
        auto found = with_more_bits(source_, first, 8 * first, [&](const SceneSource&, slong bits, bool) {
            if (!in_bits_.contains(bits)) in_bits_.try_emplace(bits, source_, regime_, seen_ ? &*seen_ : nullptr, bits);
            return certain<T>(in_bits_.at(bits).numbers(q), quantity(q.quantity).angle);
        });
        return std::move(found.required());
    }

private:
    QuestionEffort effort_;
    SceneSource source_;
    Regime regime_;
    std::optional<OrbitSeen> seen_{};
    std::map<slong, InBits> in_bits_{};
};

} // namespace

template <class T>
std::unique_ptr<Route<T>> by_reference(const ProtocolQuestion& scene, Regime regime, const OrbitSeen* seen) {
    return std::make_unique<ByReference<T>>(scene, regime, seen);
}

template std::unique_ptr<Route<Real50>> by_reference(const ProtocolQuestion&, Regime, const OrbitSeen*);
template std::unique_ptr<Route<Real100>> by_reference(const ProtocolQuestion&, Regime, const OrbitSeen*);

} // namespace denhartog::conformance::generator
