#include <denhartog.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "denhartog/c/handles.hpp"
#include "tests/conformance/c_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr double untouched = -7.25;
constexpr std::size_t endless_count = std::numeric_limits<std::size_t>::max();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();
const std::vector<double> ones{1, 1}, damped{0.0625, 0.125};

// A call that has to fail: its code, a word of its message, and that it wrote nothing into the arrays below.
struct Faults {
    Handle system = handle_of(chain_of({1, 2.5}, {1, 0.625}, {0.0625, 0.125}, 2, 1));
    Answered sliding = solved(system.get(), 1.125, 0.125, 1.25);
    Answered stopping = solved(handle_of(chain_of({1}, {1}, {0.0625}, 1, 1)).get(), 0.25, 0.8125, 1.0);
    std::vector<double> a = std::vector<double>(8, untouched), b = a, c = a, d = a;
    dh_system* no_system = nullptr;
    dh_solution* no_solution = nullptr;

    void fails(int code, int status, const std::string& word) const {
        INFO("message: " << dh_last_message());
        CHECK(code == status);
        CHECK(std::string(dh_last_message()).find(word) != std::string::npos);
        for (const std::vector<double>* array : {&a, &b, &c, &d})
            for (const double x : *array) REQUIRE(x == untouched);
        CHECK(no_system == nullptr);
        CHECK(no_solution == nullptr);
    }
};

template <class Struct>
Struct of_size(std::size_t size) {
    Struct s;
    std::memset(&s, 0x5a, sizeof s);
    s.size = size;
    return s;
}

// A struct too small, null, and right but for the rest of the call: none is written.
template <class Struct>
void check_struct(Faults& f, const std::function<int(Struct*)>& call, const std::function<int(Struct*)>& bad_call,
                  int bad_status) {
    f.fails(call(nullptr), DH_ERROR_NULL, "must not be null");
    for (const std::size_t size : {std::size_t(0), sizeof(Struct) - 1}) {
        Struct s = of_size<Struct>(size), before = s;
        f.fails(call(&s), DH_ERROR_SIZE, "->size must be at least");
        CHECK(std::memcmp(&s, &before, sizeof s) == 0);
    }
    Struct s = of_size<Struct>(sizeof(Struct)), before = s;
    CHECK(bad_call(&s) == bad_status);
    CHECK(std::memcmp(&s, &before, sizeof s) == 0);
    struct {
        Struct known;
        double later;
    } grown{of_size<Struct>(sizeof(Struct) + sizeof(double)), untouched}; // a caller with a later header
    CHECK(call(&grown.known) == DH_OK);
    CHECK(grown.later == untouched);
    CHECK(grown.known.size == sizeof(Struct) + sizeof(double));
}

int status_of(const std::function<void()>& body) { return c_interface::guarded(body); }

} // namespace

