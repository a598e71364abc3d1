#include "denhartog/answer/sliding_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/answer/certify.hpp"
#include "denhartog/model/modal_damping.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/sums/chain_sums.hpp"

namespace denhartog {
namespace {

constexpr int most_digits_searched_in_double = 13;

template <class T>
constexpr bool is_double = std::same_as<T, double>;

template <class T>
std::vector<Bounded<T>> as_bounded(const std::vector<T>& numbers) {
    return {numbers.begin(), numbers.end()};
}

// Instants in a wider type; the end of the half-period stays the end.
template <class T>
std::vector<T> widened(const std::vector<double>& instants) {
    std::vector<T> wide;
    for (const double tau : instants) wide.push_back(tau >= pi<double>() ? pi<T>() : T(tau));
    return wide;
}

template <class T>
Boundary<Bounded<T>> boundary_with(const ModeSums<Bounded<T>>& sums, const Bounded<T>& mu, const std::vector<T>& demands) {
    return boundary_at(sums, mu, Bounded<T>(demands.front()), std::vector<Bounded<T>>(demands.begin() + 1, demands.end()));
}

template <class T>
Attempted errors_of_boundary(const Boundary<Bounded<T>>& b) {
    // The load does not reach the contact: in 50 digits this is believed, as far as they can tell.
    if (!is_double<T> && b.exact.x == 0 && b.paper.x == 0 && b.exact.e <= 0x1p20 * unit_of<T>()) return {0};
    Attempted all{std::max({relative_error(b.exact), relative_error(b.paper), relative_error(b.approximate)})};
    if (b.sticking) all.relative = std::max(all.relative, relative_error(*b.sticking));
    return all;
}

// Far off in frequency a boundary leaves the range of a double; where modes are not told apart it has no bound.
template <class T>
bool is_finite(const Boundary<Bounded<T>>& b) {
    const T sum = b.exact.x + b.paper.x + b.approximate.x + b.exact.e;
    return sum - sum == 0;
}

// Whether two boundaries are one, to more than anybody can measure.
template <class T>
bool makes_no_difference(const Bounded<T>& a, const Bounded<T>& b) {
    return size_of_number(T(a.x - b.x)) <= a.e + b.e + T(1e-9) * size_of_number(b.x);
}

template <class T>
double error_of_masses(const SteadyState<Bounded<T>>& state, std::optional<Mass> only) {
    T largest(0);
    for (const auto& m : state.masses) largest = std::max(largest, m.amplitude.x);
    double error = 0;
    for (std::size_t k = 0; k < state.masses.size(); ++k) {
        if (only && k != only->index) continue;
        const MassResponse<Bounded<T>>& m = state.masses[k];
        const T of_mass = std::max({m.x0.e, m.v0.e, m.amplitude.e, m.amplitude_monoharmonic.e});
        // Of the one mass that is asked about double cannot tell.
        if ((!only || !is_double<T>)&&does_not_move(m.amplitude.x, of_mass, largest)) continue;
        error = std::max(
            {error, relative_error(Bounded<T>{m.amplitude.x, of_mass}), as_error(m.phase.e), as_error(m.phase_monoharmonic.e)});
    }
    return error;
}

// What the errors of the sums make of displacements over the half-period: a multiple of the errors at its start.
template <class T>
std::vector<T> errors_of_displacements(const SteadyState<Bounded<T>>& state) {
    std::vector<T> errors;
    errors.reserve(state.masses.size());
    for (const MassResponse<Bounded<T>>& m : state.masses) errors.push_back(T(4 * std::max(m.x0.e, m.v0.e)));
    return errors;
}

// The searches for instants: on values without their bounds, which are set up when the first is asked for.
template <class T>
class Searches {
public:
    explicit Searches(const ModeSums<Bounded<T>>& sums) : sums_(sums) {}

