#include "denhartog/sliding/invariant_points.hpp"

#include <algorithm>
#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/sliding/maximum.hpp"
#include "denhartog/sliding/undamped_curves.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

using std::abs;

template <class T>
const T eps = std::numeric_limits<T>::epsilon();

constexpr int most_poles = 100'000;

/// Mode shapes at a mass, those that are rounding alone set to zero: the mass is a node of the mode.
template <class T>
std::vector<T> shapes_at(const Matrix<T>& phi, Mass k) {
    const auto row = phi.row(static_cast<Eigen::Index>(k.index));
    const T least = 16 * static_cast<int>(phi.cols()) * eps<T> * row.cwiseAbs().maxCoeff();
    std::vector<T> shapes;
    for (const T& entry : row) shapes.push_back(abs(entry) > least ? entry : T(0));
    return shapes;
}

template <class T>
std::vector<T> products(const Matrix<T>& phi, Mass a, Mass b) {
    std::vector<T> weights = shapes_at(phi, a);
    const std::vector<T> other = shapes_at(phi, b);
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] *= other[i];
    return weights;
}

/// Where a part is divided: near its middle, at a point where the function is clearly not zero.
template <class T>
T dividing_point(const TransmissibilityFunction<T>& f, const Part<T>& part) {
    for (const int sixteenths : {8, 7, 9, 6, 10}) {
        const T x = part.a + (part.b - part.a) * sixteenths / 16;
        if (f.sign(x, {}) != 0) return x;
    }
    return part.a + (part.b - part.a) / 2;
}

template <class T>
struct Zeros {
    std::vector<T> x;
    std::vector<Range<T>> undecided;
};

/// Whether it is known what a part holds; its zero, where there is one, is put down. A part that is narrow and rounding alone is
/// hidden: it is not searched any further.
template <class T>
bool is_decided(const TransmissibilityFunction<T>& f, const Part<T>& part, Zeros<T>& zeros, bool& hidden) {
    const std::optional<Factor> factor = f.factor(part);
    if (!factor) return false;
    const RangeWithRate<T> bounds = f.over(part.a, part.b, *factor);
    hidden = part.b - part.a <= part.b / 1024 && size_of(bounds.value) <= 4 * bounds.rounding &&
             f.sign(T(part.a + (part.b - part.a) / 2), *factor) == 0;
    if (certain_sign(bounds.value, T(0)) != 0) return true;
    if (certain_sign(bounds.rate, T(0)) == 0) return false;
    const int at_a = f.sign(part.a, *factor), at_b = f.sign(part.b, *factor);
    if (at_a == 0 || at_b == 0) return false;
    const std::function<T(const T&)> value = [&](const T& x) { return f.at(x, *factor); };
    if (at_a != at_b) zeros.x.push_back(bracketed_root(value, part.a, part.b, value(part.a), value(part.b)));
    return true;
}

template <class T>
void search(const TransmissibilityFunction<T>& f, const Part<T>& part, Zeros<T>& zeros, Effort& effort) {
    bool hidden = effort.exhausted();
    if (!hidden) {
        effort.spend(f.cost());
        if (is_decided(f, part, zeros, hidden)) return;
    }
    const T least = sqrt(eps<T>) / 1024 * part.b; // below it next to nothing is left of the digits of the rate
    if (hidden || part.b - part.a <= least) {
        if (!zeros.undecided.empty() && zeros.undecided.back().high >= part.a)
            zeros.undecided.back().high = part.b;
        else
            zeros.undecided.push_back({part.a, part.b});
        return;
    }
    const T middle = dividing_point(f, part);
    search(f, Part<T>{part.a, middle, part.pole_a, nullptr}, zeros, effort);
    search(f, Part<T>{middle, part.b, nullptr, part.pole_b}, zeros, effort);
}

template <class T>
Zeros<T> zeros_between(const TransmissibilityFunction<T>& f, const T& from, const T& to, Effort& effort) {
    const std::vector<Pole<T>> poles = f.poles(from, to);
    Zeros<T> zeros;
    Part<T> part{from, to, nullptr, nullptr};
    for (const Pole<T>& pole : poles) {
        part.b = pole.x;
        part.pole_b = &pole;
        if (part.b > part.a) search(f, part, zeros, effort);
        part.a = pole.x;
        part.pole_a = &pole;
    }
    part.b = to;
    part.pole_b = nullptr;
    if (part.b > part.a) search(f, part, zeros, effort);
    return zeros;
}

template <class T>
bool all_zero(const std::vector<T>& weights) {
    return std::all_of(weights.begin(), weights.end(), [](const T& w) { return w == 0; });
}