TEST_CASE("a system that breaks a rule is refused with quantity, rule and value", "[c_interface][faults]") {
    Faults f;
    const auto made = [&](const std::vector<double>& m, const std::vector<double>& k, const std::vector<double>& z, std::size_t j,
                          std::size_t l) { return dh_system_from_ratios(2, m.data(), k.data(), z.data(), j, l, &f.no_system); };
    f.fails(made({1, -2}, ones, damped, 1, 1), DH_ERROR_INPUT, "mass_ratios");
    f.fails(made({1, no_number}, ones, damped, 1, 1), DH_ERROR_INPUT, "mass_ratios");
    f.fails(made(ones, {1, 0}, damped, 1, 1), DH_ERROR_INPUT, "stiffness_ratios");
    f.fails(made(ones, {1, endless}, damped, 1, 1), DH_ERROR_INPUT, "stiffness_ratios");
    f.fails(made(ones, ones, {0, -0.5}, 1, 1), DH_ERROR_INPUT, "damping_ratios");
    f.fails(made(ones, ones, {0, no_number}, 1, 1), DH_ERROR_INPUT, "damping_ratios");
    f.fails(made(ones, ones, damped, 3, 1), DH_ERROR_INPUT, "contact");
    f.fails(made(ones, ones, damped, 1, 0), DH_ERROR_INPUT, "load");
    const double* one = ones.data();
    f.fails(dh_system_from_ratios(0, one, one, one, 1, 1, &f.no_system), DH_ERROR_SIZE, "N must be from 1 to 1000, but is 0");
    for (const std::size_t N :
         {std::size_t(DH_MOST_MASSES) + 1, std::size_t(1'000'000), (std::size_t(1) << 61) + 2, endless_count})
        f.fails(dh_system_from_ratios(N, one, one, one, 1, 1, &f.no_system), DH_ERROR_SIZE,
                "N must be from 1 to 1000, but is " + std::to_string(N));
    f.fails(dh_system_from_ratios(2, nullptr, one, one, 1, 1, &f.no_system), DH_ERROR_NULL, "mass_ratios");
    f.fails(dh_system_from_ratios(2, one, nullptr, one, 1, 1, &f.no_system), DH_ERROR_NULL, "stiffness_ratios");
    f.fails(dh_system_from_ratios(2, one, one, nullptr, 1, 1, &f.no_system), DH_ERROR_NULL, "damping_ratios");
    f.fails(dh_system_from_ratios(2, one, one, one, 1, 1, nullptr), DH_ERROR_NULL, "system");
    const std::string negative = R"({"mass_ratios":[-1],"stiffness_ratios":[1],"damping_ratios":[0],"contact":1,"load":1})";
    f.fails(dh_system_from_json(negative.data(), negative.size(), &f.no_system), DH_ERROR_INPUT, "/mass_ratios");
    f.fails(dh_system_from_json(negative.data(), 5, &f.no_system), DH_ERROR_INPUT, "line 1");
    f.fails(dh_system_from_json("", 0, &f.no_system), DH_ERROR_INPUT, "");
    const std::string zero =
        std::string(R"({"mass_ratios":[1],"stiffness_ratios":[1],"damping_ratios":[0],"contact":1,"load":1})") + '\0';
    f.fails(dh_system_from_json(zero.data(), zero.size(), &f.no_system), DH_ERROR_INPUT, "a zero byte (at line 1, column");
    f.fails(dh_system_from_json((zero + "{").data(), zero.size() + 1, &f.no_system), DH_ERROR_INPUT, "a zero byte");
    const std::string key = "{\"\\u001b" + std::string(1'000'000, 'k') + "\":1}";
    f.fails(dh_system_from_json(key.data(), key.size(), &f.no_system), DH_ERROR_INPUT, "\\x1Bkkk");
    f.fails(dh_system_from_json(nullptr, 5, &f.no_system), DH_ERROR_NULL, "text");
    f.fails(dh_system_from_json(negative.data(), negative.size(), nullptr), DH_ERROR_NULL, "system");
    dh_system_destroy(nullptr);
    dh_solution_destroy(nullptr);
}

