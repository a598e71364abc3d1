#include "denhartog/program/boundary_command.hpp"

#include <memory>

#include "denhartog/program/answer_json.hpp"
#include "denhartog/program/table.hpp"

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

std::string bound(const SceneText& part, const SceneOptions& options) {
    const SceneSource source = without_friction_ratio(scene_source(part));
    const Json answer = boundary_json(answer_or_reason(source, options.digits), NumberWriter{options.digits});
    return options.json ? answer.dump() + "\n" : boundary_table(answer);
}

} // namespace

void add_boundary_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command =
        app.add_subcommand("boundary", "The friction ratio at which continuous sliding ends, four ways (beta is not needed)");
    const auto options = std::make_shared<SceneOptions>();
    add_scene_options(*command, *options);
    add_digits_option(*command, *options);
    command->footer(
        "exact: (69) with the maximum over tau of the sum over modes; paper: (69) with the sum of the modes' maxima, (56);\n"
        "approximate: (67); sticking: the smallest beta at which the contact never moves, absent where there is none.\n"
        "binding_condition: 54a, the contact would turn back within the half-period; 54b, static friction would hold it at\n"
        "the end of the half-period.");
    command->callback([options, &status] {
        answer_scenes(
            *options, [&](const SceneText& part) { return bound(part, *options); }, status);
    });
}

} // namespace denhartog::program
