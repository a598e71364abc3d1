#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/damping_json.hpp"
#include "denhartog/program/json/number_json.hpp"
#include "denhartog/program/output/table.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/solve/certain_modes.hpp"
#include "denhartog/solve/quantities.hpp"

namespace denhartog::program {
namespace {

Json pair(const Complex<double>& z, const NumberWriter& write) { return Json::array({write(z.re), write(z.im)}); }

// The sums of (33)-(35), (64) and (57) cancel far above the natural frequencies: they are taken in what precision they need.
constexpr int digits_of_sums = 10;

Json functions_json(const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    (void)frequency_ratio_of(scene);
    const NumberWriter write;
    const auto bounded = certain_modes(source, modes_in_double(source).basis);
    const ModalBasis<double> basis = values_of(*bounded);
    std::optional<ModeSums<double>> s; // none where damping couples the modes
    if (!basis.coupled())
        s = values_of(mode_sums(*bounded, scene.system.contact, scene.system.load, as_input(*scene.r),
                                certain_mode_functions(source, bounded)));
    const Quantities<Bounded<double>> q = quantities(source, {}, digits_of_sums, PointNumbers::sums).numbers;
    Json all{{"modes", Json::array()}, {"masses", Json::array()}};
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        all["modes"].push_back({{"mode", i + 1},
                                {"natural_frequency_ratio", write(basis.r_n[i])},
                                {"R", write(*scene.r / basis.r_n[i])},
                                {"zeta", write(basis.zeta[i])}});
        if (s) all["modes"].back().update({{"v", pair(s->v[i], write)}, {"u", write(s->u[i])}, {"g", write(s->g[i])}});
    }
    for (std::size_t k = 0; k < q.V.size(); ++k)
        all["masses"].push_back(
            {{"mass", k + 1}, {"V", pair({q.V[k].re.x, q.V[k].im.x}, write)}, {"U", write(q.U[k].x)}, {"G", write(q.G[k].x)}});
    all["H_j"] = write(q.H_j.x);
    all["S_j"] = {{"exact", write(q.S.x)}, {"paper", write(s ? boundary(*s, scene.mu).S_paper : q.S.x)}};
    if (const std::optional<Json> damping = damping_json(source)) all["damping"] = *damping;
    return all;
}

std::string functions_table(const Json& a) {
    std::vector<std::vector<std::string>> modes{{"mode", "r_n", "R", "zeta", "Re v", "Im v", "u", "g"}};
    for (const Json& m : a.at("modes"))
        modes.push_back({in_table(m.at("mode")), in_table(m.at("natural_frequency_ratio")), in_table(m.at("R")),
                         in_table(m.at("zeta")), m.contains("v") ? in_table(m.at("v").at(0)) : "-",
                         m.contains("v") ? in_table(m.at("v").at(1)) : "-", cell(m, "u"), cell(m, "g")});
    std::vector<std::vector<std::string>> masses{{"mass", "Re V", "Im V", "U", "G"}};
    for (const Json& m : a.at("masses"))
        masses.push_back({in_table(m.at("mass")), in_table(m.at("V").at(0)), in_table(m.at("V").at(1)), in_table(m.at("U")),
                          in_table(m.at("G"))});
    return aligned(modes) + aligned(masses) +
           aligned({{"H_j", in_table(a.at("H_j"))},
                    {"S_j exact", in_table(a.at("S_j").at("exact"))},
                    {"S_j paper", in_table(a.at("S_j").at("paper"))}}) +
           (a.contains("damping") ? damping_table(a.at("damping")) : "") + "\n";
}

std::string evaluate(const SceneText& part, const SceneOptions& options) {
    try {
        const Json answer = functions_json(source_of(part, options.damping));
        return options.json ? answer.dump() + "\n" : functions_table(answer);
    } catch (const DomainError& e) {
        throw at_a_pole(e);
    }
}

} // namespace

void add_functions_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command =
        app.add_subcommand("functions", "What the response is made of: v, u, g of each mode and V, U, G of each mass");
    const auto options = std::make_shared<SceneOptions>();
    add_scene_options(*command, *options);
    command->footer(
        "Complex numbers are pairs [real part, imaginary part]. Numbers of modes have at least 6 digits, sums over them 10;\n"
        "they are computed in 50 digits if double does not have these. beta is not needed. If the damping matrix couples\n"
        "the modes, they have no v, u and g of their own, and zeta is what the diagonal of the matrix gives.");
    command->callback([options, &status] {
        answer_scenes(
            *options, [&](const SceneText& part) { return evaluate(part, *options); }, status);
    });
}

} // namespace denhartog::program
