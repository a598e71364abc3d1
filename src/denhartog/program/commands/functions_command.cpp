// `denhartog functions`: the functions of the paper at a point, (23), (28) and (29) of each mode and their sums, (33) to (35),
// (57) and (64), each with its bound. Read `functions_json`.
#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/solve/quantities.hpp"

namespace denhartog::program {
namespace {

Json pair(const Complex<Bounded<double>>& z, const NumberWriter& write) { return Json::array({write(z.re.x), write(z.im.x)}); }

Json bound_of(const Bounded<double>& x, const NumberWriter& write) { return write.bound_or_null(x.e); }
Json bound_of(const Complex<Bounded<double>>& z, const NumberWriter& write) {
    return write.bound_or_null(std::max(z.re.e, z.im.e));
}

// The sum of the modes' maxima, (56), each taken where the search in double finds it.
Bounded<double> sum_of_maxima(const ModeSums<Bounded<double>>& s, double mu) {
    const ModeSums<double> values = values_of(s);
    FrictionMotions y(values);
    const std::vector<double> instants = instants_of_demands(y);
    return boundary_at(s, as_input(mu), Bounded<double>(instants.front()),
                       std::vector<Bounded<double>>(instants.begin() + 1, instants.end()))
        .S_paper;
}

// The sums of (33)-(35), (64) and (57) cancel far above the natural frequencies: they are taken in what precision they need.
constexpr int digits_of_sums = 10;

Json functions_json(const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    (void)frequency_ratio_of(scene);
    const NumberWriter write;
    const auto basis = certain_modes(source, modes_in_double(source).basis);
    std::optional<ModeSums<Bounded<double>>> s; // none where damping couples the modes
    if (!basis->couples)
        s = mode_sums(*basis, contact_row(scene.system), load_rows(scene.system), as_input(*scene.r),
                      certain_mode_functions(source, basis));
    const Quantities<Bounded<double>> q = quantities(source, {}, digits_of_sums, PointNumbers::sums).numbers;
    Json all{{"modes", Json::array()}, {"masses", Json::array()}};
    for (std::size_t i = 0; i < basis->r_n.size(); ++i) {
        const Bounded<double>&r_n = basis->r_n[i], R = as_input(*scene.r) / r_n, &zeta = basis->zeta[i];
        Json mode{{"mode", i + 1}, {"natural_frequency_ratio", write(r_n.x)}, {"R", write(R.x)}, {"zeta", write(zeta.x)}};
        Json bounds{
            {"natural_frequency_ratio", bound_of(r_n, write)}, {"R", bound_of(R, write)}, {"zeta", bound_of(zeta, write)}};
        if (s) {
            mode.update({{"v", pair(s->v[i], write)}, {"u", write(s->u[i].x)}, {"g", write(s->g[i].x)}});
            bounds.update({{"v", bound_of(s->v[i], write)}, {"u", bound_of(s->u[i], write)}, {"g", bound_of(s->g[i], write)}});
        }
        mode["error_bounds"] = std::move(bounds);
        all["modes"].push_back(std::move(mode));
    }
    for (std::size_t k = 0; k < q.V.size(); ++k)
        all["masses"].push_back(
            {{"mass", k + 1},
             {"V", pair(q.V[k], write)},
             {"U", write(q.U[k].x)},
             {"G", write(q.G[k].x)},
             {"error_bounds", {{"V", bound_of(q.V[k], write)}, {"U", bound_of(q.U[k], write)}, {"G", bound_of(q.G[k], write)}}}});
    all["H_j"] = write(q.H_j.x);
    const Bounded<double> S_paper = s ? sum_of_maxima(*s, scene.mu) : q.S;
    all["S_j"] = {{"exact", write(q.S.x)}, {"paper", write(S_paper.x)}};
    all["error_bounds"] = {{"H_j", bound_of(q.H_j, write)},
                           {"S_j", {{"exact", bound_of(q.S, write)}, {"paper", bound_of(S_paper, write)}}}};
    add_damping(all, source);
    return all;
}

std::string functions_table(const Json& a) {
    Rows modes{{"mode", "r_n", "R", "zeta", "Re v", "Im v", "u", "g"}};
    for (const Json& m : a.at("modes"))
        modes.push_back({in_table(m.at("mode")), in_table(m.at("natural_frequency_ratio")), in_table(m.at("R")),
                         in_table(m.at("zeta")), m.contains("v") ? in_table(m.at("v").at(0)) : "-",
                         m.contains("v") ? in_table(m.at("v").at(1)) : "-", cell(m, "u"), cell(m, "g")});
    Rows masses{{"mass", "Re V", "Im V", "U", "G"}};
    for (const Json& m : a.at("masses"))
        masses.push_back({in_table(m.at("mass")), in_table(m.at("V").at(0)), in_table(m.at("V").at(1)), in_table(m.at("U")),
                          in_table(m.at("G"))});
    return aligned(modes) + aligned(masses) +
           aligned({{"H_j", in_table(a.at("H_j"))},
                    {"S_j exact", in_table(a.at("S_j").at("exact"))},
                    {"S_j paper", in_table(a.at("S_j").at("paper"))}}) +
           damping_line(a) + "\n";
}

std::string evaluate(const SceneText& part, const SceneOptions& options, Effort* effort) {
    const Json answer = functions_json(source_of(part, options.damping, effort));
    return options.json ? answer.dump() + "\n" : functions_table(answer);
}

} // namespace

void add_functions_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command =
        app.add_subcommand("functions", "What the response is made of: v, u, g of each mode and V, U, G of each mass");
    const auto options = std::make_shared<SceneOptions>();
    add_scene_options(*command, *options);
    command->footer(
        "Complex numbers are pairs [real part, imaginary part]. Numbers of modes have at least 6 digits, sums over them 10;\n"
        "they are computed by the reference if double does not have these. error_bounds: bounds of the errors, of a complex\n"
        "number that of the part that is off by more. beta is not needed. If the damping matrix couples the modes, they have\n"
        "no v, u and g of their own, and zeta is what the diagonal of the matrix gives.");
    answer_every_scene(*command, options, status, evaluate);
}

} // namespace denhartog::program
