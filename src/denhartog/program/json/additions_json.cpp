// Members that an answer has besides those of its regime: the scene's own units, dampings, the place of rest, motions seen
// from the ground, and energies; as JSON and as lines of a table.
#include "denhartog/program/json/solution_json.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog::program {
namespace {

// The error of a number in other units; it is converted in double: units and products are rounded a few times.
double error_in(double unit, const Certified& x) {
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    return unit * (x.error + rounding * std::abs(x.value));
}

// `relative`: whether displacements are relative to what moves.
Json dimensional_json(const Solution& s, const Units& units, bool relative) {
    const NumberWriter write;
    const double omega = angular_frequency(units, s.r.value);
    const std::optional<double> beta = s.beta ? std::optional(s.beta->value) : std::nullopt;
    Json all = units_json(units, s.r.value, beta, s.mu.value);
    if (!units.force) return all;
    const double P = *units.force, length = displacement_unit(units, P);
    const auto bound = [&](double unit, const Certified& x) { return write(error_in(unit, x)); };
    const auto displacement = [&](const SolvedMass& m) {
        const Certified largest{m.amplitude.value, error_of_displacements(m)};
        return Json{{"amplitude", write(length * m.amplitude.value)}, {"error_bound", bound(length, largest)}};
    };
    if (s.limits) {
        all["friction_limit"] = {{"exact", write(P * s.limits->exact.value)}};
        if (s.limits->sticking) all["friction_limit"]["sticking"] = write(P * s.limits->sticking->value);
    }
    all["displacement_unit"] = write(length);
    for (std::size_t k = 0; k < s.masses.size(); ++k) {
        Json mass{{"mass", s.only ? s.only->index + 1 : k + 1}};
        mass.update(displacement(s.masses[k]));
        all["masses"].push_back(mass);
    }
    for (std::size_t k = 0; k < s.from_ground.size() && relative; ++k) {
        const Certified& X = s.from_ground[k].amplitude;
        all["masses"][k].update({{"absolute_amplitude", write(length * X.value)}, {"absolute_error_bound", bound(length, X)}});
    }
    if (s.between) {
        all["contact"] = contact_name(s);
        all["contact"].update(displacement(*s.between));
    }
    for (const SolvedStop& stop : s.stops)
        all["stops"].push_back({{"start", write(stop.start.value / omega)},
                                {"end", write(stop.end.value / omega)},
                                {"x", write(length * stop.x.value)},
                                {"start_error_bound", bound(1 / omega, stop.start)},
                                {"end_error_bound", bound(1 / omega, stop.end)},
                                {"error_bound", bound(length, stop.x)}});
    if (s.rest_interval)
        all["rest_interval"] = {{"from", write(length * s.rest_interval->from.value)},
                                {"to", write(length * s.rest_interval->to.value)}};
    return all;
}

// Units of energy, force, damping and length.
struct UnitsOfEnergy {
    double energy = 1, force = 1, damping = 1, length = 1;
};

// The members in any units; in others than the answer's own the numbers are converted in double.
Json energies_json(const Energies& e, const UnitsOfEnergy& in, const NumberWriter& write) {
    Json all;
    const auto add = [&](const std::string& key, const Certified& x, double unit = 1) {
        all[key] = unit == 1 ? write(x) : write(unit * x.value);
        all[key + "_error_bound"] = write.bound(unit == 1 ? x.error : error_in(unit, x));
    };
    add("contact", e.contact, in.energy);
    add("dampers", e.dampers, in.energy);
    add("friction", e.friction, in.force);
    add("on_base", e.on_base, in.force);
    if (!e.equivalent) return all;
    const EquivalentDamping& c = *e.equivalent;
    add("equivalent_damping", c.coefficient, in.damping);
    add("equivalent_damping_ratio", c.ratio);
    const Json others = std::exchange(all, Json());
    add("contact", c.textbook_energy, in.energy);
    add("contact_off", c.textbook_energy_error);
    if (c.textbook_amplitude) {
        add("amplitude", *c.textbook_amplitude, in.length);
        add("amplitude_off", *c.textbook_amplitude_error);
    }
    const Json textbook = std::exchange(all, others);
    all["textbook"] = textbook;
    return all;
}

} // namespace