template <class T>
void check_arguments(const ModalBasis<T>& basis, Mass contact, Mass load, const T& r_a, const T& r_b) {
    const std::size_t N = basis.r_n.size();
    if (contact.index >= N) throw InputError("contact", "must be one of the masses", std::to_string(contact.index + 1));
    if (load.index >= static_cast<std::size_t>(basis.phi.rows()))
        throw InputError("load", "must be one of the masses", std::to_string(load.index + 1));
    if (!(r_a > 0) || !boost::math::isfinite(r_a))
        throw InputError("the least frequency ratio", "must be positive and finite", number_to_text(r_a));
    if (!(r_b > r_a) || !boost::math::isfinite(r_b))
        throw InputError("the largest frequency ratio", "must be above the least one, and finite", number_to_text(r_b));
    T poles(0);
    for (const T& r_n : basis.r_n) poles += r_n / r_a / 2;
    if (poles > most_poles)
        throw InputError("the least frequency ratio",
                         "must not be so small that there are more than " + std::to_string(most_poles) + " poles above it",
                         number_to_text(r_a));
}

/// The modes at a frequency ratio, without their damping.
template <class T>
class UndampedModes {
public:
    UndampedModes(const ModalBasis<Bounded<T>>& basis, const Bounded<T>& r) : basis_(basis), r_(r) {
        for (const Bounded<T>& r_n : basis.r_n) {
            R_.push_back(r / r_n);
            const auto functions = bounded_mode_functions(R_.back(), Bounded<T>(0));
            v_.push_back(functions.v);
            u_.push_back(functions.u);
        }
    }

    /// V_j U_k - 2 V_k U_j, or U_k.
    [[nodiscard]] Bounded<T> vanishing(Mass contact, Mass load, Mass k, InvariantPointKind kind) const {
        const Shapes psi_j = shapes(contact), psi_l = shapes(load), psi_k = shapes(k);
        const auto V = [&](const Shapes& psi) { return paper::complex_response_of_mass<Bounded<T>>(psi, psi_l, R_, v_).re; };
        const auto U = [&](const Shapes& psi) { return paper::damping_function_of_mass<Bounded<T>>(psi, psi_j, R_, u_); };
        if (kind == InvariantPointKind::friction_leaves_it_alone) return U(psi_k);
        return V(psi_j) * U(psi_k) - Bounded<T>(2) * (V(psi_k) * U(psi_j));
    }

private:
    using Shapes = std::vector<Bounded<T>>;

    [[nodiscard]] Shapes shapes(Mass k) const {
        Shapes psi;
        for (const Bounded<T>& phi : basis_.phi.row(static_cast<Eigen::Index>(k.index))) psi.push_back(phi / r_);
        return psi;
    }

    const ModalBasis<Bounded<T>>& basis_;
    Bounded<T> r_;
    Shapes R_, u_;
    std::vector<Complex<Bounded<T>>> v_;
};

/// Whether a mode may have a pole of V or U from a to b: R = 1/n there, n odd.
template <class T>
bool pole_between(const ModalBasis<Bounded<T>>& basis, const T& a, const T& b) {
    using std::floor;
    for (const Bounded<T>& r_n : basis.r_n)
        if (floor(T(((r_n.x + r_n.e) / a + 1) / 2)) != floor(T(((r_n.x - r_n.e) / b + 1) / 2))) return true;
    return false;
}

} // namespace