    std::vector<T> demands() {
        if (largest_at_start(sums_)) return std::vector<T>(sums_.R.size() + 1, T(0));
        return instants_of_demands(motions());
    }
    FrictionMotions<T>& motions() {
        if (!motions_) {
            values_ = values_of(sums_);
            motions_.emplace(values_);
        }
        return *motions_;
    }

private:
    const ModeSums<Bounded<T>>& sums_;
    ModeSums<T> values_;
    std::optional<FrictionMotions<T>> motions_;
};

// The point with the instants known from a search on the values of `searched`: the sums themselves, or rounded to double.
template <class T, class Searched>
SlidingPoint<T> point_at(const Scene<T>& scene, const ModeSums<Bounded<T>>& sums, const PointWish& wish,
                         const std::optional<Boundary<Bounded<T>>>& without_coupling,
                         const ModeSums<Bounded<Searched>>& searched) {
    const auto in_type = [](const std::vector<Searched>& instants) -> decltype(auto) {
        if constexpr (std::same_as<T, Searched>)
            return (instants);
        else
            return widened<T>(instants);
    };
    Searches<Searched> searches(searched);
    const std::vector<Searched> demands = searches.demands();
    SlidingPoint<T> point{boundary_with(sums, as_input(scene.mu), in_type(demands)), std::nullopt, std::nullopt};
    Boundary<Bounded<T>>& b = point.boundary;
    if constexpr (!std::same_as<T, Searched>) { // a larger value elsewhere is larger by no more than the search could tell
        const Boundary<Bounded<double>> narrow = boundary_with(searched, as_input(static_cast<double>(scene.mu)), demands);
        b.exact.e += T(narrow.exact.e);
        b.paper.e += T(narrow.paper.e);
    }
    if (without_coupling && makes_no_difference(without_coupling->exact, b.exact)) b.paper = without_coupling->paper;
    if (!is_finite(b)) throw PrecisionError("the boundary is beyond the range of the number type, or has no bound in it");
    if (wish.limits || !scene.beta) point.attempted = errors_of_boundary(b);
    if (!scene.beta) return point;
    point.regime = regime_at(b, *scene.beta);
    point.attempted.decided = !point.regime->on_boundary;
    if (point.regime->regime != Regime::continuous || !wish.motion) return point;
    const Bounded<Searched> beta = as_input(static_cast<Searched>(*scene.beta));
    SteadyState<Bounded<Searched>> known = steady_state_without_maxima(searched, beta);
    InstantsOfMaxima<Searched> maxima;
    const bool closed_form = wish.only ? *wish.only == sums.contact : known.masses.size() == 1; // which the contact has
    if (!closed_form) {
        maxima = instants_of_maxima(searches.motions(), beta.x, wish.only, errors_of_displacements(known));
        known = with_maxima(searched, std::move(known), as_bounded(maxima.instants), wish.only);
    }
    if constexpr (std::same_as<T, Searched>) {
        point.state = std::move(known);
    } else {
        point.state = steady_state_without_maxima(sums, as_input(*scene.beta));
        if (!closed_form)
            point.state = with_maxima(sums, *std::move(point.state), as_bounded(in_type(maxima.instants)), wish.only);
        for (std::size_t k = 0; k < known.masses.size(); ++k)
            if (k != sums.contact.index) point.state->masses[k].amplitude.e += T(known.masses[k].amplitude.e);
    }
    for (std::size_t k = 0; k < maxima.spreads.size(); ++k) {
        MassResponse<Bounded<T>>& m = point.state->masses[k];
        if (!(maxima.spreads[k] > 0)) continue;
        m.phase.e += T(maxima.spreads[k]);
        m.instant.e = pi<T>();
    }
    point.attempted.relative = std::max(point.attempted.relative, error_of_masses(*point.state, wish.only));
    return point;
}

// Whether modes are uncoupled and told apart in double. Those that coincide have the shapes that the damping matrix chooses.
bool are_apart(const ModalBasis<double>& basis) {
    const std::size_t N = basis.r_n.size();
    const auto tolerance = rounding_of_modes<double>(N);
    for (std::size_t i = 0; i + 1 < N; ++i)
        if (coincides_with_next(basis.r_n, i, tolerance)) return false;
    return !basis.coupled();
}

} // namespace

template <class T>
SceneIn<T> scene_with_modes(const SceneSource& source) {
    Scene<T> scene = scene_in<T>(source);
    auto basis = modes_with_errors(scene.system);
    return {std::move(scene), std::move(basis)};
}

template <class T>
std::optional<Boundary<Bounded<T>>> boundary_without_coupling(const SceneSource& source, const SceneIn<T>& in, int digits) {
    if (!in.basis->coupled()) return std::nullopt;
    try {
        if (!are_apart(modal_basis(source->in_double().system))) return std::nullopt;
        Scene<T> scene = in.scene;
        scene.beta.reset();
        scene.system.damping_matrix.resize(0, 0);
        scene.system.damping_ratios.clear();
        for (const Bounded<T>& zeta : in.basis->zeta) scene.system.damping_ratios.push_back(zeta.x);
        BoundedModes<T> modes(modes_with_errors(scene.system), as_input(*scene.r));
        return sliding_point(scene, modes, {false, true, std::nullopt, digits}).boundary;
    } catch (const DomainError&) {
    } catch (const PrecisionError&) {
    }
    return std::nullopt;
}

template <class T>
SlidingPoint<T> sliding_point(const Scene<T>& scene, BoundedModes<T>& modes, const PointWish& wish,
                              const std::optional<Boundary<Bounded<T>>>& without_coupling) {
    const ModeSums<Bounded<T>> sums = bounded_sums(scene.system, modes);
    if constexpr (!is_double<T>) {
        if (wish.digits <= most_digits_searched_in_double) {
            try {
                SlidingPoint<T> point = point_at(scene, sums, wish, without_coupling, in_double(sums));
                if (point.attempted.decided && point.attempted.relative <= tolerance_of(wish.digits)) return point;
            } catch (const DomainError&) {
            } catch (const PrecisionError&) {
            }
        }
    }
    return point_at(scene, sums, wish, without_coupling, sums);
}

template SceneIn<double> scene_with_modes(const SceneSource&);
template SceneIn<Real50> scene_with_modes(const SceneSource&);
template SceneIn<Real100> scene_with_modes(const SceneSource&);
template SlidingPoint<double> sliding_point(const Scene<double>&, BoundedModes<double>&, const PointWish&,
                                            const std::optional<Boundary<Bounded<double>>>&);
template SlidingPoint<Real50> sliding_point(const Scene<Real50>&, BoundedModes<Real50>&, const PointWish&,
                                            const std::optional<Boundary<Bounded<Real50>>>&);
template std::optional<Boundary<Bounded<Real50>>> boundary_without_coupling(const SceneSource&, const SceneIn<Real50>&, int);
template SlidingPoint<Real100> sliding_point(const Scene<Real100>&, BoundedModes<Real100>&, const PointWish&,
                                             const std::optional<Boundary<Bounded<Real100>>>&);
template std::optional<Boundary<Bounded<Real100>>> boundary_without_coupling(const SceneSource&, const SceneIn<Real100>&, int);

} // namespace denhartog