TEST_CASE("null pointers and wrong lengths are refused, and nothing is written", "[c_interface][faults]") {
    Faults f;
    const dh_system* s = f.system.get();
    const dh_solution* x = f.sliding.get();
    double *a = f.a.data(), *b = f.b.data(), *c = f.c.data(), *d = f.d.data();
    std::size_t N = 99;
    f.fails(dh_system_masses(nullptr, &N, nullptr, nullptr), DH_ERROR_NULL, "system");
    f.fails(dh_system_masses(s, nullptr, nullptr, nullptr), DH_ERROR_NULL, "N");
    CHECK(N == 99);
    f.fails(dh_natural_frequency_ratios(nullptr, 2, a, b), DH_ERROR_NULL, "system");
    f.fails(dh_natural_frequency_ratios(s, 2, nullptr, b), DH_ERROR_NULL, "r_n");
    f.fails(dh_natural_frequency_ratios(s, 3, a, b), DH_ERROR_SIZE, "count must be 2, but is 3");
    f.fails(dh_mode_shapes(nullptr, 1, 4, a), DH_ERROR_NULL, "system");
    f.fails(dh_mode_shapes(s, 1, 4, nullptr), DH_ERROR_NULL, "psi");
    f.fails(dh_mode_shapes(s, 1, 2, a), DH_ERROR_SIZE, "count must be 4, but is 2");
    f.fails(dh_natural_frequency_ratio_errors(nullptr, 2, a, b), DH_ERROR_NULL, "system");
    f.fails(dh_natural_frequency_ratio_errors(s, 2, nullptr, b), DH_ERROR_NULL, "r_n_error");
    f.fails(dh_natural_frequency_ratio_errors(s, 3, a, b), DH_ERROR_SIZE, "count must be 2, but is 3");
    f.fails(dh_mode_shape_errors(s, 1, 4, nullptr), DH_ERROR_NULL, "psi_error");
    f.fails(dh_modal_function_errors(s, 1, 2, nullptr, b, c, d), DH_ERROR_NULL, "R_error");
    f.fails(dh_sum_errors(s, 1, 2, nullptr, b, c, d, d), DH_ERROR_NULL, "V_error");
    f.fails(dh_high_frequency_limit_error(s, 1, nullptr), DH_ERROR_NULL, "error");
    f.fails(dh_displacement_errors(s, 1, 0, 1, 1, 2, ones.data(), nullptr), DH_ERROR_NULL, "x_error");
    f.fails(dh_modal_functions(nullptr, 1, 2, a, b, c, d), DH_ERROR_NULL, "system");
    f.fails(dh_modal_functions(s, 1, 2, nullptr, b, c, d), DH_ERROR_NULL, "R");
    f.fails(dh_modal_functions(s, 1, 1, a, b, c, d), DH_ERROR_SIZE, "count");
    f.fails(dh_sums(nullptr, 1, 2, a, b, c, d, nullptr), DH_ERROR_NULL, "system");
    f.fails(dh_sums(s, 1, 2, nullptr, b, c, d, nullptr), DH_ERROR_NULL, "V");
    f.fails(dh_sums(s, 1, 0, a, b, c, d, d), DH_ERROR_SIZE, "count");
    f.fails(dh_high_frequency_limit(nullptr, 1, a), DH_ERROR_NULL, "system");
    f.fails(dh_high_frequency_limit(s, 1, nullptr), DH_ERROR_NULL, "beta_lim");
    f.fails(dh_displacement(nullptr, 1, 0, 1, 1, 2, ones.data(), a), DH_ERROR_NULL, "system");
    f.fails(dh_displacement(s, 1, 0, 1, 1, 2, nullptr, a), DH_ERROR_NULL, "tau");
    f.fails(dh_displacement(s, 1, 0, 1, 1, 2, ones.data(), nullptr), DH_ERROR_NULL, "x");
    f.fails(dh_solve(nullptr, 1, 0, 1, 0, &f.no_solution), DH_ERROR_NULL, "system");
    f.fails(dh_solve(s, 1, 0, 1, 0, nullptr), DH_ERROR_NULL, "solution");
    f.fails(dh_solve_proved(nullptr, 1, 0, 1, 0, &f.no_solution), DH_ERROR_NULL, "system");
    f.fails(dh_solve_proved(s, 1, 0, 1, 0, nullptr), DH_ERROR_NULL, "solution");
    int proved = 99;
    f.fails(dh_solution_is_proved(nullptr, &proved), DH_ERROR_NULL, "solution");
    f.fails(dh_solution_is_proved(x, nullptr), DH_ERROR_NULL, "proved");
    f.fails(dh_solution_is_from_rest(nullptr, &proved), DH_ERROR_NULL, "solution");
    f.fails(dh_solution_is_from_rest(x, nullptr), DH_ERROR_NULL, "from_rest");
    CHECK(proved == 99);
    char text[512] = "as it was";
    f.fails(dh_solution_warning(nullptr, sizeof text, text), DH_ERROR_NULL, "solution");
    f.fails(dh_solution_warning(x, sizeof text, nullptr), DH_ERROR_NULL, "text");
    f.fails(dh_solution_warning(x, 0, text), DH_ERROR_SIZE, "room must be at least 1, but is 0");
    CHECK(text[0] == 'a');
    CHECK(dh_solution_warning(x, 1, text) == DH_OK);
    CHECK(text[0] == '\0');
    f.fails(dh_solution_stops(nullptr, 0, a, b), DH_ERROR_NULL, "solution");
    f.fails(dh_solution_stops(x, 1, a, b), DH_ERROR_SIZE, "count must be 0, but is 1");
    f.fails(dh_solution_stops(f.stopping.get(), 2, nullptr, b), DH_ERROR_NULL, "start");
    f.fails(dh_solution_stops(f.stopping.get(), 2, a, nullptr), DH_ERROR_NULL, "end");
    f.fails(dh_solution_stop_errors(nullptr, 0, a, b), DH_ERROR_NULL, "solution");
    f.fails(dh_solution_stop_errors(x, 1, a, b), DH_ERROR_SIZE, "count must be 0, but is 1");
    f.fails(dh_solution_stop_errors(f.stopping.get(), 2, nullptr, b), DH_ERROR_NULL, "start_error");
    f.fails(dh_solution_stop_errors(f.stopping.get(), 2, a, nullptr), DH_ERROR_NULL, "end_error");
    f.fails(dh_solution_motion(nullptr, 2, 4, a, b), DH_ERROR_NULL, "solution");
    f.fails(dh_solution_motion(x, 2, 4, nullptr, b), DH_ERROR_NULL, "x");
    f.fails(dh_solution_motion(x, 2, 3, a, b), DH_ERROR_SIZE, "count must be 4, but is 3");
    f.fails(dh_solution_motion(x, 0, 0, a, b), DH_ERROR_SIZE, "samples");
    for (const std::size_t samples : {std::size_t(DH_MOST_SAMPLES) + 1, endless_count / 2 + 1, endless_count})
        f.fails(dh_solution_motion(x, samples, samples * 2, a, b), DH_ERROR_SIZE,
                "samples must be from 1 to 10000000, but is " + std::to_string(samples));
    for (const std::size_t count : {std::size_t(DH_MOST_SAMPLES) + 1, (std::size_t(1) << 61) + 2, endless_count}) {
        f.fails(dh_displacement(s, 1, 0, 1, 1, count, ones.data(), a), DH_ERROR_SIZE, "count must be from 1 to 10000000");
        f.fails(dh_quantity(s, "motion_under_force", 1.125, 0.125, 1.25, 1, 0, count, a, &N), DH_ERROR_SIZE,
                "size, the number of samples, must be from 1 to 10000000, but is " + std::to_string(count));
        CHECK(N == 99);
    }
    CHECK(dh_solution_stops(x, 0, nullptr, nullptr) == DH_OK);
    CHECK(dh_solution_stop_errors(x, 0, nullptr, nullptr) == DH_OK);
}

