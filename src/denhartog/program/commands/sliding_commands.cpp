// `denhartog response` and `denhartog boundary`: the response while the contact slides, (38) to (53), and the friction ratios at
// which that ends, (67), (69) and (88), with the invariant points of (87). Read `respond` and `bound`.
#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "denhartog/answer/reference.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/solve/find.hpp"

namespace denhartog::program {
namespace {

std::string response_table(const Json& a) {
    std::string text = "regime: " + a.at("regime").get<std::string>() + "\n";
    if (a.contains("reason")) text += a.at("reason").get<std::string>() + "\n";
    text += aligned({{"r", cell(a, "r")},
                     {"beta", cell(a, "beta")},
                     {"beta_lim exact", cell(a.at("beta_lim"), "exact")},
                     {"beta_lim paper (56)", cell(a.at("beta_lim"), "paper")},
                     {"beta_lim approximate (67)", cell(a.at("beta_lim"), "approximate")},
                     {"permanent sticking from", cell(a.at("beta_lim"), "sticking")}});
    if (a.contains("masses"))
        text +=
            aligned({"mass", "amplitude", "phase", "monoharmonic", "phase", "x0", "v0", "error bound"}, a.at("masses"),
                    {"mass", "amplitude", "phase", "amplitude_monoharmonic", "phase_monoharmonic", "x0", "v0", "error_bound"}) +
            contact_in_words(a.at("contact")) + units_in_words(a);
    return text + damping_line(a) + method_in_words(a.at("method")) + "\n";
}

std::string respond(const SceneText& part, const SceneOptions& options, Effort* effort) {
    const SceneSource source = source_of(part, options.damping, effort);
    (void)friction_ratio_of(source->in_double());
    const Solution found = sliding_answer(source, options.digits, options.proved);
    Json answer = response_json(found, NumberWriter{options.digits});
    add_damping(answer, source);
    add_dimensional(answer, source, found, NumberWriter{options.digits});
    add_place_of_rest(answer, source);
    const std::string warning = found.masses.empty() ? "" : warning_of(source, found);
    if (!warning.empty()) answer["warning"] = warning;
    return options.json ? answer.dump() + "\n"
                        : response_table(answer) + warning_line(answer) + place_of_rest_lines(answer) +
                              from_ground_table(answer) + dimensional_table(answer);
}

std::string boundary_table(const Json& a) {
    const Json& b = a.at("beta_lim");
    std::string text = aligned({{"r", in_table(a.at("r"))},
                                {"mu", in_table(a.at("mu"))},
                                {"beta_lim exact", in_table(b.at("exact"))},
                                {"beta_lim paper (56)", in_table(b.at("paper"))},
                                {"beta_lim approximate (67)", in_table(b.at("approximate"))},
                                {"permanent sticking from", cell(b, "sticking")},
                                {"binding condition", a.at("binding_condition").get<std::string>()}});
    if (a.contains("reason")) text += a.at("reason").get<std::string>() + "\n";
    return text + "\n";
}

struct BoundaryOptions : SceneOptions {
    std::string range; ///< A:B, where invariant points are asked for; else empty
};

constexpr const char* range_name = "--invariant-points";

RangeInText range_from(const std::string& text) {
    (void)interval_from("r", text, range_name);
    const std::size_t colon = text.find(':');
    return {text.substr(0, colon), text.substr(colon + 1)};
}

Json invariant_points_json(const std::vector<InvariantPointsOfMass<Certified>>& masses, const NumberWriter& write) {
    Json all = Json::array();
    for (const InvariantPointsOfMass<Certified>& mass : masses) {
        Json points = Json::array();
        for (const InvariantPoint<Certified>& p : mass.points)
            points.push_back({{"r", write(p.r)},
                              {"amplitude", write(p.amplitude)},
                              {"r_error_bound", write.bound(p.r.error)},
                              {"error_bound", write.bound(p.amplitude.error)},
                              {"kind", p.kind == InvariantPointKind::two_effects_cancel ? "87" : "U_k = 0"}});
        all.push_back({{"mass", all.size() + 1}, {"points", points}});
        for (const UndecidedStretch<Certified>& u : mass.undecided)
            all.back()["undecided"].push_back({write(u.from), write(u.to)});
    }
    return all;
}

std::string invariant_points_table(const Json& masses) {
    Rows rows{{"mass", "invariant at r", "amplitude", "where"}};
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

std::string bound(const SceneText& part, const BoundaryOptions& options, Effort* effort) {
    const SceneSource source = without_friction_ratio(source_of(part, options.damping, effort));
    const NumberWriter write{options.digits};
    const Solution found = sliding_answer(source, options.digits, options.proved);
    Json answer = boundary_json(found, write);
    add_dimensional(answer, source, found, write);
    if (!options.range.empty())
        answer["invariant_points"] =
            invariant_points_json(invariant_points(source, range_from(options.range), options.digits), write);
    if (options.json) return answer.dump() + "\n";
    const std::string unsure = found.digits_reached ? "" : method_in_words(answer.at("method")) + "\n";
    return boundary_table(answer) + unsure + dimensional_table(answer) +
           (options.range.empty() ? "" : invariant_points_table(answer.at("invariant_points")));
}

} // namespace

void add_response_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command =
        app.add_subcommand("response", "Regime, amplitude and phase of every mass at the point (r, beta) of a scene");
    const auto options = std::make_shared<SceneOptions>();
    add_scene_options(*command, *options);
    add_digits_option(*command, *options);
    command->footer(
        "In the regimes stick_slip and permanent_sticking the answer has a reason and no amplitude; `solve` gives the motion.\n"
        "other_regimes: regimes that exist at the same point from other initial values; on_boundary: beta equals a boundary\n"
        "to the accuracy computed. error_bound is absolute and covers x0, v0 and both amplitudes of the mass: it is computed\n"
        "with the answer. A mass that does not move has no phase. Without --digits the aim is\n"
        "6 digits, and more precision is used if double does not reach them.\n"
        "dimensional: the same in the units of a scene that was given by masses and stiffnesses.\n"
        "warning: if a unit in the last place of a number of the scene changes amplitudes by more than a thousandth.");
    answer_every_scene(*command, options, status, respond);
}

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
        "undecided: ranges of r of which it is not known whether there is a point.\n"
        "dimensional: the friction forces of a scene of masses, stiffnesses and force.");
    answer_every_scene(*command, options, status, bound);
}

} // namespace denhartog::program
