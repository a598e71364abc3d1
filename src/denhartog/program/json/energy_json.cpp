// The energies of a motion, dissipated by friction and by dampers, as members of an answer of `solve`, in ratios and in the units
// of the scene, and as lines of a table.
#include "denhartog/program/json/energy_json.hpp"

#include <limits>
#include <utility>

#include "denhartog/scene/point_rules.hpp"

namespace denhartog::program {
namespace {

// Units of energy, force, damping and length.
struct UnitsOfEnergy {
    double energy = 1, force = 1, damping = 1, length = 1;
};

// The members in any units; in others than the answer's own the numbers are converted in double.
Json energies_json(const Energies& e, const UnitsOfEnergy& in, const NumberWriter& write) {
    Json all;
    const auto add = [&](const std::string& key, const Certified& x, double unit = 1) {
        constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
        all[key] = unit == 1 ? write(x) : write(unit * x.value);
        all[key + "_error_bound"] = write.bound(unit == 1 ? x.error : unit * (x.error + rounding * std::abs(x.value)));
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