TEST_CASE("structs are refused where they are null or too small, and filled where they are larger", "[c_interface][faults]") {
    Faults f;
    const dh_system* s = f.system.get();
    const dh_solution* x = f.sliding.get();
    check_struct<dh_boundary>(
        f, [&](auto* result) { return dh_boundaries(s, 1.125, 1, result); },
        [&](auto* result) { return dh_boundaries(s, no_number, 1, result); }, DH_ERROR_INPUT);
    check_struct<dh_sliding_mass>(
        f, [&](auto* result) { return dh_sliding_motion(s, 1.125, 0.125, 1, 2, result); },
        [&](auto* result) { return dh_sliding_motion(s, 1.125, 100, 1, 2, result); }, DH_ERROR_DOMAIN);
    check_struct<dh_boundary>(
        f, [&](auto* result) { return dh_boundary_errors(s, 1.125, 1, result); },
        [&](auto* result) { return dh_boundary_errors(s, no_number, 1, result); }, DH_ERROR_INPUT);
    check_struct<dh_sliding_mass>(
        f, [&](auto* result) { return dh_sliding_motion_errors(s, 1.125, 0.125, 1, 2, result); },
        [&](auto* result) { return dh_sliding_motion_errors(s, 1.125, 100, 1, 2, result); }, DH_ERROR_DOMAIN);
    check_struct<dh_summary>(
        f, [&](auto* result) { return dh_solution_summary(x, result); },
        [&](auto* result) { return dh_solution_summary(nullptr, result); }, DH_ERROR_NULL);
    check_struct<dh_mass>(
        f, [&](auto* result) { return dh_solution_mass(x, 1, result); },
        [&](auto* result) { return dh_solution_mass(x, 3, result); }, DH_ERROR_INPUT);
    check_struct<dh_boundary>(
        f, [&](auto* result) { return dh_boundaries_proved(s, 1.125, 1, result, nullptr); },
        [&](auto* result) { return dh_boundaries_proved(s, no_number, 1, result, nullptr); }, DH_ERROR_INPUT);
    dh_boundary other{1, 0, 0, 0, 0, 0};
    f.fails(dh_boundaries_proved(s, 1.125, 1, &other, nullptr), DH_ERROR_SIZE, "boundary->size");
    dh_boundary right{sizeof right, untouched, 0, 0, 0, 0};
    f.fails(dh_boundaries_proved(s, 1.125, 1, &right, &other), DH_ERROR_SIZE, "errors->size");
    CHECK(right.exact == untouched);
    check_struct<dh_energies>(
        f, [&](auto* result) { return dh_solution_energies(x, 0, result, nullptr); },
        [&](auto* result) { return dh_solution_energies(x, 16, result, nullptr); }, DH_ERROR_INPUT);
    dh_energies small{};
    auto right_size = sized<dh_energies>();
    f.fails(dh_solution_energies(x, 0, &right_size, &small), DH_ERROR_SIZE, "errors->size");
    CHECK(dh_solution_energies(nullptr, 0, &right_size, nullptr) == DH_ERROR_NULL);
    CHECK(dh_solution_energies(x, 0, nullptr, nullptr) == DH_ERROR_NULL);
    CHECK(dh_boundaries(nullptr, 1, 1, nullptr) == DH_ERROR_NULL);
    CHECK(dh_boundaries_proved(nullptr, 1, 1, nullptr, nullptr) == DH_ERROR_NULL);
    CHECK(dh_sliding_motion(nullptr, 1, 0, 1, 1, nullptr) == DH_ERROR_NULL);
    CHECK(dh_solution_mass(nullptr, 1, nullptr) == DH_ERROR_NULL);
    CHECK(dh_solution_from_ground(nullptr, 1, nullptr, nullptr, nullptr) == DH_ERROR_NULL);
    CHECK(dh_solution_from_ground(x, 1, nullptr, nullptr, nullptr) == DH_ERROR_NULL);
    dh_mass from_ground{};
    CHECK(dh_solution_from_ground(x, 1, &from_ground, nullptr, nullptr) == DH_ERROR_SIZE);
    from_ground.size = sizeof from_ground;
    CHECK(dh_solution_from_ground(x, 3, &from_ground, nullptr, nullptr) == DH_ERROR_INPUT);
    CHECK(dh_solution_from_ground(x, 1, &from_ground, nullptr, nullptr) == DH_ERROR_DOMAIN); // nothing moves
}