template <class T>
std::vector<InvariantPointsOfMass<T>> invariant_points(const ModalBasis<T>& basis, Mass contact, Mass load, const T& r_a,
                                                       const T& r_b, Effort* allowed) {
    check_arguments(basis, contact, load, r_a, r_b);
    SearchEffort own(default_effort(basis.r_n.size()));
    Effort& effort = allowed != nullptr ? *allowed : own;
    const T margin = 1024 * eps<T>; // a point at an end of the range is inside
    std::vector<InvariantPointsOfMass<T>> all;
    for (std::size_t k = 0; k < number_of_displacements(basis, load); ++k) {
        InvariantPointsOfMass<T> found{Mass{k}, {}, {}};
        const Weights<T> weights{products(basis.phi, contact, load), products(basis.phi, Mass{k}, load),
                                 products(basis.phi, contact, contact), products(basis.phi, Mass{k}, contact)};
        for (const InvariantPointKind kind :
             {InvariantPointKind::two_effects_cancel, InvariantPointKind::friction_leaves_it_alone}) {
            const bool by_87 = kind == InvariantPointKind::two_effects_cancel;
            if (all_zero(weights.V_j) || all_zero(weights.U_k) || (by_87 && (Mass{k} == contact || all_zero(weights.V_k))))
                continue;
            const TransmissibilityFunction<T> f(basis.r_n, weights, kind);
            const Zeros<T> zeros = zeros_between(f, T((1 - margin) / r_b), T((1 + margin) / r_a), effort);
            for (const T& x : zeros.x) {
                const T r = std::clamp(T(1 / x), r_a, r_b), amplitude = abs(undamped_response(basis.r_n, weights.V_k, r));
                if (by_87 && f.divides_by_zero(x)) continue;
                if (boost::math::isfinite(amplitude))
                    found.points.push_back({r, amplitude, kind});
                else
                    found.undecided.push_back({r, r}); // a natural frequency to the last digit: no number tells which of the two
            }
            for (const Range<T>& part : zeros.undecided)
                found.undecided.push_back({std::max(T(1 / part.high), r_a), std::min(T(1 / part.low), r_b)});
        }
        std::sort(found.points.begin(), found.points.end(), [](const auto& p, const auto& q) { return p.r < q.r; });
        std::sort(found.undecided.begin(), found.undecided.end(), [](const auto& p, const auto& q) { return p.from < q.from; });
        all.push_back(std::move(found));
    }
    return all;
}

template <class T>
InvariantPointsOfMass<Bounded<T>> with_bounds(const ModalBasis<Bounded<T>>& basis, Mass contact, Mass load,
                                              const InvariantPointsOfMass<T>& found) {
    std::vector<Bounded<T>> weights;
    for (Eigen::Index i = 0; i < basis.phi.cols(); ++i)
        weights.push_back(basis.phi(static_cast<Eigen::Index>(found.mass.index), i) *
                          basis.phi(static_cast<Eigen::Index>(load.index), i));
    InvariantPointsOfMass<Bounded<T>> all{found.mass, {}, {}};
    for (const UndecidedStretch<T>& u : found.undecided) all.undecided.push_back({Bounded<T>(u.from), Bounded<T>(u.to)});
    for (const InvariantPoint<T>& p : found.points) {
        const auto sign_at = [&](const T& r) {
            const Bounded<T> f = UndampedModes<T>(basis, Bounded<T>(r)).vanishing(contact, load, found.mass, p.kind);
            return certain_sign(Range<T>{f.x, f.x}, f.e);
        };
        bool bounded = false;
        for (T apart = 4 * std::numeric_limits<T>::epsilon(); apart < T(1) / 1024; apart = 4 * apart) {
            const T below = p.r * (1 - apart), above = p.r * (1 + apart);
            if (pole_between(basis, below, above)) break;
            if (sign_at(below) * sign_at(above) >= 0) continue;
            const Bounded<T> r(p.r, T(p.r * apart * 2)); // the ends are rounded
            const Bounded<T> V = undamped_response(basis.r_n, weights, r);
            bounded = V.e - V.e == 0;
            if (bounded)
                all.points.push_back(
                    {r, size_of_number(V.x) > V.e ? Bounded<T>(p.amplitude, V.e) : Bounded<T>(T(0), V.most()), p.kind});
            break;
        }
        if (!bounded) all.undecided.push_back({Bounded<T>(p.r), Bounded<T>(p.r)});
    }
    std::ranges::sort(all.undecided, {}, [](const auto& stretch) { return stretch.from.x; });
    return all;
}

template std::vector<InvariantPointsOfMass<double>> invariant_points(const ModalBasis<double>&, Mass, Mass, const double&,
                                                                     const double&, Effort*);
template std::vector<InvariantPointsOfMass<Real50>> invariant_points(const ModalBasis<Real50>&, Mass, Mass, const Real50&,
                                                                     const Real50&, Effort*);
template std::vector<InvariantPointsOfMass<Real100>> invariant_points(const ModalBasis<Real100>&, Mass, Mass, const Real100&,
                                                                      const Real100&, Effort*);
template InvariantPointsOfMass<Bounded<double>> with_bounds(const ModalBasis<Bounded<double>>&, Mass, Mass,
                                                            const InvariantPointsOfMass<double>&);
template InvariantPointsOfMass<Bounded<Real50>> with_bounds(const ModalBasis<Bounded<Real50>>&, Mass, Mass,
                                                            const InvariantPointsOfMass<Real50>&);
template InvariantPointsOfMass<Bounded<Real100>> with_bounds(const ModalBasis<Bounded<Real100>>&, Mass, Mass,
                                                             const InvariantPointsOfMass<Real100>&);

} // namespace denhartog
