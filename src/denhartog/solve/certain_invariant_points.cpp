#include "denhartog/solve/certain_invariant_points.hpp"

#include <algorithm>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog {
namespace {

template <class T>
T number_of(const std::string& text) {
    T value{};
    if (number_from_text(text, value) != NumberFault::none) throw InputError("the range of r", "must be two numbers", text);
    return value;
}

// The error of a point, relative. That a mass rests there 50 digits tell, and double does not.
template <class T>
double error_of_point(const InvariantPoint<Bounded<T>>& p, double tolerance) {
    const bool rests = !std::same_as<T, double> && p.amplitude.x == 0 && p.amplitude.e <= tolerance;
    return std::max(relative_error(p.r), rests ? 0 : relative_error(p.amplitude));
}

} // namespace

std::vector<InvariantPointsOfMass<Certified>> certain_invariant_points(const SceneSource& source, const RangeInText& range,
                                                                       std::optional<int> digits) {
    const int most = most_digits_in(Precision::in_100_digits);
    if (digits > most)
        throw InputError("digits", "must be from 1 to " + std::to_string(most) + " for invariant points",
                         std::to_string(*digits));
    const Aim aim = aim_of(digits);
    std::vector<InvariantPointsOfMass<Certified>> masses;
    std::string short_of_digits; // which point
    const auto attempt = [&]<class T>(std::type_identity<T>) -> Attempted {
        const SceneIn<T> in = scene_with_modes<T>(source);
        const System<T>& s = in.scene.system;
        std::vector<InvariantPointsOfMass<Bounded<T>>> found;
        for (const InvariantPointsOfMass<T>& each :
             invariant_points(values_of(*in.basis), s.contact, s.load, number_of<T>(range.from), number_of<T>(range.to)))
            found.push_back(with_bounds(*in.basis, s.contact, s.load, each));
        put_in_order_of_masses(s.coordinates, found);
        found.resize(number_of_masses(s));
        Attempted attempted{0, true, "in some stretches nothing is decided"};
        masses.clear();
        short_of_digits.clear();
        for (const InvariantPointsOfMass<Bounded<T>>& each : found) {
            masses.push_back({Mass{masses.size()}, {}, {}});
            InvariantPointsOfMass<Certified>& mass = masses.back();
            for (const InvariantPoint<Bounded<T>>& p : each.points) {
                const double error = error_of_point(p, aim.tolerance);
                attempted.relative = std::max(attempted.relative, error);
                if (!(error <= aim.tolerance) && short_of_digits.empty())
                    short_of_digits = "the invariant point of mass " + std::to_string(masses.size()) +
                                      " at r = " + number_to_text(static_cast<double>(p.r.x));
                mass.points.push_back({certified(p.r, aim.digits), certified(p.amplitude, aim.digits), p.kind});
            }
            for (const UndecidedStretch<Bounded<T>>& u : each.undecided)
                mass.undecided.push_back({certified(u.from, aim.digits), certified(u.to, aim.digits)});
            attempted.decided = attempted.decided && each.undecided.empty();
        }
        return attempted;
    };
    certify(aim, attempt,
            highest_precision(aim, number_of_masses(source->in_double().system),
                              digits ? Precision::in_100_digits : Precision::in_50_digits));
    if (!short_of_digits.empty())
        throw PrecisionError(short_of_digits + " has fewer than " + std::to_string(aim.digits) + " certain digits");
    return masses;
}

} // namespace denhartog