TEST_CASE("a motion from a start refuses what is wrong and has room for what is right", "[c_interface][faults]") {
    const std::string text = R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0, "contact": 1, "load": 1})";
    dh_system* s = nullptr;
    REQUIRE(dh_system_from_json(text.data(), text.size(), &s) == DH_OK);
    const double x = 1;
    double turn[8], turn_x[8], rest[2], masses[1], masses_error[1];
    dh_decay_request request{sizeof request, 1, 0.125, 1, &x, nullptr, 0};
    auto decay = sized<dh_decay>();
    decay.room = 8;
    decay.turn = turn;
    decay.turn_x = turn_x;
    decay.rest = rest;
    REQUIRE(dh_free_decay(s, &request, &decay) == DH_OK);
    REQUIRE(decay.turns == 4); // every half-period takes 2 F / k
    for (int n = 0; n < 4; ++n) {
        CHECK(turn[n] == Approx((n + 1) * 3.141592653589793).epsilon(1e-14));
        CHECK(std::abs(turn_x[n]) == Approx(0.75 - 0.25 * n).margin(1e-14));
    }
    CHECK(decay.at_rest == 1);
    CHECK(decay.others == DH_NOT_KNOWN);
    const auto decays_with = [&](auto change) {
        dh_decay_request changed = request;
        dh_decay room = decay;
        room.turns = 77;
        change(changed, room);
        const int status = dh_free_decay(s, &changed, &room);
        CHECK(room.turns == 77);
        return status;
    };
    CHECK(decays_with([](auto& q, auto&) { q.beta = -1; }) == DH_ERROR_INPUT);
    CHECK(decays_with([](auto& q, auto&) { q.beta = 0; }) == DH_ERROR_INPUT);
    CHECK(decays_with([](auto& q, auto&) { q.r = 0; }) == DH_ERROR_INPUT);
    CHECK(decays_with([](auto& q, auto&) { q.mu = 0.5; }) == DH_ERROR_INPUT);
    CHECK(decays_with([](auto& q, auto&) { q.until = -1; }) == DH_ERROR_INPUT);
    CHECK(decays_with([](auto& q, auto&) { q.until = no_number; }) == DH_ERROR_INPUT);
    CHECK(dh_last_message() == std::string("until must be zero or positive, but is nan"));
    CHECK(decays_with([](auto& q, auto&) { q.x = &no_number; }) == DH_ERROR_INPUT);
    CHECK(decays_with([](auto& q, auto&) { q.size = 8; }) == DH_ERROR_SIZE);
    CHECK(decays_with([](auto&, auto& room) { room.room = 3; }) == DH_ERROR_SIZE);
    CHECK(dh_free_decay(nullptr, &request, &decay) == DH_ERROR_NULL);
    CHECK(dh_free_decay(s, nullptr, &decay) == DH_ERROR_NULL);
    CHECK(dh_free_decay(s, &request, nullptr) == DH_ERROR_NULL);
    CHECK(dh_place_of_rest(s, 1, masses, masses_error) == DH_OK);
    CHECK(masses[0] == 0);
    CHECK(dh_place_of_rest(s, 2, masses, nullptr) == DH_ERROR_SIZE);
    CHECK(dh_place_of_rest(s, 1, nullptr, nullptr) == DH_ERROR_NULL);
    CHECK(dh_place_of_rest(nullptr, 1, masses, nullptr) == DH_ERROR_NULL);
    double tau[8], states[8];
    signed char direction[8];
    dh_history_request over{sizeof over, 1, 0.125, 1, &x, nullptr, 2, 0, 4, 1};
    auto history = sized<dh_history>();
    history.stop_room = history.sample_room = 8;
    history.tau = tau;
    history.x = states;
    history.direction = direction;
    REQUIRE(dh_follow(s, &over, &history) == DH_OK);
    CHECK(history.samples == 8);
    CHECK(states[2] == Approx(-0.75).epsilon(1e-12)); // half a period later
    CHECK(direction[1] == -1);
    const auto follows_with = [&](auto change) {
        dh_history_request changed = over;
        dh_history room = history;
        room.samples = 77;
        change(changed, room);
        const int status = dh_follow(s, &changed, &room);
        CHECK(room.samples == 77);
        return status;
    };
    CHECK(follows_with([](auto& q, auto&) { q.cycles = 0; }) == DH_ERROR_INPUT);
    CHECK(follows_with([](auto& q, auto&) { q.last = 3; }) == DH_ERROR_INPUT);
    CHECK(follows_with([](auto& q, auto&) { q.samples = -1; }) == DH_ERROR_INPUT);
    CHECK(follows_with([](auto& q, auto&) { q.beta = no_number; }) == DH_ERROR_INPUT);
    CHECK(follows_with([](auto& q, auto&) { q.x_prime = &no_number; }) == DH_ERROR_INPUT);
    CHECK(follows_with([](auto& q, auto&) { q.size = 8; }) == DH_ERROR_SIZE);
    CHECK(follows_with([](auto&, auto& room) { room.sample_room = 7; }) == DH_ERROR_SIZE);
    CHECK(dh_follow(s, nullptr, &history) == DH_ERROR_NULL);
    CHECK(dh_follow(s, &over, nullptr) == DH_ERROR_NULL);
    dh_system_destroy(s);
}

