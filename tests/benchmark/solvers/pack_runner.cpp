#include "tests/benchmark/solvers/pack_runner.hpp"

#include <CLI/CLI.hpp>
#include <ctime>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/benchmark/pack_scene.hpp"
#include "tests/conformance/adapters/solvers/steady_motion.hpp"

namespace denhartog::tests {
namespace {

using Json = nlohmann::ordered_json;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Json line_of(const PackSolver& solver, const Json& s) {
    Json line{{"scene", s.at("scene")}};
    const double start = processor_seconds();
    try {
        const Ran ran = solver.solve(benchmark::scene_of(benchmark::pack_scene(s)));
        line["seconds"] = processor_seconds() - start;
        for (const std::vector<double>& x : ran.x) line["x"].push_back(x.empty() ? Json() : Json(x));
        if (ran.stops) {
            line["stops"] = Json::array();
            for (const auto& stop : *ran.stops)
                line["stops"].push_back({stop[0] / s.at("omega").get<double>(), stop[1] / s.at("omega").get<double>()});
        }
    } catch (const std::exception& e) {
        line = Json{{"scene", s.at("scene")}, {"seconds", processor_seconds() - start}, {"failure", e.what()}};
    }
    return line;
}

} // namespace

PackSolver settled(const std::string& method, const std::string& setting, TimeIntegrator integrator, double budget) {
    return {method, setting, [integrator = std::move(integrator), budget](const Scene<double>& scene) {
                if (const std::string why = integrator.declines(scene); !why.empty()) throw DomainError(why);
                TimeIntegrator watched = integrator;
                const double end = processor_seconds() + budget;
                watched.prepare = [&](const Scene<double>& s) {
                    std::vector<Stage> stages = integrator.prepare(s);
                    for (Stage& stage : stages)
                        stage.period = [period = stage.period, end](const std::vector<double>& y, int nodes) {
                            if (processor_seconds() > end) throw DomainError("not settled within the budget");
                            return period(y, nodes);
                        };
                    return stages;
                };
                const SteadyMotion motion = steady_motion(scene, watched);
                if (!motion.why_none.empty()) throw DomainError(motion.why_none);
                Ran ran;
                for (std::size_t k = 0; k < number_of_masses(scene.system); ++k)
                    ran.x.push_back(samples(motion, k, pack_instants));
                ran.stops.emplace();
                for (const Stop& stop : motion.stops) ran.stops->push_back({stop.start, stop.end});
                return ran;
            }};
}

int run_pack(int argc, char** argv, const std::function<PackSolver(const std::string& setting, double budget)>& make) {
    CLI::App app{"Runs a solver over the benchmark's pack; results to standard output"};
    std::string setting, pack;
    double budget = 10;
    std::size_t every = 1, from = 0;
    app.add_option("setting", setting, "Setting of the solver")->required();
    app.add_option("pack", pack, "scenes.json of the pack")->required()->check(CLI::ExistingFile);
    app.add_option("--budget", budget, "Processor seconds a scene")->check(CLI::PositiveNumber);
    app.add_option("--every", every, "Every how many scenes")->check(CLI::PositiveNumber);
    app.add_option("--from", from, "The first, from 0");
    CLI11_PARSE(app, argc, argv);
    try {
        const PackSolver solver = make(setting, budget);
        const Json scenes = Json::parse(std::ifstream(pack));
        std::cout << Json{{"method", solver.method}, {"setting", solver.setting}, {"budget", budget}}.dump() << std::endl;
        for (std::size_t n = from; n < scenes.size(); n += every) std::cout << line_of(solver, scenes[n]).dump() << std::endl;
        return 0;
    } catch (const std::exception& e) {
        std::cerr << e.what() << '\n';
        return 2;
    }
}

} // namespace denhartog::tests
