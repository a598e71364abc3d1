#include "denhartog/solve/certain_invariant_points.hpp"

#include <algorithm>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog {
namespace {

constexpr std::size_t most_masses_of_reference = 40; // of which the reference is asked where nobody asked for digits

double number_of(const std::string& text) {
    double value{};
    if (number_from_text(text, value) != NumberFault::none) throw InputError("the range of r", "must be two numbers", text);
    return value;
}

// What double found.
struct PointsInDouble {
    std::vector<InvariantPointsOfMass<Certified>> masses;
    bool decided = true;         // whether no stretch is undecided
    std::string short_of_digits; // which point is
};

PointsInDouble points_in_double(const SceneSource& source, const RangeInText& range, const Aim& aim) {
    const System<double>& s = source->in_double().system;
    const auto basis = modes_with_errors(s);
    std::vector<InvariantPointsOfMass<Bounded<double>>> found;
    for (const InvariantPointsOfMass<double>& each :
         invariant_points(values_of(*basis), s.contact, s.load, number_of(range.from), number_of(range.to)))
        found.push_back(with_bounds(*basis, s.contact, s.load, each));
    put_in_order_of_masses(s.coordinates, found);
    found.resize(number_of_masses(s));
    PointsInDouble all;
    for (const InvariantPointsOfMass<Bounded<double>>& each : found) {
        all.masses.push_back({Mass{all.masses.size()}, {}, {}});
        InvariantPointsOfMass<Certified>& mass = all.masses.back();
        for (const InvariantPoint<Bounded<double>>& p : each.points) {
            if (!(std::max(relative_error(p.r), relative_error(p.amplitude)) <= aim.tolerance) && all.short_of_digits.empty())
                all.short_of_digits =
                    "the invariant point of mass " + std::to_string(all.masses.size()) + " at r = " + number_to_text(p.r.x);
            mass.points.push_back({certified(p.r), certified(p.amplitude), p.kind});
        }
        for (const UndecidedStretch<Bounded<double>>& u : each.undecided)
            mass.undecided.push_back({certified(u.from), certified(u.to)});
        all.decided = all.decided && each.undecided.empty();
    }
    return all;
}

} // namespace

std::vector<InvariantPointsOfMass<Certified>> certain_invariant_points(const SceneSource& source, const RangeInText& range,
                                                                       std::optional<int> digits, bool proved) {
    const Aim aim = aim_of(digits);
    const auto by_reference = [&] { return invariant_points_by_reference(source, range, aim.digits, !digits && !proved); };
    if (proved || aim.digits > most_digits_in_double) return by_reference();
    const bool may_help = has_reference() && (digits || number_of_masses(source->in_double().system) <= most_masses_of_reference);
    std::optional<PointsInDouble> found;
    try {
        found = points_in_double(source, range, aim);
        if (found->decided && found->short_of_digits.empty()) return found->masses;
    } catch (const PrecisionError&) {
        if (!may_help || QuestionEffort::exhausted()) throw;
    }
    try {
        if (may_help && !QuestionEffort::exhausted()) return by_reference();
    } catch (const PrecisionError&) { // double has the points, and lists what is undecided
        if (!found) throw;
    }
    if (!found->short_of_digits.empty())
        throw PrecisionError(found->short_of_digits + " has fewer than " + std::to_string(aim.digits) + " certain digits");
    return found->masses;
}

} // namespace denhartog