TEST_CASE("numbers outside their rules, among them those that are none, are refused by every function", "[c_interface][faults]") {
    Faults f;
    const dh_system* s = f.system.get();
    double *a = f.a.data(), *b = f.b.data(), *c = f.c.data(), *d = f.d.data();
    dh_boundary boundary{sizeof boundary, 0, 0, 0, 0, 0};
    for (const double r : {no_number, endless, 0.0, -1.0}) {
        f.fails(dh_mode_shapes(s, r, 4, a), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_modal_functions(s, r, 2, a, b, c, d), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_sums(s, r, 2, a, b, c, d, d), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_mode_shape_errors(s, r, 4, a), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_sum_errors(s, r, 2, a, b, c, d, d), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_boundaries(s, r, 1, &boundary), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_displacement(s, r, 0, 1, 1, 2, ones.data(), a), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_boundaries_proved(s, r, 1, &boundary, nullptr), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_solve(s, r, 0.125, 1, 0, &f.no_solution), DH_ERROR_INPUT, "r must be positive");
        f.fails(dh_solve_proved(s, r, 0.125, 1, 0, &f.no_solution), DH_ERROR_INPUT, "r must be positive");
    }
    for (const double mu : {no_number, endless, 0.75}) {
        f.fails(dh_boundaries(s, 1, mu, &boundary), DH_ERROR_INPUT, "mu must be at least 1");
        f.fails(dh_high_frequency_limit(s, mu, a), DH_ERROR_INPUT, "mu must be at least 1");
        f.fails(dh_displacement(s, 1, 0, mu, 1, 2, ones.data(), a), DH_ERROR_INPUT, "mu must be at least 1");
        f.fails(dh_boundaries_proved(s, 1, mu, &boundary, nullptr), DH_ERROR_INPUT, "mu must be at least 1");
        f.fails(dh_solve(s, 1, 0.125, mu, 0, &f.no_solution), DH_ERROR_INPUT, "mu must be at least 1");
        f.fails(dh_solve_proved(s, 1, 0.125, mu, 0, &f.no_solution), DH_ERROR_INPUT, "mu must be at least 1");
    }
    for (const double beta : {no_number, endless, -0.5}) {
        f.fails(dh_displacement(s, 1, beta, 1, 1, 2, ones.data(), a), DH_ERROR_INPUT, "beta must be zero or positive");
        f.fails(dh_solve(s, 1, beta, 1, 0, &f.no_solution), DH_ERROR_INPUT, "beta must be zero or positive");
        f.fails(dh_solve_proved(s, 1, beta, 1, 0, &f.no_solution), DH_ERROR_INPUT, "beta must be zero or positive");
    }
    for (const std::size_t mass : {0, 3})
        f.fails(dh_displacement(s, 1, 0, 1, mass, 2, ones.data(), a), DH_ERROR_INPUT, "mass must be a mass from 1 to 2");
    for (const double tau : {no_number, endless}) f.fails(dh_displacement(s, 1, 0, 1, 1, 1, &tau, a), DH_ERROR_INPUT, "tau");
    for (const int digits : {-1, 16})
        for (const auto& how : {dh_solve, dh_solve_proved})
            f.fails(how(s, 1, 0.125, 1, digits, &f.no_solution), DH_ERROR_INPUT,
                    "digits must be from 0 to 15, but is " + std::to_string(digits));
}