Json units_json(const Units& units, double r, const std::optional<double>& beta, double mu) {
    const NumberWriter write;
    const double omega = angular_frequency(units, r);
    Json all{{"frequency", write(omega)}, {"frequency_hz", write(omega / (2 * std::numbers::pi))}};
    if (!units.force) return all;
    const double P = *units.force;
    all["force"] = write(P);
    if (!beta) return all;
    all["friction"] = write(P * *beta);
    if (!(mu > 1)) return all;
    all["static_friction"] = write(P * *beta * mu);
    all["static_over_kinetic_friction"] = write(mu);
    return all;
}

void add_damping(Json& answer, const SceneSource& source) {
    const std::optional<CoupledDamping> damping = coupled_damping(source);
    if (!damping) return;
    const NumberWriter write;
    answer["damping"] = {{"coupling", damping->taken_in ? "taken_in" : "left_out"},
                         {"distance_from_classical", write(damping->distance_from_classical)},
                         {"largest_coupling", write(damping->largest_coupling)},
                         {"damping_ratios", Json::array()}};
    for (const double zeta : damping->damping_ratios) answer["damping"]["damping_ratios"].push_back(write(zeta));
}

std::string damping_line(const Json& answer) {
    if (!answer.contains("damping")) return "";
    const Json& damping = answer.at("damping");
    const bool taken_in = damping.at("coupling") == "taken_in";
    return "the damping matrix couples the modes, at most by " + in_table(damping.at("largest_coupling")) +
           " of the geometric mean of two diagonal coefficients: " +
           (taken_in ? "taken in" : "left out, as the paper does; without it the damping ratios nearest to the matrix count") +
           "\n";
}

void add_place_of_rest(Json& answer, const SceneSource& source) {
    const std::vector<Certified> places = place_of_rest(source);
    const NumberWriter write;
    const bool in_units = answer.contains("dimensional") && answer.at("dimensional").contains("displacement_unit");
    const double length = in_units ? answer.at("dimensional").at("displacement_unit").get<double>() : 1;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Certified& x = places[k];
        answer["place_of_rest"].push_back({{"mass", k + 1}, {"x", write(x)}, {"error_bound", write.bound(x.error)}});
        if (in_units)
            answer["dimensional"]["place_of_rest"].push_back(
                {{"mass", k + 1}, {"x", write(length * x.value)}, {"error_bound", write(error_in(length, x))}});
    }
}

std::string place_of_rest_lines(const Json& answer) {
    if (!answer.contains("place_of_rest")) return "";
    return "displacements count from the place of rest under the constant load, in units of P / k_1:\n" +
           aligned({"mass", "at", "error bound"}, answer.at("place_of_rest"), {"mass", "x", "error_bound"}) + "\n";
}

void add_dimensional(Json& answer, const SceneSource& source, const Solution& solution, const NumberWriter& write) {
    if (!solution.from_ground.empty()) {
        Json& all = answer["from_ground"] = {{"base_amplitude", write(*solution.base_amplitude)}, {"masses", Json::array()}};
        for (const MassFromGround& m : solution.from_ground) {
            Json mass{{"mass", all.at("masses").size() + 1},
                      {"amplitude", write(m.amplitude)},
                      {"transmissibility", write(m.transmissibility)}};
            if (m.phase) mass["phase"] = write(*m.phase);
            mass["error_bound"] = write.bound(m.amplitude.error);
            mass["transmissibility_error_bound"] = write.bound(m.transmissibility.error);
            if (m.phase) mass["phase_error_bound"] = write.bound(m.phase->error);
            all["masses"].push_back(std::move(mass));
        }
    }
    const char* frame = frame_of(source->in_double().system);
    if (frame != nullptr) answer["relative_to"] = frame;
    if (const std::optional<Units> units = source->in_double().units)
        answer["dimensional"] = dimensional_json(solution, *units, frame != nullptr);
}

std::string units_in_words(const Json& answer) {
    return std::string("; displacements in units of P / k_1") +
           (answer.contains("relative_to") ? ", relative to " + cell(answer, "relative_to") : "") +
           ", phases in radians behind the force\n";
}

std::string warning_line(const Json& answer) {
    return answer.contains("warning") ? "warning: " + answer.at("warning").get<std::string>() + "\n\n" : "";
}

