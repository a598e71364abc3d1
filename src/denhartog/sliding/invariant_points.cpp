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
#include "denhartog/number/number_text.hpp"
#include "denhartog/search/zeros.hpp"
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

/// What is known of the zeros in a part. Where the part is narrow and rounding alone is left, its own parts are not looked at.
template <class T>
ZerosInStretch zeros_in(const TransmissibilityFunction<T>& f, const Part<T>& part) {
    const std::optional<Factor> factor = f.factor(part);
    if (!factor) return ZerosInStretch::unknown;
    const RangeWithRate<T> bounds = f.over(part.a, part.b, *factor);
    if (certain_sign(bounds.value, T(0)) != 0) return ZerosInStretch::none;
    if (certain_sign(bounds.rate, T(0)) != 0) {
        const int at_a = f.sign(part.a, *factor), at_b = f.sign(part.b, *factor);
        if (at_a != 0 && at_b != 0) return at_a == at_b ? ZerosInStretch::none : ZerosInStretch::one;
    }
    const bool hidden = part.b - part.a <= part.b / 1024 && size_of(bounds.value) <= 4 * bounds.rounding &&
                        f.sign(T(part.a + (part.b - part.a) / 2), *factor) == 0;
    return hidden ? ZerosInStretch::hidden : ZerosInStretch::unknown;
}

template <class T>
struct Zeros {
    std::vector<T> x;
    std::vector<StretchOfZeros<T>> undecided;
};

template <class T>
Zeros<T> zeros_between(const TransmissibilityFunction<T>& f, const T& from, const T& to, Effort& effort) {
    const std::vector<Pole<T>> poles = f.poles(from, to);
    const T narrow = sqrt(eps<T>) / 1024; // below it next to nothing is left of the digits of the rate
    Zeros<T> zeros;
    ZerosOnStretches<T> found;
    const auto search = [&](const Part<T>& between) {
        if (!(between.b > between.a)) return;
        const auto part_of = [&](const T& a, const T& b) {
            return Part<T>{a, b, a == between.a ? between.pole_a : nullptr, b == between.b ? between.pole_b : nullptr};
        };
        const auto look = [&](const T& a, const T& b) {
            if (effort.exhausted()) return ZerosInStretch::hidden;
            effort.spend(f.cost());
            return zeros_in(f, part_of(a, b));
        };
        find_zeros<T>({look, [&](const T& x) { return f.sign(x, {}) != 0; }}, between.a, between.b, narrow, found);
        for (const StretchOfZeros<T>& s : found.single) {
            const Factor factor = *f.factor(part_of(s.from, s.to));
            const std::function<T(const T&)> value = [&](const T& x) { return f.at(x, factor); };
            zeros.x.push_back(bracketed_root(value, s.from, s.to, value(s.from), value(s.to)));
        }
        found.single.clear();
    };
    Part<T> part{from, to, nullptr, nullptr};
    for (const Pole<T>& pole : poles) {
        part.b = pole.x;
        part.pole_b = &pole;
        search(part);
        part.a = pole.x;
        part.pole_a = &pole;
    }
    part.b = to;
    part.pole_b = nullptr;
    search(part);
    zeros.undecided = std::move(found.undecided);
    return zeros;
}

template <class T>
bool all_zero(const std::vector<T>& weights) {
    return std::all_of(weights.begin(), weights.end(), [](const T& w) { return w == 0; });
}

template <class T>
void check_arguments(const ModalBasis<T>& basis, Mass contact, Mass load, const T& r_a, const T& r_b) {
    if (contact.index >= basis.r_n.size())
        throw InputError("contact", "must be one of the masses", std::to_string(contact.index + 1));
    if (load.index >= static_cast<std::size_t>(basis.phi.rows()))
        throw InputError("load", "must be one of the masses", std::to_string(load.index + 1));
    check_range(std::vector<double>(basis.r_n.begin(), basis.r_n.end()), r_a, r_b);
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

void check_range(const std::vector<double>& r_n, double r_a, double r_b) {
    if (!(r_a > 0) || !std::isfinite(r_a))
        throw InputError("the least frequency ratio", "must be positive and finite", number_to_text(r_a));
    if (!(r_b > r_a) || !std::isfinite(r_b))
        throw InputError("the largest frequency ratio", "must be above the least one, and finite", number_to_text(r_b));
    double poles = 0;
    for (const double each : r_n) poles += each / r_a / 2;
    if (poles > most_poles)
        throw InputError("the least frequency ratio",
                         "must not be so small that there are more than " + std::to_string(most_poles) + " poles above it",
                         number_to_text(r_a));
}

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
            for (const StretchOfZeros<T>& part : zeros.undecided)
                found.undecided.push_back({std::max(T(1 / part.to), r_a), std::min(T(1 / part.from), r_b)});
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
template InvariantPointsOfMass<Bounded<double>> with_bounds(const ModalBasis<Bounded<double>>&, Mass, Mass,
                                                            const InvariantPointsOfMass<double>&);

} // namespace denhartog