TEST_CASE("a formula outside its domain and a result beyond double are refused", "[c_interface][faults]") {
    Faults f;
    double *a = f.a.data(), *b = f.b.data(), *c = f.c.data(), *d = f.d.data();
    f.fails(dh_displacement(f.system.get(), 1, 100, 1, 1, 2, ones.data(), a), DH_ERROR_DOMAIN, "Eq. (69)");
    f.fails(dh_high_frequency_limit(f.system.get(), 1, a), DH_ERROR_DOMAIN, "j = l");
    const Handle undamped = handle_of(chain_of({1}, {1}, {0}, 1, 1));
    f.fails(dh_modal_functions(undamped.get(), 1, 1, a, b, c, d), DH_ERROR_DOMAIN, "");
    f.fails(dh_modal_function_errors(undamped.get(), 1, 1, a, b, c, d), DH_ERROR_DOMAIN, "");
    f.fails(dh_high_frequency_limit_error(f.system.get(), 1, a), DH_ERROR_DOMAIN, "j = l");
    f.fails(dh_displacement_errors(f.system.get(), 1, 100, 1, 1, 2, ones.data(), a), DH_ERROR_DOMAIN, "Eq. (69)");
    f.fails(dh_sums(undamped.get(), 1, 1, a, b, c, d, d), DH_ERROR_DOMAIN, "");
    f.fails(dh_solve(undamped.get(), 1, 0.125, 1, 0, &f.no_solution), DH_ERROR_DOMAIN, "");
    dh_boundary limits{sizeof limits, untouched, 0, 0, 0, 0};
    f.fails(dh_boundaries_proved(undamped.get(), 1, 1, &limits, nullptr), DH_ERROR_DOMAIN, "infinite there");
    CHECK(limits.exact == untouched);
    f.fails(dh_mode_shapes(undamped.get(), 1e-310, 1, a), DH_ERROR_PRECISION, "beyond the range of double");
}

