#include "tests/conformance/generator/cases.hpp"

namespace denhartog::conformance::generator {
namespace {

std::size_t at(int mass, int other, int N) { return static_cast<std::size_t>((mass - 1) * N + other - 1); }

int masses(const Case& c) { return static_cast<int>(masses_of(c.scene)); }

int another_mass(Draw& draw, int N, int k) { return (k - 1 + draw.integer(1, N - 1)) % N + 1; }

void rub_two_masses(Draw& draw, ProtocolQuestion& q) {
    q.contact_with = another_mass(draw, static_cast<int>(masses_of(q)), q.contact);
}

// Multiples of 1/8 of both signs and zeros; never on the contact alone, which is a load of the paper.
void load_several(Draw& draw, ProtocolQuestion& q) {
    const auto N = masses_of(q);
    q.load = 0;
    for (std::size_t k = 0; k < N; ++k) q.loads.push_back(draw.integer(0, 3) == 0 ? 0 : draw.fraction(-1.5, 1.5, 8));
    q.loads[q.contact == 1 ? 1 : 0] = draw.fraction(0.125, 1, 8);
    if (q.contact_with != 0) q.loads[static_cast<std::size_t>(q.contact - 1)] += 0.0625;
}

void move_base(ProtocolQuestion& q, const std::string& how) {
    q.load = 0;
    q.base_motion = how;
    if (how == "alone") q.damping_ratios.assign(masses_of(q), 0);
}

// Multiples of 1/8 of a radian; that of the first force that is not zero is not.
void put_out_of_phase(Draw& draw, ProtocolQuestion& q) {
    for (std::size_t k = 0; k < q.loads.size(); ++k) q.load_phases.push_back(draw.fraction(-3, 3, 8));
    q.load_phases[q.contact == 1 ? 1 : 0] = draw.fraction(0.25, 2.5, 8);
}

// A base or a wall that moves, alone with its dampers or both together; the contact with the wall stays where the wall moves alone.
void move_anything(Draw& draw, ProtocolQuestion& q, int n) {
    static const char* const motions[] = {"alone", "wall", "with_wall"};
    q.load = 0;
    q.base_motion = motions[n % 3];
    if (n % 5 == 4 && q.base_motion != "wall") rub_two_masses(draw, q);
}

// A spring or a dashpot between two masses, or between one and the ground where the other is 0.
void put_between(std::vector<double>& matrix, int N, int a, int b, double strength) {
    matrix[at(a, a, N)] += strength;
    if (b == 0) return;
    matrix[at(b, b, N)] += strength;
    matrix[at(a, b, N)] -= strength;
    matrix[at(b, a, N)] -= strength;
}

// Dashpots to the ground and between neighbours, some of them missing, and one more to the ground: the modes are coupled.
void put_dashpots(Draw& draw, ProtocolQuestion& q) {
    const int N = static_cast<int>(masses_of(q));
    q.damping_ratios.clear();
    q.damping_matrix.assign(static_cast<std::size_t>(N * N), 0);
    for (int i = 1; i <= N; ++i)
        if (draw.integer(0, 2) > 0) put_between(q.damping_matrix, N, i, i - 1, draw.fraction(0.015625, 0.75, 64));
    put_between(q.damping_matrix, N, draw.integer(1, N), 0, draw.fraction(0.03125, 0.5, 64));
}

// A chain with one spring more between masses that are no neighbours, and every mass on a spring to the ground.
void put_springs(Draw& draw, ProtocolQuestion& q) {
    const int N = static_cast<int>(q.mass_ratios.size());
    q.stiffness_matrix.assign(static_cast<std::size_t>(N * N), 0);
    for (int i = 1; i <= N; ++i) {
        put_between(q.stiffness_matrix, N, i, i - 1, q.stiffness_ratios[static_cast<std::size_t>(i - 1)]);
        put_between(q.stiffness_matrix, N, i, 0, draw.fraction(0.0625, 0.5, 16));
    }
    if (N > 2) put_between(q.stiffness_matrix, N, 1, N, draw.fraction(0.125, 1, 8));
    q.stiffness_ratios.clear();
}

// Masses that pull at their neighbours, as those of finite elements do.
void spread_masses(Draw& draw, ProtocolQuestion& q) {
    const int N = static_cast<int>(q.mass_ratios.size());
    q.mass_matrix.assign(static_cast<std::size_t>(N * N), 0);
    for (int i = 1; i <= N; ++i) q.mass_matrix[at(i, i, N)] = q.mass_ratios[static_cast<std::size_t>(i - 1)];
    for (int i = 2; i <= N; ++i)
        q.mass_matrix[at(i, i - 1, N)] = q.mass_matrix[at(i - 1, i, N)] = draw.fraction(0.03125, 0.125, 32);
    q.mass_ratios.clear();
}

// The displacement of the contact, and that of a mass.
int contact_of(const Case& c) { return c.scene.contact_with != 0 ? 0 : c.scene.contact; }

void ask_of_sliding(Case& c, Draw& draw, int n) {
    c.friction = Friction::of_limit;
    c.part = draw.fraction(0.125, 0.9375, 16);
    const int N = masses(c), j = contact_of(c), k = another_mass(draw, N, c.scene.contact), other = draw.integer(1, N);
    c.asked = {ask("amplitude", j), ask("phase", j), ask("amplitude", k), ask("phase", k)};
    if (n % 3 == 0) {
        c.asked.insert(c.asked.end(), {ask("complex_response", j), ask("first_damping_function", k),
                                       ask("second_damping_function", other), ask("S_j"), ask("beta_lim_exact")});
    } else if (n % 3 == 1) {
        c.asked.insert(c.asked.end(), {ask("initial_displacement", k), ask("initial_velocity", k),
                                       ask("displacement", other, draw.fraction(0.125, 6.25, 16))});
    } else {
        c.asked.insert(c.asked.end(),
                       {ask("beta_lim_exact"), ask("beta_lim_sticking"), ask("regime"), ask("motion_under_force", k, 0, 32)});
    }
}

void ask_of_stick_slip(Case& c, Draw& draw) {
    c.tier = "should";
    c.scene.r = draw.fraction(0.25, 1.5, 32);
    c.scene.mu = 1;
    c.friction = Friction::between;
    c.part = draw.fraction(0.1875, 0.8125, 16);
    c.bits = 8;
    const int j = contact_of(c), k = another_mass(draw, masses(c), c.scene.contact);
    c.asked = {ask("amplitude", j), ask("phase", j),       ask("stops_per_period"),
               ask("amplitude", k), ask("stop_durations"), ask("motion_under_force", k, 0, 32)};
}

void ask_of_rest(Case& c, Draw& draw) {
    c.scene.r = draw.fraction(0.25, 1.5, 32);
    c.friction = Friction::of_sticking;
    c.part = draw.fraction(1.125, 3, 8);
    c.bits = 8;
    const int k = another_mass(draw, masses(c), c.scene.contact);
    c.asked = {ask("amplitude", k), ask("phase", k), ask("rest_interval"), ask("regime"), ask("beta_lim_sticking")};
}

// The motion of a mass as it is seen from the ground.
void ask_from_ground(Case& c, int k) {
    c.asked.insert(c.asked.end(), {ask("absolute_amplitude", k), ask("absolute_phase", k), ask("transmissibility", k)});
    if (c.scene.base_motion != "alone") c.asked.push_back(ask("transmissibility", c.scene.contact));
}

// Where (81) to (86) are about: low and high frequencies.
void add_limits(std::vector<Case>& cases, Draw& draw, const std::string& group, const ProtocolQuestion& scene, bool has_limit) {
    for (const double r : {0.09375, 12.5, 1000.0}) {
        Case c{.group = group, .scene = scene};
        c.scene.r = r;
        c.flags = {r < 1 ? "low-frequency" : "high-frequency"};
        c.friction = Friction::of_limit;
        c.part = draw.fraction(0.25, 0.75, 16);
        const int j = contact_of(c);
        c.asked = {ask("complex_response", j), ask("amplitude", j), ask("phase", j), ask("beta_lim_exact")};
        if (!scene.base_motion.empty()) {
            const int k = another_mass(draw, masses(c), scene.contact);
            if (r < 100) ask_from_ground(c, k); // beyond, double has too few digits
        }
        if (r > 100 && has_limit) c.asked.push_back(ask("beta_lim_high_frequency"));
        cases.push_back(c);
    }
}

template <class Change>
void add_group(std::vector<Case>& cases, const std::string& group, std::uint64_t seed, int count, const Change& change) {
    Draw draw(seed);
    for (int n = 0; n < count; ++n) {
        Case c;
        c.group = "systems-" + group;
        const int N = n < count / 2 ? 2 + n % 2 : n < 5 * count / 6 ? 3 + n % 3 : 6 + n % 3;
        c.scene = drawn_scene(draw, N, n % 3);
        change(draw, c.scene, n);
        if (n % 4 == 2)
            ask_of_stick_slip(c, draw);
        else if (n % 4 == 3)
            ask_of_rest(c, draw);
        else
            ask_of_sliding(c, draw, n / 4 * 2 + n % 4);
        if (!c.scene.stiffness_matrix.empty()) c.asked.push_back(ask("natural_frequency_ratios"));
        if (group == "ground") ask_from_ground(c, another_mass(draw, masses(c), c.scene.contact));
        cases.push_back(c);
    }
}

// A system of three masses that keeps every rule, until `breaks` has been at it.
template <class Break>
void add_rejected(std::vector<Case>& cases, const std::string& rule, const Break& breaks) {
    Case c{.group = "systems-reject", .reject = rule};
    ProtocolQuestion& q = c.scene;
    q.mass_ratios = {1, 1.5, 0.75};
    q.stiffness_ratios = {1, 0.625, 2};
    q.damping_matrix = {0.25, -0.125, 0, -0.125, 0.1875, -0.0625, 0, -0.0625, 0.0625};
    q.contact = 2;
    q.contact_with = 3;
    q.load = 0;
    q.loads = {1, 0.5, 0};
    q.r = 0.75;
    q.beta = 0.125;
    c.asked = {ask(cases.size() % 2 == 0 ? "beta_lim_exact" : "regime")};
    breaks(q);
    cases.push_back(c);
}

void add_rejections(std::vector<Case>& cases) {
    add_rejected(cases, "a mass rubs against itself", [](ProtocolQuestion& q) { q.contact_with = 2; });
    add_rejected(cases, "the second mass in contact is behind the last mass", [](ProtocolQuestion& q) { q.contact_with = 4; });
    add_rejected(cases, "the second mass in contact is before the first mass", [](ProtocolQuestion& q) { q.contact_with = -1; });
    add_rejected(cases, "a force too few", [](ProtocolQuestion& q) { q.loads.pop_back(); });
    add_rejected(cases, "a force too many", [](ProtocolQuestion& q) { q.loads.push_back(1); });
    add_rejected(cases, "no force", [](ProtocolQuestion& q) { q.loads = {0, 0, 0}; });
    add_rejected(cases, "the damping matrix is not symmetric", [](ProtocolQuestion& q) { q.damping_matrix[1] = 0; });
    add_rejected(cases, "the damping matrix is of two masses", [](ProtocolQuestion& q) {
        q.damping_matrix = {0.25, 0, 0, 0.25};
    });
    add_rejected(cases, "a base that moves alone has damping", [](ProtocolQuestion& q) {
        q.loads.clear();
        q.base_motion = "alone";
    });
    cases.back().withdrawn = true; // it broke a rule of the kit until content 8
    add_rejected(cases, "the base moves in no known way", [](ProtocolQuestion& q) {
        q.loads.clear();
        q.base_motion = "sideways";
    });
    add_rejected(cases, "the stiffness matrix is not positive definite", [](ProtocolQuestion& q) {
        q.stiffness_ratios.clear();
        q.stiffness_matrix = {1, -2, 0, -2, 1, 0, 0, 0, 1};
    });
    add_rejected(cases, "the stiffness matrix is not symmetric", [](ProtocolQuestion& q) {
        q.stiffness_ratios.clear();
        q.stiffness_matrix = {2, -1, 0, -0.5, 2, -1, 0, -1, 2};
    });
    add_rejected(cases, "the mass matrix is not positive definite", [](ProtocolQuestion& q) {
        q.mass_ratios.clear();
        q.mass_matrix = {1, 1.5, 0, 1.5, 1, 0, 0, 0, 1};
    });
    add_rejected(cases, "a phase too few", [](ProtocolQuestion& q) { q.load_phases = {0, 0.5}; });
    add_rejected(cases, "phases of a load on one mass", [](ProtocolQuestion& q) {
        q.loads.clear();
        q.load = 1;
        q.load_phases = {0.5, 0, 0};
    });
    add_rejected(cases, "phases of a base that moves", [](ProtocolQuestion& q) {
        q.loads.clear();
        q.base_motion = "alone";
        q.load_phases = {0.5, 0, 0};
    });
    add_rejected(cases, "nothing rubs against the wall that moves", [](ProtocolQuestion& q) {
        q.loads.clear();
        q.base_motion = "wall";
    });
    add_rejected(cases, "neither base nor wall moves", [](ProtocolQuestion&) {});
    cases.back().asked = {ask("transmissibility", 1)};
}

} // namespace

std::vector<Case> cases_of_systems() {
    std::vector<Case> cases;
    add_group(cases, "contact", 1, 24, [](Draw& draw, ProtocolQuestion& q, int) { rub_two_masses(draw, q); });
    add_group(cases, "load", 2, 20, [](Draw& draw, ProtocolQuestion& q, int n) {
        if (n % 5 == 4) rub_two_masses(draw, q);
        load_several(draw, q);
    });
    add_group(cases, "base", 3, 24, [](Draw& draw, ProtocolQuestion& q, int n) {
        if (n % 5 == 4) rub_two_masses(draw, q);
        move_base(q, n % 3 == 2 ? "alone" : "with_wall");
    });
    add_group(cases, "damping", 4, 32, [](Draw& draw, ProtocolQuestion& q, int n) {
        put_dashpots(draw, q);
        if (n % 5 == 3) rub_two_masses(draw, q);
        if (n % 7 == 5) load_several(draw, q);
        if (n % 7 == 6) move_base(q, "with_wall");
    });
    add_group(cases, "matrix", 5, 20, [](Draw& draw, ProtocolQuestion& q, int n) {
        put_springs(draw, q);
        if (n % 2 == 1 || n % 8 == 2) spread_masses(draw, q); // every other system, and some that stick and slip
        if (n % 3 == 1) put_dashpots(draw, q);
        if (n % 5 == 4) rub_two_masses(draw, q);
        if (n % 5 == 2) move_base(q, n % 3 == 1 ? "with_wall" : "alone");
    });
    add_rejections(cases);
    add_group(cases, "phase", 6, 16, [](Draw& draw, ProtocolQuestion& q, int n) {
        if (n % 5 == 4) rub_two_masses(draw, q);
        if (n % 3 == 1) put_dashpots(draw, q);
        load_several(draw, q);
        put_out_of_phase(draw, q);
    });
    add_group(cases, "ground", 7, 24, [](Draw& draw, ProtocolQuestion& q, int n) {
        if (n % 4 == 1 || n % 8 == 6) put_dashpots(draw, q);
        move_anything(draw, q, n);
    });
    Draw draw(8);
    ProtocolQuestion phased = drawn_scene(draw, 3, 0), alone = drawn_scene(draw, 3, 1), wall = drawn_scene(draw, 2, 1);
    load_several(draw, phased);
    phased.loads[static_cast<std::size_t>(phased.contact - 1)] = 0.75;
    put_out_of_phase(draw, phased);
    add_limits(cases, draw, "systems-phase", phased, true);
    move_anything(draw, alone, 0);
    alone.contact = 1; // the mass on the base: by inertia alone no other bears its load
    add_limits(cases, draw, "systems-ground", alone, false);
    alone.damping_ratios.clear(); // between the masses alone: the base has no dampers, and (86) a limit
    alone.damping_matrix = {0.25, -0.25, 0, -0.25, 0.375, -0.125, 0, -0.125, 0.125};
    add_limits(cases, draw, "systems-ground", alone, true);
    move_anything(draw, wall, 1);
    add_limits(cases, draw, "systems-ground", wall, false);
    move_anything(draw, wall, 2);
    add_limits(cases, draw, "systems-ground", wall, true);
    return cases;
}

} // namespace denhartog::conformance::generator
