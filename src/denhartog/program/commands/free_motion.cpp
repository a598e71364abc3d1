// A scene without a load, `"force": 0`, as `denhartog integrate` answers it. `unloaded_scene` gives it units in which nothing is
// rounded; the motion is followed to its last stop if no number of periods is given.
#include "denhartog/program/commands/free_motion.hpp"

#include <cmath>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/scene/json_document.hpp"

namespace denhartog::program {
namespace {

using nlohmann::json;

// The first of masses or stiffnesses, a list, a matrix or one number; null where there is none.
json first_of(const json& object, const char* key) {
    json value = object.contains(key) ? object.at(key) : json();
    while (value.is_array() && !value.empty()) value = json(value.front());
    return value;
}

bool is_positive(const std::optional<double>& x) { return x && *x > 0 && std::isfinite(*x); }

Json place_json(const Certified& x) {
    const NumberWriter write;
    return {{"x", write(x)}, {"error_bound", write.bound(x.error)}};
}

// The motion over some periods, or until the contact rests for good.
FreeDecay free_motion(const UnloadedScene& unloaded, const SceneSource& source, const State& start,
                      const std::optional<int>& periods) try {
    return free_decay(source, start, periods ? std::optional(*periods * unloaded.period) : std::nullopt);
} catch (const PrecisionError& e) {
    if (periods) throw;
    throw PrecisionError(std::string(e.what()) + "; --cycles N asks for the motion over N periods alone", e.outcome);
}

} // namespace

std::optional<UnloadedScene> unloaded_scene(const SceneText& part) {
    json object;
    try {
        object = read_json(part.text, part.line);
    } catch (const InputError&) {
        return std::nullopt; // the reader of scenes says so
    }
    if (!object.is_object() || !object.contains("force") || number_in(object.at("force")) != 0.0) return std::nullopt;
    for (const char* key : {"base_motion", "base_displacement", "base_acceleration"})
        if (object.contains(key)) throw InputError(key, "must not be given where force is 0", "", pointer_step(key));
    const json first_mass = first_of(object, "masses"), first_stiffness = first_of(object, "stiffnesses");
    const std::optional<double> m_1 = number_in(first_mass), k_1 = number_in(first_stiffness);
    if (!is_positive(m_1) || !is_positive(k_1)) return std::nullopt;
    double omega = std::sqrt(*k_1) / std::sqrt(*m_1);
    UnloadedScene unloaded{"", std::ldexp(1.0, std::ilogb(omega)), 0};
    for (const auto& [key, unit] : {std::pair{"frequency", 1.0}, std::pair{"frequency_hz", 2 * pi<double>()}}) {
        if (!object.contains(key)) continue;
        const std::optional<double> given = number_in(object.at(key));
        if (!is_positive(given)) return std::nullopt;
        omega = unit * *given;
    }
    if (object.contains("frequency") && object.contains("frequency_hz")) return std::nullopt;
    unloaded.period = 2 * pi<double>() * (unloaded.omega / omega);
    object.erase("frequency_hz");
    object["frequency"] = unloaded.omega;
    object["force"] = first_stiffness;
    if (!object.contains("load")) object["load"] = 1;
    unloaded.text = object.dump();
    return unloaded;
}

int periods_to_rest(const UnloadedScene& unloaded, const SceneSource& source, const State& start) {
    const double periods = std::ceil(free_motion(unloaded, source, start, {}).rest_from.value / unloaded.period) + 1;
    if (!(periods <= 1e6)) throw InputError("cycles", "must be given: the contact does not rest within 1e6 periods", "");
    return static_cast<int>(periods);
}

Json history_json(const MotionHistory& history, double time, double length) {
    const NumberWriter write;
    Json all{{"periods", history.periods}, {"from", write(time * history.from)}, {"stops", Json::array()}};
    for (const HistoryStop& stop : history.stops) {
        Json each{{"start", write(time * stop.start)}};
        if (stop.end) each["end"] = write(time * *stop.end);
        each["x"] = write(length * stop.x);
        all["stops"].push_back(each);
    }
    return all;
}

std::string history_table(const Json& history) {
    const Json& stops = history.at("stops");
    const std::string over = "history of " + in_table(history.at("periods")) + " periods from " + cell(history, "from") + ": ";
    if (stops.empty()) return over + "no stop\n";
    return over + "stops\n" + aligned({"start", "end", "x"}, stops, {"start", "end", "x"});
}

Json free_motion_json(const UnloadedScene& unloaded, const SceneSource& source, const State& start,
                      const std::optional<int>& periods, const std::optional<MotionHistory>& history) {
    const FreeDecay motion = free_motion(unloaded, source, start, periods);
    const System<double>& s = source->in_double().system;
    const NumberWriter write;
    const double time = 1 / unloaded.omega;
    const auto instant = [&](const Certified& tau) { return write(time * tau.value); };
    const auto instant_bound = [&](const Certified& tau) { return write.bound(time * tau.error); };
    Json all{{"load", "none"},
             {"method", "exact"},
             {"status", motion.at_rest ? "at_rest" : "in_motion"},
             {"proved", !motion.on_limit}};
    all["half_cycles"] = motion.turns.size();
    if (motion.at_rest) {
        all["rest"] = {{"from", instant(motion.rest_from)}, {"from_error_bound", instant_bound(motion.rest_from)}};
        all["rest"].update(place_json(motion.rest_at));
        if (motion.on_limit) all["rest"]["on_limit"] = true;
        if (number_of_masses(s) > 1)
            all["rest"]["others"] = !motion.others_come_to_rest   ? "not_known"
                                    : *motion.others_come_to_rest ? "come_to_rest"
                                                                  : "vibrate";
    }
    all["contact"] = contact_name(s);
    for (std::size_t k = 0; k < motion.masses.size(); ++k) { // none in motion
        Json mass{{"mass", k + 1}};
        mass.update(place_json(motion.masses[k]));
        all["masses"].push_back(mass);
    }
    all["turns"] = all["stops"] = Json::array();
    for (const DecayTurn& turn : motion.turns) {
        Json each{{"t", instant(turn.tau)}, {"t_error_bound", instant_bound(turn.tau)}};
        each.update(place_json(turn.x));
        all["turns"].push_back(each);
    }
    for (const SolvedStop& stop : motion.stops) {
        Json each{{"start", instant(stop.start)},
                  {"end", instant(stop.end)},
                  {"start_error_bound", instant_bound(stop.start)},
                  {"end_error_bound", instant_bound(stop.end)}};
        each.update(place_json(stop.x));
        all["stops"].push_back(each);
    }
    if (history) all["history"] = history_json(*history, time, 1);
    return all;
}

std::string free_motion_table(const Json& a) {
    std::string text = "free motion, in the units of the scene: ";
    if (!a.contains("rest")) {
        text += "not at rest for good by the end of these periods, after " + cell(a, "half_cycles") + " half-cycles\n";
    } else {
        const Json& rest = a.at("rest");
        text += "at rest for good from " + cell(rest, "from") + " +- " + cell(rest, "from_error_bound") + " on, after " +
                cell(a, "half_cycles") + " half-cycles\n";
        if (rest.contains("on_limit"))
            text += "  where the springs pull with static friction, to all digits: (74) lets the contact stick\n";
        const std::string others = cell(rest, "others");
        if (others == "come_to_rest") text += "  the other masses tend to their places of rest\n";
        if (others == "vibrate") text += "  the other masses vibrate about their places of rest for ever: nothing damps them\n";
        if (others == "not_known") text += "  whether the other masses come to rest is not proved\n";
        text += aligned({"mass", "place of rest", "error bound"}, a.at("masses"), {"mass", "x", "error_bound"});
    }
    if (!a.at("turns").empty())
        text += "the contact turns or comes to rest at\n" +
                aligned({"t", "error bound", "x", "error bound"}, a.at("turns"), {"t", "t_error_bound", "x", "error_bound"});
    if (!a.at("stops").empty())
        text += "it stopped before\n" +
                aligned({"from", "to", "at", "error bound"}, a.at("stops"), {"start", "end", "x", "error_bound"});
    if (a.contains("history")) text += history_table(a.at("history"));
    return text + "\n";
}

} // namespace denhartog::program