std::string from_ground_table(const Json& answer) {
    if (!answer.contains("from_ground")) return "";
    const Json& seen = answer.at("from_ground");
    const std::string frame = answer.contains("relative_to") ? cell(answer, "relative_to") : "base";
    return "seen from the ground, where " + (frame == "base and wall" ? frame + " move" : "the " + frame + " moves") + " by " +
           cell(seen, "base_amplitude") + ":\n" +
           aligned({"mass", "amplitude", "transmissibility", "phase", "error bound", "of the phase"}, seen.at("masses"),
                   {"mass", "amplitude", "transmissibility", "phase", "error_bound", "phase_error_bound"}) +
           "\n";
}

std::string dimensional_table(const Json& answer) {
    if (!answer.contains("dimensional")) return "";
    const Json& a = answer.at("dimensional");
    Rows rows;
    for (const auto& [key, name] : {std::pair{"frequency", "frequency, radians per unit of time"},
                                    {"frequency_hz", "frequency, periods per unit of time"},
                                    {"force", "force P"},
                                    {"friction", "friction F"},
                                    {"static_friction", "static friction"},
                                    {"static_over_kinetic_friction", "mu, static over kinetic friction"}})
        if (a.contains(key)) rows.push_back({name, cell(a, key)});
    if (a.contains("friction_limit")) rows.push_back({"slides throughout below F", cell(a.at("friction_limit"), "exact")});
    std::string text = "in the units of the scene:\n" + aligned(rows);
    rows.clear();
    if (a.contains("masses"))
        for (const Json& m : a.at("masses"))
            rows.push_back({"mass " + in_table(m.at("mass")), cell(m, "amplitude"),
                            m.contains("error_bound") ? "+- " + cell(m, "error_bound") : ""});
    if (a.contains("masses") && a.at("masses").front().contains("absolute_amplitude"))
        for (const Json& m : a.at("masses"))
            rows.push_back({"mass " + in_table(m.at("mass")) + ", absolute", cell(m, "absolute_amplitude"),
                            "+- " + cell(m, "absolute_error_bound")});
    if (a.contains("contact")) {
        Json name = a.at("contact");
        name.erase("amplitude");
        rows.push_back(
            {contact_in_words(name), cell(a.at("contact"), "amplitude"), "+- " + cell(a.at("contact"), "error_bound")});
    }
    return text + aligned(rows) + "\n";
}

void add_energies(Json& answer, const SceneSource& source, const Solution& solution, const Energies& e,
                  const NumberWriter& write) {
    answer["energy"] = energies_json(e, {}, write);
    const std::optional<Units> units = source->in_double().units;
    if (!units || !units->force) return;
    const double P = *units->force, length = displacement_unit(*units, P), omega = angular_frequency(*units, solution.r.value);
    answer["dimensional"]["energy"] =
        energies_json(e, {P * length, P, P / length / (omega / solution.r.value), length}, NumberWriter{});
}

std::string energy_table(const Json& answer) {
    if (!answer.contains("energy")) return "";
    const bool in_units = answer.contains("dimensional") && answer.at("dimensional").contains("energy");
    const Json &e = answer.at("energy"), &there = in_units ? answer.at("dimensional").at("energy") : e;
    Rows rows{{"in a period of the force", "in ratios", "error bound"}};
    if (in_units) rows.front().emplace_back("in the units of the scene");
    const auto add = [&](const Json& here, const Json& scene, const std::string& key, const char* name) {
        if (!here.contains(key)) return;
        rows.push_back({name, cell(here, key.c_str()), cell(here, (key + "_error_bound").c_str())});
        if (in_units) rows.back().push_back(cell(scene, key.c_str()));
    };
    add(e, there, "contact", "energy dissipated in the contact");
    add(e, there, "dampers", "energy dissipated in the dampers");
    add(e, there, "friction", "largest friction force");
    add(e, there, "on_base", "largest force on the base");
    add(e, there, "equivalent_damping", "equivalent viscous damping of the contact");
    add(e, there, "equivalent_damping_ratio", "its damping ratio");
    if (e.contains("textbook")) {
        const Json &here = e.at("textbook"), &scene = there.at("textbook");
        add(here, scene, "contact", "textbooks: energy 4 F X");
        add(here, scene, "contact_off", "  relative error");
        add(here, scene, "amplitude", "textbooks: amplitude by that damping");
        add(here, scene, "amplitude_off", "  relative error");
    }
    return aligned(rows) + "\n";
}

} // namespace denhartog::program
