#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/scene/point_rules.hpp"

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
            contact_in_words(a.at("contact")) + "; displacements in units of P / k_1, phases in radians behind the force\n";
    return text + damping_line(a) + method_in_words(a.at("method")) + "\n";
}

std::string respond(const SceneText& part, const SceneOptions& options) {
    const SceneSource source = source_of(part, options.damping);
    (void)friction_ratio_of(source->in_double());
    const Solution found = off_poles([&] { return sliding_answer(source, options.digits, options.proved); });
    Json answer = response_json(found, NumberWriter{options.digits});
    add_damping(answer, source);
    add_dimensional(answer, source, found);
    return options.json ? answer.dump() + "\n" : response_table(answer) + dimensional_table(answer);
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
        "dimensional: the same in the units of a scene that was given by masses and stiffnesses.");
    command->callback([options, &status] {
        answer_scenes(
            *options, [&](const SceneText& part) { return respond(part, *options); }, status);
    });
}

} // namespace denhartog::program
