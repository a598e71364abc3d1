#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <concepts>
#include <memory>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/dimensional_json.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/program/output/table.hpp"
#include "denhartog/sliding/invariant_points.hpp"
#include "denhartog/solve/certain_modes.hpp"

namespace denhartog::program {
namespace {

std::string boundary_table(const Json& a) {
    const Json& b = a.at("beta_lim");
    std::string text = aligned({{"r", in_table(a.at("r"))},
                                {"mu", in_table(a.at("mu"))},
                                {"beta_lim exact", in_table(b.at("exact"))},
                                {"beta_lim paper (56)", in_table(b.at("paper"))},
                                {"beta_lim approximate (67)", in_table(b.at("approximate"))},
                                {"permanent sticking from", b.contains("sticking") ? in_table(b.at("sticking")) : "-"},
                                {"binding condition", a.at("binding_condition").get<std::string>()}});
    if (a.contains("reason")) text += a.at("reason").get<std::string>() + "\n";
    return text + "\n";
}

struct BoundaryOptions : SceneOptions {
    std::string range; ///< A:B, where invariant points are asked for; else empty
};

constexpr const char* range_name = "--invariant-points";

template <class T>
T end_of_range(const std::string& text, const std::string& range) {
    T value{};
    if (number_from_text(text, value) != NumberFault::none) throw InputError(range_name, "must be A:B, two numbers", range);
    return value;
}

// Points of a mass as they were found, and the same with their bounds.
template <class T>
struct BoundedPoints {
    InvariantPointsOfMass<T> found;
    std::vector<InvariantPoint<Bounded<T>>> points;
};

template <class T>
std::vector<BoundedPoints<T>> invariant_points_between(const System<T>& s, const ModalBasis<Bounded<T>>& basis,
                                                       const std::string& range) {
    const std::size_t colon = range.find(':');
    if (colon == std::string::npos) throw InputError(range_name, "must be A:B, two numbers", range);
    const T r_a = end_of_range<T>(range.substr(0, colon), range), r_b = end_of_range<T>(range.substr(colon + 1), range);
    std::vector<BoundedPoints<T>> all;
    for (InvariantPointsOfMass<T>& found : invariant_points(values_of(basis), s.contact, s.load, r_a, r_b)) {
        std::vector<InvariantPoint<Bounded<T>>> points = with_bounds(basis, s.contact, s.load, found);
        all.push_back({std::move(found), std::move(points)});
    }
    return all;
}

template <class T>
bool is_certain(const InvariantPoint<Bounded<T>>& p, int digits) {
    const T tolerance(tolerance_of(digits));
    const bool rests =
        !std::same_as<T, double> && p.amplitude.x == 0 && p.amplitude.e <= tolerance; // for all that 50 digits tell
    return p.r.e <= tolerance * p.r.x && (rests || p.amplitude.e <= tolerance * p.amplitude.x);
}

bool are_certain(const std::vector<BoundedPoints<double>>& masses) {
    return std::ranges::all_of(masses, [](const BoundedPoints<double>& mass) {
        return mass.found.undecided.empty() &&
               std::ranges::all_of(mass.points, [](const auto& p) { return is_certain(p, digits_by_default); });
    });
}

// A point that no signs bound is a stretch without a length in which nothing is decided.
template <class T>
Json invariant_points_json(std::vector<BoundedPoints<T>> masses, const System<T>& s, const NumberWriter& write) {
    const int digits = write.digits.value_or(digits_by_default);
    Json all = Json::array();
    put_in_order_of_masses(s.coordinates, masses);
    masses.resize(number_of_masses(s));
    for (BoundedPoints<T>& mass : masses) {
        Json points = Json::array();
        for (const InvariantPoint<Bounded<T>>& p : mass.points) {
            if (!(p.r.e < p.r.x)) {
                mass.found.undecided.push_back({p.r.x, p.r.x});
                continue;
            }
            if (!is_certain(p, digits))
                throw PrecisionError("the invariant point of mass " + std::to_string(all.size() + 1) +
                                     " at r = " + number_to_text(static_cast<double>(p.r.x)) + " has fewer than " +
                                     std::to_string(digits) + " certain digits");
            const Certified r = certified(p.r, digits), amplitude = certified(p.amplitude, digits);
            points.push_back({{"r", write(r)},
                              {"amplitude", write(amplitude)},
                              {"r_error_bound", write.bound(r.error)},
                              {"error_bound", write.bound(amplitude.error)},
                              {"kind", p.kind == InvariantPointKind::two_effects_cancel ? "87" : "U_k = 0"}});
        }
        all.push_back({{"mass", all.size() + 1}, {"points", points}});
        std::ranges::sort(mass.found.undecided, {}, &UndecidedStretch<T>::from);
        for (const UndecidedStretch<T>& u : mass.found.undecided)
            all.back()["undecided"].push_back({write(exactly(u.from, digits)), write(exactly(u.to, digits))});
    }
    return all;
}

Json invariant_points_json(const SceneSource& source, const BoundaryOptions& options, const NumberWriter& write) {
    if (!options.digits) {
        const System<double>& s = source->in_double().system;
        const auto basis = certain_modes(source, modes_in_double(source).basis);
        const auto found = invariant_points_between(s, *basis, options.range);
        if (are_certain(found)) return invariant_points_json(found, s, write);
    }
    const SceneIn<Real50> in = scene_with_modes<Real50>(source);
    return invariant_points_json(invariant_points_between(in.scene.system, *in.basis, options.range), in.scene.system, write);
}

std::string invariant_points_table(const Json& masses) {
    std::vector<std::vector<std::string>> rows{{"mass", "invariant at r", "amplitude", "where"}};
    for (const Json& mass : masses) {
        for (const Json& p : mass.at("points"))
            rows.push_back(
                {in_table(mass.at("mass")), in_table(p.at("r")), in_table(p.at("amplitude")), p.at("kind").get<std::string>()});
        if (mass.contains("undecided"))
            for (const Json& u : mass.at("undecided"))
                rows.push_back({in_table(mass.at("mass")), in_table(u[0]) + " to " + in_table(u[1]), "-", "undecided"});
    }
    return aligned(rows) + "\n";
}

std::string bound(const SceneText& part, const BoundaryOptions& options) {
    const SceneSource source = without_friction_ratio(source_of(part, options.damping));
    const NumberWriter write{options.digits};
    const Solution found = answer_or_reason(source, options.digits);
    Json answer = boundary_json(found, write);
    const std::optional<Units> units = source->in_double().units;
    if (units) answer["dimensional"] = dimensional_json(found, *units);
    if (!options.range.empty()) {
        if (options.digits.value_or(0) > 45)
            throw InputError("--digits", "must be at most 45 for invariant points", std::to_string(*options.digits));
        answer["invariant_points"] = invariant_points_json(source, options, write);
    }
    if (options.json) return answer.dump() + "\n";
    return boundary_table(answer) + (units ? dimensional_table(answer.at("dimensional")) + "\n" : "") +
           (options.range.empty() ? "" : invariant_points_table(answer.at("invariant_points")));
}

} // namespace

void add_boundary_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command =
        app.add_subcommand("boundary", "The friction ratio at which continuous sliding ends, four ways (beta is not needed)");
    const auto options = std::make_shared<BoundaryOptions>();
    add_scene_options(*command, *options);
    add_digits_option(*command, *options);
    command->add_option(
        range_name, options->range,
        "A:B lists the frequency ratios from A to B at which the amplitude of a mass does not depend on friction, (87)");
    command->footer(
        "exact: (69) with the maximum over tau of the sum over modes; paper: (69) with the sum of the modes' maxima, (56);\n"
        "approximate: (67); sticking: the smallest beta at which the contact never moves, absent if there is none.\n"
        "binding_condition: 54a, the contact would turn back within the half-period; 54b, static friction would hold it at\n"
        "the end of the half-period.\n"
        "invariant_points: the points of every mass, without damping: r, the monoharmonic amplitude (52) there at every\n"
        "friction ratio, bounds of their errors, and kind: 87, a root of (87); U_k = 0, the factor that (87) divides out.\n"
        "undecided: ranges of r in which rounding hides whether there is a point. With --digits they are computed in 50\n"
        "digits.\n"
        "dimensional: the friction forces of a scene of masses, stiffnesses and force.");
    command->callback([options, &status] {
        answer_scenes(
            *options, [&](const SceneText& part) { return bound(part, *options); }, status);
    });
}

} // namespace denhartog::program