TEST_CASE("memory that is short is an error code", "[c_interface][faults]") {
    const Faults f;
    constexpr std::size_t samples = DH_MOST_SAMPLES;
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) { // the limit is the child's alone
        constexpr std::size_t bytes = samples * 2 * sizeof(double);
        void* x = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (x == MAP_FAILED) _exit(100);
        const rlimit least{bytes + (std::size_t(1) << 28), RLIM_INFINITY};
        if (setrlimit(RLIMIT_AS, &least) != 0) _exit(101);
        const int status = dh_solution_motion(f.sliding.get(), samples, samples * 2, static_cast<double*>(x), nullptr);
        _exit(status == DH_ERROR_MEMORY && std::strncmp(dh_last_message(), "memory must hold", 16) == 0 ? 0 : 102);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
}

TEST_CASE("whatever is thrown becomes a code with a text", "[c_interface][faults]") {
    CHECK(status_of([] {}) == DH_OK);
    CHECK(status_of([] { throw 1; }) == DH_ERROR_INTERNAL);
    CHECK(status_of([] { throw std::logic_error("a slip"); }) == DH_ERROR_INTERNAL);
    CHECK(std::string(c_interface::message()).find("defect of the library") != std::string::npos);
    CHECK(std::string(c_interface::message()).find("a slip") == std::string::npos);
    CHECK(status_of([] { throw std::length_error("too long"); }) == DH_ERROR_SIZE);
    CHECK(status_of([] { throw std::bad_alloc(); }) == DH_ERROR_MEMORY);
    CHECK(status_of([] { throw std::overflow_error("Error in function boost::math"); }) == DH_ERROR_PRECISION);
    CHECK(std::string(c_interface::message()).find("boost") == std::string::npos);
    CHECK(status_of([] { throw DomainError(std::string(5000, 'x')); }) == DH_ERROR_DOMAIN);
    CHECK(std::strlen(c_interface::message()) == c_interface::message_size - 1);
    std::vector<std::string> texts;
    for (int status = DH_OK; status <= DH_ERROR_INTERNAL; ++status) texts.emplace_back(dh_status_text(status));
    texts.emplace_back(dh_status_text(-1));
    CHECK(dh_status_text(99) == texts.back());
    std::sort(texts.begin(), texts.end());
    CHECK(std::unique(texts.begin(), texts.end()) == texts.end());
    CHECK(dh_abi_version() == DH_ABI_VERSION);
}
