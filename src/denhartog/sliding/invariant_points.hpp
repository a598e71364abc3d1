/// @file
/// @brief Invariant points of the displacement transmissibilities: frequency ratios at which friction does not matter, (87).
#pragma once

#include <vector>

#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/effort.hpp"

namespace denhartog {

/// @brief Why the amplitude of a mass does not depend on the friction ratio.
enum class InvariantPointKind {
    two_effects_cancel,      ///< (87): what friction does to the mass directly and by way of the contact's phase cancel
    friction_leaves_it_alone ///< U_k = 0: a factor that (87) divides out
};

/// @brief An invariant point of a mass.
template <class T>
struct InvariantPoint {
    T r;                     ///< frequency ratio, Eq. (10)
    T amplitude;             ///< |V_k| there: the monoharmonic amplitude (52) at every friction ratio, without damping
    InvariantPointKind kind; ///< which factor vanishes
};

/// @brief A stretch of frequency ratios in which it is not known whether there is an invariant point.
template <class T>
struct UndecidedStretch {
    T from; ///< its lower end
    T to;   ///< its upper end
};

/// @brief The invariant points of a mass within a range of frequency ratios.
template <class T>
struct InvariantPointsOfMass {
    Mass mass;                                  ///< the mass, k
    std::vector<InvariantPoint<T>> points;      ///< ascending
    std::vector<UndecidedStretch<T>> undecided; ///< ascending; empty unless rounding hides the points, or the effort was spent
};

/// @brief The response of a mass without damping and without friction, (33) where every zeta_i is 0.
/// @eq{33}
/// @param r_n      natural frequency ratios
/// @param weights  products of the mode shapes at the mass and at the load, as many
/// @param r        frequency ratio, positive; none of the natural ones whose weight is not 0
/// @return         the response in units of P/k_1, negative where it is against the load
template <class T>
[[nodiscard]] T undamped_response(const std::vector<T>& r_n, const std::vector<T>& weights, const T& r) {
    T V(0);
    for (std::size_t i = 0; i < r_n.size(); ++i)
        if (ValueOf<T>::most(weights[i]) > 0) V += weights[i] / ((r_n[i] - r) * (r_n[i] + r));
    return V;
}

/// @brief Refuses a range of frequency ratios that breaks a rule.
/// @param r_n  natural frequency ratios
/// @param r_a  least frequency ratio
/// @param r_b  largest frequency ratio
/// @throws     InputError where r_a is not positive, r_b not above it, or there are more than 100000 poles above r_a
void check_range(const std::vector<double>& r_n, double r_a, double r_b);

/// @brief All invariant points of every mass, damping left out.
///
/// Over 1/r the functions V of (33) and U of (34) are sums of monotone terms between their poles \f$ r = r_{n,i}/n \f$, n odd.
/// Between two poles the stretch is halved until bounds of \f$ V_jU_k - 2V_kU_j \f$, made from its terms at the ends of the part,
/// exclude a zero, or bounds of its rate make it monotone, so that its signs at the ends tell whether there is one; next to a
/// pole the function is multiplied by what vanishes there. No point is missed, and none is found twice, but for what `undecided`
/// lists. The bounds are computed without directed rounding: sums are taken to be off by 16 N units in the last place of their
/// terms. Points of the mass in contact are those with U_j = 0. A mass that the friction force does not reach, and a contact
/// that the load does not reach, have none.
/// @eq{87}
/// @param basis    modal basis; its damping ratios are not used
/// @param contact  the mass in contact, j
/// @param load     the loaded mass, l
/// @param r_a      least frequency ratio, positive
/// @param r_b      largest frequency ratio, above r_a
/// @param effort   the work allowed; null for that of `default_effort`
/// @return         the points of every row of the shapes, N
/// @throws         InputError where j or l breaks its rule, or the range one of `check_range`
template <class T>
[[nodiscard]] std::vector<InvariantPointsOfMass<T>> invariant_points(const ModalBasis<T>& basis, Mass contact, Mass load,
                                                                     const T& r_a, const T& r_b, Effort* effort = nullptr);

/// @brief Bounds of the errors of invariant points, those of the modes among them.
///
/// The function that vanishes at a point is evaluated on numbers that carry their bounds, a little below the point and a little
/// above it. Where its signs there are certain and differ, and no pole lies between, a zero does, whatever the modes are within
/// their bounds: the distance is the bound. The bound of the amplitude is that of (33) over the same stretch.
/// @eq{33,34,87}
/// @param basis    modal basis with errors; its damping ratios are not used
/// @param contact  the mass in contact, j
/// @param load     the loaded mass, l
/// @param found    the points of a mass, of modes within these errors
/// @return         the points with bounds; one of which the signs tell nothing is an undecided stretch without a length; the
///                 amplitude of a mass that rests, as far as the bound tells, is 0
template <class T>
[[nodiscard]] InvariantPointsOfMass<Bounded<T>> with_bounds(const ModalBasis<Bounded<T>>& basis, Mass contact, Mass load,
                                                            const InvariantPointsOfMass<T>& found);

} // namespace denhartog
