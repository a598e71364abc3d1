// A scene read from a JSON object, in ratios or in physical units, which are divided by k_1, m_1 and P, (1) to (11) and (73).
// Read `scene_from_json`, then `read_dimensional`.
#include "denhartog/scene/scene_json.hpp"

#include <algorithm>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/system.hpp"
#include "denhartog/number/ball_or_none.hpp"
#include "denhartog/scene/detail/scene_item.hpp"

namespace denhartog {
namespace {

using nlohmann::json;
using namespace scene_items;

template <class T>
void read_ratios(const json& object, Scene<T>& scene) {
    require(object, "mass_ratios", "mass_matrix");
    require(object, "stiffness_ratios", "stiffness_matrix");
    System<T>& s = scene.system;
    if (object.contains("mass_ratios")) s.mass_ratios = read_list<T>(item(object, "mass_ratios"));
    if (object.contains("mass_matrix")) s.mass_matrix = read_matrix<T>(item(object, "mass_matrix"));
    if (object.contains("stiffness_ratios")) s.stiffness_ratios = read_list<T>(item(object, "stiffness_ratios"));
    if (object.contains("stiffness_matrix")) s.stiffness_matrix = read_matrix<T>(item(object, "stiffness_matrix"));
    if (object.contains("r")) scene.r = read_number<T>(item(object, "r"));
    if (object.contains("beta")) scene.beta = read_number<T>(item(object, "beta"));
    if (object.contains("static_load")) scene.static_load = read_list<T>(item(object, "static_load"));
}

/// Masses or stiffnesses of a dimensional scene, a list for a chain or a matrix, in units of the first. Gives the first.
template <class T>
T read_in_units_of_first(const SceneItem& x, std::vector<T>& ratios, Matrix<T>& matrix) {
    if (x.value.is_array() && !x.value.empty() && x.value[0].is_array()) {
        matrix = read_matrix<T>(x);
        const T first = matrix(0, 0);
        if (!(first > 0)) x[0][0].fail("must be positive");
        matrix /= first;
        return first;
    }
    const std::vector<T> list = read_list<T>(x);
    for (std::size_t i = 0; i < list.size(); ++i)
        if (!(list[i] > 0)) x[i].fail("must be positive");
    for (const T& each : list) ratios.push_back(each / list[0]);
    return list[0];
}

/// The force that ratios are in units of: P as it is given, omega^2 times an unbalance, m_1 times the acceleration of a base that
/// moves with the wall, or k_1 times the displacement of a base or wall that moves alone. Where the frequency takes part in it, it is
/// known with that.
template <class T>
std::optional<T> read_force(const json& object, const T& m_1, const T& k_1, const std::optional<T>& omega, Units& units) {
    const bool accelerates = object.contains("base_acceleration");
    if (object.contains("unbalance")) {
        const SceneItem unbalance = item(object, "unbalance");
        for (const char* other : {"force", "base_motion", "base_displacement", "base_acceleration"})
            if (object.contains(other)) unbalance.fail(std::string("must not be given together with ") + other);
        const T U = read_positive<T>(unbalance);
        units.base = static_cast<double>(U / m_1); // P = m_1 omega^2 times that
        return omega ? std::optional(T(U * *omega * *omega)) : std::nullopt;
    }
    if (!accelerates && !object.contains("base_displacement")) {
        if (!object.contains("force")) return std::nullopt;
        const SceneItem force = item(object, "force");
        const T P = read_number<T>(force);
        if (!(P > 0))
            force.fail(P == 0 ? "must be positive, except for `denhartog integrate`, which follows the free motion from a start"
                              : "must be positive");
        return P;
    }
    const SceneItem base = item(object, accelerates ? "base_acceleration" : "base_displacement");
    if (accelerates && object.contains("base_displacement")) base.fail("must not be given together with base_displacement");
    if (object.contains("force")) base.fail("must not be given together with force");
    if (!object.contains("base_motion")) base.fail("must be given together with base_motion");
    const T amplitude = read_positive<T>(base);
    const bool with_wall = object.at("base_motion") == "with_wall";
    if (with_wall && accelerates) return T(m_1 * amplitude);
    if (!with_wall && !accelerates) return T(k_1 * amplitude);
    if (accelerates)
        units.acceleration = static_cast<double>(amplitude);
    else
        units.base = static_cast<double>(amplitude);
    if (!omega) return std::nullopt;
    if (accelerates) return T(k_1 * amplitude / (*omega * *omega));
    return T(m_1 * *omega * *omega * amplitude);
}

/// Kinetic friction, if it is given, as a force or by its coefficient; with that of static friction their ratio is mu.
template <class T>
std::optional<T> read_friction(const json& object, Scene<T>& scene) {
    if (object.contains("static_friction_coefficient")) require(object, "friction_coefficient");
    if (object.contains("friction_coefficient")) require(object, "normal_force");
    if (!object.contains("normal_force"))
        return object.contains("friction") ? std::optional(read_not_negative<T>(item(object, "friction"))) : std::nullopt;
    require(object, "friction_coefficient");
    if (object.contains("friction")) item(object, "friction").fail("must not be given together with normal_force");
    const SceneItem kinetic = item(object, "friction_coefficient");
    const T coefficient = read_not_negative<T>(kinetic);
    if (object.contains("static_friction_coefficient")) {
        const SceneItem at_rest = item(object, "static_friction_coefficient");
        if (object.contains("mu")) item(object, "mu").fail("must not be given together with static_friction_coefficient");
        if (!(coefficient > 0)) kinetic.fail("must be positive, if static_friction_coefficient is given");
        const T largest = read_positive<T>(at_rest);
        if (largest < coefficient) at_rest.fail("must not be below friction_coefficient");
        scene.mu = largest / coefficient;
    }
    return coefficient * read_not_negative<T>(item(object, "normal_force"));
}

/// Reads a dimensional scene. Gives the unit by which its damping is divided.
template <class T>
T read_dimensional(const json& object, Scene<T>& scene) {
    require(object, "masses");
    require(object, "stiffnesses");
    System<T>& s = scene.system;
    const T m_1 = read_in_units_of_first(item(object, "masses"), s.mass_ratios, s.mass_matrix);
    const T k_1 = read_in_units_of_first(item(object, "stiffnesses"), s.stiffness_ratios, s.stiffness_matrix);
    std::optional<T> omega;
    if (object.contains("frequency") && object.contains("frequency_hz"))
        item(object, "frequency_hz").fail("must not be given together with frequency");
    if (object.contains("frequency")) omega = read_positive<T>(item(object, "frequency"));
    if (object.contains("frequency_hz")) omega = 2 * pi<T>() * read_positive<T>(item(object, "frequency_hz"));
    if (omega) scene.r = paper::frequency_ratio(*omega, m_1, k_1);
    scene.units = Units{static_cast<double>(m_1), static_cast<double>(k_1), {}, {}};
    const std::optional<T> P = read_force(object, m_1, k_1, omega, *scene.units);
    if (P) scene.units->force = static_cast<double>(*P);
    if (const std::optional<T> friction = read_friction(object, scene)) {
        if (scene.units->base && !omega)
            throw InputError("frequency",
                             std::string("must be given, as the force of ") +
                                 (object.contains("unbalance") ? "an unbalance" : "a base that moves with the wall") +
                                 " depends on it",
                             "");
        if (scene.units->acceleration && !omega)
            throw InputError("frequency", "must be given, as the displacement of the base depends on it", "");
        if (!P) require(object, "force");
        scene.beta = paper::friction_ratio(*friction, *P);
    }
    if (object.contains("static_load")) {
        if (!P) require(object, scene.units->base ? "frequency" : "force");
        scene.static_load = read_list<T>(item(object, "static_load"));
        for (T& each : scene.static_load) each = each / *P;
    }
    return sqrt(k_1) * sqrt(m_1);
}

template <class T>
void read_damping(const json& object, const T& unit, System<T>& s) {
    require(object, "damping_ratios", "damping_matrix");
    if (object.contains("damping_matrix")) {
        s.damping_matrix = read_matrix<T>(item(object, "damping_matrix")) / unit;
        if (object.contains("damping_tolerance")) s.damping_tolerance = read_number<double>(item(object, "damping_tolerance"));
        return;
    }
    if (object.contains("damping_tolerance"))
        item(object, "damping_tolerance").fail("must be given together with damping_matrix");
    const SceneItem zeta = item(object, "damping_ratios");
    if (zeta.value.is_array())
        s.damping_ratios = read_list<T>(zeta);
    else if (zeta.value.is_number() || zeta.value.is_string())
        s.damping_ratios.assign(number_of_masses(s), read_number<T>(zeta));
    else
        zeta.fail("must be an array of numbers, or one number for all modes");
}

/// Any direction. The one of a mass against a wall and that of two masses against each other are read as these; of another number
/// in a string only more digits tell which one it is.
template <class T>
void read_direction(const SceneItem& contact, System<T>& s) {
    for (const auto& entry : contact.value.items())
        if (entry.key() != "direction")
            throw InputError("contact", "must have the key direction alone, a number for each mass", legible(entry.key()),
                             contact.place + pointer_step(entry.key()));
    if (contact.value.empty()) contact.fail("must have the key direction, a number for each mass");
    const SceneItem direction{contact.value.at("direction"), "direction", contact.place + "/direction"};
    const std::vector<T> w = read_list<T>(direction);
    const auto is_text = [](const json& each) { return each.is_string() && each != "0" && each != "1" && each != "-1"; };
    bool others = direction.value.is_array() ? std::ranges::any_of(direction.value, is_text) : is_text(direction.value);
    std::vector<Mass> forward, back; // masses whose entries are 1, and -1
    for (std::size_t k = 0; k < w.size(); ++k) {
        if (w[k] == T(1)) forward.push_back({k});
        if (w[k] == T(-1)) back.push_back({k});
        others = others || !(w[k] == T(0) || w[k] == T(1) || w[k] == T(-1));
    }
    if (!others && forward.size() == 1 && back.size() <= 1) {
        s.contact = forward.front();
        if (!back.empty()) s.contact_with = back.front();
        return;
    }
    const auto size = [&w](std::size_t k) { return std::abs(static_cast<double>(w[k])); };
    for (std::size_t k = 1; k < w.size(); ++k)
        if (size(k) > size(s.contact.index)) s.contact.index = k;
    s.contact_direction = w;
}

/// One mass, which rubs against a wall, two, which rub against each other, or a direction.
template <class T>
void read_contact(const json& object, System<T>& s) {
    require(object, "contact");
    const SceneItem contact = item(object, "contact");
    if (contact.value.is_object()) {
        read_direction(contact, s);
        return;
    }
    if (!contact.value.is_array()) {
        s.contact.index = read_index(contact);
        return;
    }
    if (contact.value.size() != 2)
        contact.fail(
            "must be a whole number that counts the masses from 1, or two of them, which rub against each other; a direction "
            "is {\"direction\": [..]}, a number for each mass");
    s.contact.index = read_index(contact[0]);
    s.contact_with = Mass{read_index(contact[1])};
}

BaseMotion read_base_motion(const SceneItem& base) {
    constexpr std::pair<const char*, BaseMotion> names[] = {
        {"with_wall", BaseMotion::with_wall}, {"alone", BaseMotion::alone}, {"wall", BaseMotion::wall}};
    for (const auto& [name, motion] : names)
        if (base.value == name) return motion;
    base.fail(
        "must be \"with_wall\" (base and wall move together), \"alone\" (the base moves and the wall stays) or \"wall\" (the "
        "wall moves and the base stays)");
}

/// Forces of inertia where base and wall move together. Of springs where one of them moves alone: dampers, and the inertia of
/// masses in a moving wall's frame, load them besides at a frequency, which is not known here.
template <class T>
std::vector<T> load_of_base(const System<T>& s) {
    const bool inertia = s.base_motion == BaseMotion::with_wall;
    const Matrix<T>& matrix = inertia ? s.mass_matrix : s.stiffness_matrix;
    if (matrix.size() == 0 && inertia) return s.mass_ratios;
    std::vector<T> load(matrix.size() == 0 ? number_of_masses(s) : static_cast<std::size_t>(matrix.rows()), T(0));
    if (matrix.size() == 0) load.front() = s.stiffness_ratios.front(); // the base holds mass 1 alone
    for (std::size_t k = 0; k < load.size() && matrix.size() > 0; ++k) // rows of K add up to next to nothing
        load[k] = evaluation::sum_with_rests<T>(matrix.row(static_cast<Eigen::Index>(k)));
    if (s.base_motion == BaseMotion::wall)
        for (T& each : load) each = -each;
    return load;
}

/// One loaded mass, a force on each with the phase of each, or a moving base or wall.
template <class T>
void read_load(const json& object, System<T>& s) {
    require(object, "load", "base_motion");
    if (object.contains("base_motion")) {
        if (object.contains("load_phases")) item(object, "load_phases").fail("must not be given together with base_motion");
        s.base_motion = read_base_motion(item(object, "base_motion"));
        s.load_vector = load_of_base(s);
        return;
    }
    const SceneItem load = item(object, "load");
    if (load.value.is_array())
        s.load_vector = read_list<T>(load);
    else
        s.load.index = read_index(load);
    if (!object.contains("load_phases")) return;
    const SceneItem phases = item(object, "load_phases");
    if (s.load_vector.empty()) phases.fail("must be given together with load as a list, the force on each mass");
    s.load_phases = read_list<T>(phases);
    const bool in_phase = std::ranges::all_of(s.load_phases, [](const T& theta) { return theta == T(0); });
    if (in_phase && s.load_phases.size() == s.load_vector.size()) s.load_phases.clear();
}

} // namespace

template <class T>
Scene<T> scene_from_json(const json& object) {
    SceneNames names;
    names.dimensional = check_keys(object);
    names.places = true;
    Scene<T> scene;
    T unit(1);
    if (names.dimensional)
        unit = read_dimensional(object, scene);
    else
        read_ratios(object, scene);
    read_damping(object, unit, scene.system);
    names.one_zeta = object.contains("damping_ratios") && !object.at("damping_ratios").is_array();
    read_contact(object, scene.system);
    read_load(object, scene.system);
    if (object.contains("mu")) scene.mu = read_number<T>(item(object, "mu"));
    if constexpr (!is_ball<T>) check_under_names(scene, names); // of balls the scene in double was checked
    return scene;
}

template Scene<double> scene_from_json(const json&);
#if DENHARTOG_REFERENCE
template Scene<Ball> scene_from_json(const json&);
#endif

} // namespace denhartog
