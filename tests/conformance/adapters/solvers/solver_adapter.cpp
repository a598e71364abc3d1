#include "tests/conformance/adapters/solvers/solver_adapter.hpp"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "conformance/question.hpp"
#include "tests/conformance/adapters/solvers/steady_motion.hpp"

namespace denhartog::tests {
namespace {

using conformance::ProtocolQuestion;
using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 6> answered = {"amplitude",        "phase",          "regime",
                                                      "stops_per_period", "stop_durations", "motion_under_force"};

/// The motion of the scene asked about last: questions about one scene follow each other.
struct Last {
    Json scene;
    SteadyMotion motion;
};

Json skip(const std::string& reason) { return {{"skip", reason}}; }

Json read_off(const SteadyMotion& motion, const Scene<double>& scene, const ProtocolQuestion& q) {
    const std::size_t k = static_cast<std::size_t>(std::max(q.mass, 1)) - 1, j = scene.system.contact.index;
    if (q.quantity == "regime") return {{"value", name(motion.regime)}};
    if (q.quantity == "amplitude") return {{"value", amplitude(motion, k, j)}};
    if (q.quantity == "motion_under_force") return {{"value", samples(motion, k, q.samples)}};
    if (q.quantity == "phase") {
        const std::optional<double> lag = phase(motion, k, j);
        return lag ? Json{{"value", *lag}} : skip("the mass does not move");
    }
    if (motion.regime == Regime::permanent_sticking) return skip("the contact rests for ever");
    if (q.quantity == "stops_per_period") return {{"value", motion.stops.size()}};
    std::vector<double> durations;
    for (const Stop& stop : motion.stops) durations.push_back(stop.end - stop.start);
    std::ranges::sort(durations);
    return {{"value", durations}};
}

// The answer of a method to a line.
Json answer_to(const nlohmann::json& object, const std::function<Json(const ProtocolQuestion&, const Scene<double>&)>& answer) {
    const auto asked = object.find("quantity");
    const auto is_asked = [&](std::string_view name) { return asked->is_string() && asked->get<std::string>() == name; };
    if (asked != object.end() && std::ranges::none_of(conformance::quantities(), [&](const auto& q) { return is_asked(q.name); }))
        return skip("not a quantity of this version of the protocol");
    const ProtocolQuestion q = conformance::question_from_json(object);
    if (!conformance::is_of_the_paper(q)) return skip("not a scene of the paper");
    const Scene<double> scene = conformance::scene_of(q);
    if (std::ranges::find(answered, q.quantity) == answered.end()) return skip("not read off an integrated motion");
    if (q.quantity == "motion_under_force" && q.samples < 1)
        throw InputError("samples", "must be positive", std::to_string(q.samples));
    return answer(q, scene);
}

Json integrated(const ProtocolQuestion& q, const Scene<double>& scene, const TimeIntegrator& integrator, Last& last) {
    if (const std::string why = integrator.declines(scene); !why.empty()) return skip(why);
    if (const Json described = conformance::question_json(q)["scene"]; described != last.scene) {
        last.motion = steady_motion(scene, integrator);
        last.scene = described;
    }
    return last.motion.why_none.empty() ? read_off(last.motion, scene, q) : skip(last.motion.why_none);
}

} // namespace

int serve(const std::string& name, const std::function<Json(const ProtocolQuestion&, const Scene<double>&)>& answer,
          std::istream& in, std::ostream& out) {
    std::string line;
    if (!std::getline(in, line) || line != "denhartog-conform 1") {
        std::cerr << "the first line must be: denhartog-conform 1\n";
        return 1;
    }
    out << "denhartog-conform 1 json " << name << std::endl;
    while (std::getline(in, line)) {
        const nlohmann::json object = nlohmann::json::parse(line, nullptr, false);
        Json reply = {{"id", object.is_object() ? object.value("id", "") : ""}};
        try {
            reply.update(answer_to(object, answer));
        } catch (const InputError& broken) {
            reply["reject"] = broken.what();
        }
        out << reply << std::endl;
    }
    return 0;
}

int serve(const TimeIntegrator& integrator, std::istream& in, std::ostream& out) {
    Last last;
    return serve(
        integrator.name,
        [&](const ProtocolQuestion& q, const Scene<double>& scene) { return integrated(q, scene, integrator, last); }, in, out);
}

int serve_at(int argc, char** argv, double setting, const std::function<TimeIntegrator(double)>& made) {
    try {
        return serve(made(argc > 1 ? positive(argv[1]) : setting), std::cin, std::cout);
    } catch (const InputError& e) {
        std::cerr << e.what() << '\n';
        return 2;
    }
}

} // namespace denhartog::tests
