// The C interface: bytes choose functions, numbers, counts, and pointers that are null. Every call returns a status of the
// header, no exception leaves it, and outputs are written all or not at all.
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "conformance/question.hpp"
#include "tests/fuzz/outputs.hpp"

using namespace denhartog;
using namespace denhartog::fuzz;

namespace {

constexpr double operations = 2000;

struct Destroy {
    void operator()(dh_system* system) const { dh_system_destroy(system); }
    void operator()(dh_solution* solution) const { dh_solution_destroy(solution); }
};
using SystemHandle = std::unique_ptr<dh_system, Destroy>;
using SolutionHandle = std::unique_ptr<dh_solution, Destroy>;

// The handle that a call left; none where it failed.
template <class Handle>
Handle taken(bool ok, typename Handle::pointer made) {
    claim(ok == (made != nullptr), "a handle is made where the call answers, and only there");
    return Handle(made);
}

SystemHandle from_ratios(Choices& c) {
    constexpr std::array<std::size_t, 4> other_counts{0, 1001, 100'000'000'000, SIZE_MAX};
    const std::size_t few = 1 + c.of(4), N = c.rarely() ? other_counts[c.of(other_counts.size())] : few;
    std::vector<double> masses = c.numbers(few), springs = c.numbers(few), damping = c.numbers(few);
    if (!c.rarely()) masses[0] = springs[0] = 1;
    for (double& zeta : damping) zeta /= 16;
    if (c.rarely()) damping[0] = 0;
    const std::size_t contact = c.rarely() ? c.byte() : 1 + c.of(few), load = c.rarely() ? c.byte() : 1 + c.of(few);
    const auto pointer = [&](const std::vector<double>& x) { return c.rarely() ? nullptr : x.data(); };
    dh_system* system = nullptr;
    const int status = dh_system_from_ratios(N, pointer(masses), pointer(springs), pointer(damping), contact, load,
                                             c.rarely() ? nullptr : &system);
    const bool ok =
        answered(status, {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_PRECISION, DH_ERROR_MEMORY}, "from_ratios");
    return taken<SystemHandle>(ok, system);
}

SystemHandle from_text(Choices& c, std::string_view text) {
    dh_system* system = nullptr;
    const int status = dh_system_from_json(c.rarely() ? nullptr : text.data(), text.size(), c.rarely() ? nullptr : &system);
    const bool ok =
        answered(status, {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_PRECISION, DH_ERROR_MEMORY}, "from_json");
    return taken<SystemHandle>(ok, system);
}

// Symmetric, dominated by its diagonal but rarely.
nlohmann::json matrix(Choices& c, std::size_t N) {
    std::vector<std::vector<double>> rows(N, std::vector<double>(N));
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k <= i; ++k) {
            rows[i][k] = i == k ? 16 + c.number() : c.rarely() ? c.any_number() : c.number() - 4;
            rows[k][i] = c.rarely() ? c.number() : rows[i][k];
        }
    return rows;
}

// Damping is a share of the stiffness, so that the modes stay, or another matrix.
SystemHandle from_matrices(Choices& c) {
    const std::size_t N = 1 + c.of(3);
    nlohmann::json scene{{"mass_matrix", matrix(c, N)}, {"stiffness_matrix", matrix(c, N)}};
    if (c.of(2) == 0) {
        scene["damping_ratios"] = c.number() / 16;
    } else if (c.of(2) == 0) { // it couples the modes
        scene["damping_matrix"] = matrix(c, N);
        if (c.rarely()) scene["damping_tolerance"] = c.number();
    } else {
        scene["damping_matrix"] = scene["stiffness_matrix"];
        for (nlohmann::json& row : scene["damping_matrix"])
            for (nlohmann::json& x : row)
                if (x.is_number()) x = x.get<double>() / 64;
    }
    scene["contact"] = 1 + c.of(N);
    scene["load"] = 1 + c.of(N);
    return from_text(c, scene.dump());
}

SystemHandle system_of(Choices& c) {
    const std::size_t kind = c.of(4);
    if (kind == 3) return from_text(c, c.text());
    return kind == 2 ? from_matrices(c) : from_ratios(c);
}

struct Point {
    double r, beta, mu;
    explicit Point(Choices& c)
        : r(c.number()), beta(c.number()), mu(c.rarely()     ? c.any_number()
                                              : c.of(2) == 0 ? 1
                                                             : 1 + c.number()) {}
};

// Most often the right count.
std::size_t count_of(Choices& c, std::size_t right) { return c.rarely() ? c.of(8) : right; }

void ask_masses(Choices& c, const dh_system* system, std::size_t N) {
    std::array<std::size_t, 3> out{SIZE_MAX, SIZE_MAX, SIZE_MAX};
    const auto pointer = [&](std::size_t n) { return c.rarely() ? nullptr : &out[n]; };
    std::size_t *const to_N = pointer(0), *const contact = pointer(1), *const load = pointer(2);
    const bool ok = answered(dh_system_masses(system, to_N, contact, load), {DH_ERROR_NULL}, "masses");
    claim(ok == (system != nullptr && to_N != nullptr), "masses are there for whoever asks with a pointer");
    claim(out[0] == (ok ? N : SIZE_MAX), "N is written, or untouched");
    for (const std::size_t n : {1, 2}) {
        const bool written = ok && (n == 1 ? contact : load) != nullptr;
        claim(written ? out[n] >= 1 && out[n] <= N : out[n] == SIZE_MAX, "contact and load are masses, or untouched");
    }
}

void ask_modes(Choices& c, const dh_system* system, std::size_t N) {
    const std::size_t which = c.of(2), right = which == 0 ? N : N * N, count = count_of(c, right);
    const double r = c.number();
    Output first(c, std::max(count, right)), zeta(c, std::max(count, right));
    const bool errors = c.of(2) == 0;
    const auto of_frequencies = errors ? dh_natural_frequency_ratio_errors : dh_natural_frequency_ratios;
    const int status = which == 0 ? of_frequencies(system, count, first.data(), zeta.data())
                                  : (errors ? dh_mode_shape_errors : dh_mode_shapes)(system, r, count, first.data());
    const bool ok = which == 0
                        ? answered(status, {DH_ERROR_NULL, DH_ERROR_SIZE}, "natural_frequency_ratios")
                        : answered(status, {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_PRECISION}, "mode_shapes");
    first.check(ok, right);
    zeta.check(ok && which == 0, right);
}

constexpr std::initializer_list<int> of_a_point = {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_DOMAIN,
                                                   DH_ERROR_PRECISION};

void ask_functions(Choices& c, const dh_system* system, std::size_t N) {
    const bool sums = c.of(2) == 0;
    const double r = c.number();
    const std::size_t count = count_of(c, N), size = std::max(count, N);
    Output z(c, 2 * size), first(c, size), second(c, size), third(c, size), H_j(c, 1), S_j(c, 1);
    const bool errors = c.of(2) == 0;
    const auto of_sums = errors ? dh_sum_errors : dh_sums;
    const auto of_modes = errors ? dh_modal_function_errors : dh_modal_functions;
    const bool ok = sums ? answered(of_sums(system, r, count, z.data(), first.data(), second.data(), H_j.data(), S_j.data()),
                                    of_a_point, "sums")
                         : answered(of_modes(system, r, count, third.data(), z.data(), first.data(), second.data()), of_a_point,
                                    "modal_functions");
    z.check(ok, 2 * N);
    first.check(ok, N);
    second.check(ok, N);
    third.check(ok && !sums, N);
    H_j.check(ok && sums, 1);
    S_j.check(ok && sums, 1);
}

void ask_boundaries(Choices& c, const dh_system* system, std::size_t) {
    const Point p(c);
    StructOutput<dh_boundary> b(c);
    const bool errors = c.of(2) == 0;
    b.check(answered((errors ? dh_boundary_errors : dh_boundaries)(system, p.r, p.mu, b.data()), of_a_point, "boundaries"),
            {&dh_boundary::exact, &dh_boundary::paper, &dh_boundary::approximate, &dh_boundary::sticking});
    dh_boundary proved{sizeof proved, -99, -99, -99, -99, -99}, bounds = proved;
    const bool has_proof = answered(dh_boundaries_proved(system, p.r, p.mu, &proved, &bounds), of_a_point, "boundaries_proved");
    for (const dh_boundary& each : {proved, bounds})
        for (const double x : {each.exact, each.paper, each.approximate, each.sticking})
            claim(has_proof ? std::isfinite(x) && x >= 0 : x == -99, "proved boundaries are written all or not at all");
    Output limit(c, 1);
    limit.check(answered((errors ? dh_high_frequency_limit_error : dh_high_frequency_limit)(system, p.mu, limit.data()),
                         {DH_ERROR_NULL, DH_ERROR_INPUT, DH_ERROR_DOMAIN}, "high_frequency_limit"),
                1);
}

void ask_sliding(Choices& c, const dh_system* system, std::size_t N) {
    const Point p(c);
    const std::size_t mass = c.rarely() ? c.byte() : 1 + c.of(N);
    StructOutput<dh_sliding_mass> m(c);
    const bool errors = c.of(2) == 0;
    m.check(answered((errors ? dh_sliding_motion_errors : dh_sliding_motion)(system, p.r, p.beta / 16, p.mu, mass, m.data()),
                     of_a_point, "sliding_motion"),
            {&dh_sliding_mass::initial_displacement, &dh_sliding_mass::initial_velocity, &dh_sliding_mass::amplitude,
             &dh_sliding_mass::phase, &dh_sliding_mass::instant, &dh_sliding_mass::amplitude_monoharmonic,
             &dh_sliding_mass::phase_monoharmonic});
    const std::size_t count = c.of(5);
    const std::vector<double> tau = c.numbers(count);
    Output x(c, count);
    x.check(answered((errors ? dh_displacement_errors : dh_displacement)(system, p.r, p.beta / 16, p.mu, mass, count,
                                                                         c.rarely() ? nullptr : tau.data(), x.data()),
                     of_a_point, "displacement"),
            count);
}

void look_at(Choices& c, const dh_solution* solution, std::size_t N) {
    StructOutput<dh_summary> all(c);
    const bool ok =
        answered(dh_solution_summary(solution, all.data()), {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_PRECISION}, "summary");
    all.check(ok, {&dh_summary::rest_from, &dh_summary::rest_to, &dh_summary::rest_error, &dh_summary::relative_error});
    StructOutput<dh_mass> m(c);
    const std::size_t mass = c.rarely() ? c.byte() : 1 + c.of(N);
    m.check(answered(dh_solution_mass(solution, mass, m.data()),
                     {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_PRECISION}, "mass"),
            {&dh_mass::amplitude, &dh_mass::error, &dh_mass::phase, &dh_mass::phase_error});
    StructOutput<dh_mass> contact(c);
    contact.check(
        answered(dh_solution_contact(solution, contact.data()), {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_PRECISION}, "contact"),
        {&dh_mass::amplitude, &dh_mass::error, &dh_mass::phase, &dh_mass::phase_error});
    if (ok) {
        const std::size_t stops = all.data()->stops, count = count_of(c, stops);
        Output start(c, std::max(count, stops)), end(c, std::max(count, stops));
        const bool told = answered(dh_solution_stops(solution, count, start.data(), end.data()),
                                   {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_PRECISION}, "stops");
        start.check(told, stops);
        end.check(told, stops);
        Output of_start(c, std::max(count, stops)), of_end(c, std::max(count, stops));
        const bool bounded = answered(dh_solution_stop_errors(solution, count, of_start.data(), of_end.data()),
                                      {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_PRECISION}, "errors of stops");
        of_start.check(bounded, stops);
        of_end.check(bounded, stops);
    }
    const std::size_t samples = c.of(6), right = samples * N, count = count_of(c, right);
    Output x(c, std::max(count, right)), x_prime(c, std::max(count, right));
    const bool moved = answered(dh_solution_motion(solution, samples, count, x.data(), x_prime.data()),
                                {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_DOMAIN, DH_ERROR_PRECISION, DH_ERROR_MEMORY}, "motion");
    x.check(moved, right);
    x_prime.check(moved, right);
}

void ask_solution(Choices& c, const dh_system* system, std::size_t N) {
    const Point p(c);
    const int digits = c.rarely() ? c.byte() - 8 : static_cast<int>(c.of(13));
    dh_solution* made = nullptr;
    const auto how = digits % 4 == 3 ? dh_solve_proved : dh_solve;
    const int status = how(system, p.r, p.beta, p.mu, digits, c.rarely() ? nullptr : &made);
    const bool ok =
        answered(status, {DH_ERROR_NULL, DH_ERROR_INPUT, DH_ERROR_DOMAIN, DH_ERROR_PRECISION, DH_ERROR_MEMORY}, "solve");
    const SolutionHandle solution = taken<SolutionHandle>(ok, made);
    int proved = 2;
    claim(!ok || dh_solution_is_from_rest(solution.get(), &proved) == DH_OK, "a solution says whether it is that from rest");
    claim(!ok || dh_solution_is_proved(solution.get(), &proved) == DH_OK, "a solution says whether it is proved");
    claim(ok ? proved == 1 || (proved == 0 && how == dh_solve) : proved == 2, "what had to be proved is proved");
    look_at(c, c.rarely() ? nullptr : solution.get(), N);
}

void ask_quantity(Choices& c, const dh_system* system, std::size_t N) {
    const auto known = conformance::quantities();
    const std::size_t which = c.of(known.size() + 1);
    const std::string name = which < known.size() ? std::string(known[which].name) : "no_quantity";
    const Point p(c);
    const std::size_t mass = c.rarely() ? c.byte() : 1 + c.of(N), size = c.rarely() ? c.of(2) : 4 + c.of(8);
    const double tau = c.number();
    Output values(c, size);
    std::size_t count = SIZE_MAX;
    std::size_t* const to_count = c.rarely() ? nullptr : &count;
    const auto of = c.of(2) == 0 ? dh_quantity_errors : dh_quantity;
    const bool ok = answered(
        of(system, c.rarely() ? nullptr : name.c_str(), p.r, p.beta, p.mu, mass, tau, size, values.data(), to_count),
        {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_DOMAIN, DH_ERROR_PRECISION, DH_ERROR_MEMORY}, "quantity");
    claim(ok ? count <= size : count == SIZE_MAX, "how many values there are is written, or untouched");
    values.check(ok, ok ? count : 0);
}

int end_at(size_t done, size_t all, void* context) {
    claim(done <= all, "no more is done than there is");
    return --*static_cast<int*>(context) < 0 ? 1 : 0;
}

// A small grid, or the same numbers as points.
void ask_points(Choices& c, const dh_system* system, std::size_t N) {
    const Point p(c);
    const std::size_t columns = 1 + c.of(3), rows = 1 + c.of(3), count = columns * rows * N;
    const std::vector<double> r = c.numbers(columns), beta = c.numbers(rows);
    const size_t mass = c.rarely() ? c.byte() : 1 + c.of(N);
    const bool all = c.of(2) == 0;
    int calls_left = c.rarely() ? 1 : 1000;
    std::vector<signed char> status(columns * rows, 99);
    std::vector<int> stops(columns * rows, 99);
    std::vector<double> amplitude(count, -99), phase(count, -99);
    const std::ptrdiff_t masses = all ? static_cast<std::ptrdiff_t>(N) : 1, length = static_cast<std::ptrdiff_t>(rows);
    bool ok = false;
    if (c.of(2) == 0) {
        const dh_map_request request{c.rarely() ? 1 : sizeof request,
                                     columns,
                                     r.data(),
                                     rows,
                                     beta.data(),
                                     p.mu,
                                     c.rarely(),
                                     1,
                                     all ? nullptr : &mass,
                                     static_cast<unsigned>(1 + c.of(2)),
                                     end_at,
                                     &calls_left,
                                     c.rarely()};
        const dh_map_result result{sizeof result,
                                   length,
                                   1,
                                   status.data(),
                                   nullptr,
                                   stops.data(),
                                   nullptr,
                                   length * masses,
                                   masses,
                                   1,
                                   c.rarely() ? nullptr : amplitude.data(),
                                   c.rarely() ? phase.data() : nullptr};
        ok = answered(dh_map(system, c.rarely() ? nullptr : &request, &result),
                      {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_PRECISION, DH_ERROR_MEMORY}, "map");
    } else {
        const dh_points_request request{sizeof request,
                                        rows,
                                        r.data(),
                                        0,
                                        beta.data(),
                                        1,
                                        p.mu,
                                        static_cast<int>(c.of(13)),
                                        1,
                                        all ? nullptr : &mass,
                                        static_cast<unsigned>(1 + c.of(2)),
                                        end_at,
                                        &calls_left,
                                        c.rarely()};
        const dh_points points{sizeof points, 1, status.data(),    nullptr, stops.data(), nullptr,
                               masses,        1, amplitude.data(), nullptr, phase.data(), nullptr};
        ok = answered(dh_solve_points(system, &request, c.rarely() ? nullptr : &points),
                      {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_PRECISION, DH_ERROR_MEMORY}, "solve_points");
    }
    for (std::size_t n = 0; n < status.size(); ++n) {
        claim(ok || (status[n] == 99 && stops[n] == 99), "what ended in a fault has written nothing");
        if (!ok || status[n] == 99) continue;
        const bool known = status[n] == DH_POINT_ANSWERED || status[n] == DH_POINT_ON_BOUNDARY;
        claim(known ? stops[n] >= 0 : stops[n] == -1, "a point has its numbers, or says that it has none");
    }
    for (const double x : amplitude) claim(x == -99 || x >= 0 || std::isnan(x), "an amplitude is not negative");
}

// Points of two systems of different size, one of them rarely missing.
void ask_systems(Choices& c, const dh_system* system, std::size_t N) {
    const SystemHandle other = from_ratios(c);
    std::size_t of_other = 1;
    if (other) claim(dh_system_masses(other.get(), &of_other, nullptr, nullptr) == DH_OK, "a system has masses");
    const std::array<const dh_system*, 4> systems{system, other ? other.get() : system, c.rarely() ? nullptr : system, system};
    const std::size_t count = 1 + c.of(4), most = count > 1 ? std::max(N, of_other) : N; // of the systems that are asked
    const std::vector<double> r = c.numbers(count), beta = c.numbers(count);
    std::vector<double> mu(count, 1);
    if (c.of(2) == 0) mu[0] = 1 + c.number();
    const size_t mass = c.rarely() ? c.byte() : 1 + c.of(N);
    const bool all = c.of(2) == 0;
    const std::size_t masses = all ? most : 1;
    int calls_left = c.rarely() ? 0 : 1000;
    std::vector<signed char> status(count, 99);
    std::vector<double> amplitude(count * masses, -99), phase(count * masses, -99);
    const dh_systems_request request{c.rarely() ? 1 : sizeof request,
                                     count,
                                     c.rarely() ? nullptr : systems.data(),
                                     1,
                                     r.data(),
                                     1,
                                     beta.data(),
                                     c.of(2) == 0 ? 0 : 1,
                                     c.rarely() ? nullptr : mu.data(),
                                     1,
                                     static_cast<int>(c.of(13)),
                                     1,
                                     all ? nullptr : &mass,
                                     static_cast<unsigned>(1 + c.of(2)),
                                     end_at,
                                     &calls_left,
                                     c.rarely()};
    const auto step = static_cast<std::ptrdiff_t>(masses);
    const dh_points points{sizeof points, 1, status.data(),    nullptr, nullptr,      nullptr,
                           step,          1, amplitude.data(), nullptr, phase.data(), nullptr};
    const bool ok =
        answered(dh_solve_systems(&request, c.rarely() ? nullptr : &points),
                 {DH_ERROR_NULL, DH_ERROR_SIZE, DH_ERROR_INPUT, DH_ERROR_PRECISION, DH_ERROR_MEMORY}, "solve_systems");
    for (std::size_t n = 0; n < count; ++n) {
        claim(ok ? status[n] >= 0 && status[n] <= DH_POINT_FAILED : status[n] == 99, "a point has its status, or is untouched");
        for (std::size_t m = 0; m < masses; ++m) {
            const double x = amplitude[n * masses + m];
            claim(ok ? x >= 0 || std::isnan(x) : x == -99, "an amplitude is not negative, or is untouched");
        }
    }
}

int count_down(void* context) { return --*static_cast<int*>(context) < 0 ? 1 : 0; }

// Sets the effort that a call may take: little, next to none, or until it is cancelled. A number that is refused changes nothing.
void set_effort(Choices& c, int& calls_left) {
    constexpr std::array<double, 4> few{operations, 1, 30, 300};
    const double asked = c.rarely() ? c.any_number() : few[c.of(few.size())];
    calls_left = c.byte();
    const bool cancels = c.rarely();
    const bool ok = answered(dh_set_effort(asked, cancels ? count_down : nullptr, &calls_left), {DH_ERROR_INPUT}, "set_effort");
    claim(ok == (asked == 0 || (asked >= 1 && asked <= 1e18)), "an effort is from 1 to 1e18, or 0");
    if (ok && (asked == 0 || asked > operations)) dh_set_effort(operations, nullptr, nullptr);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Choices c({data, size});
    int calls_left = 0;
    dh_set_effort(operations, nullptr, nullptr);
    constexpr auto asks = std::to_array(
        {ask_masses, ask_modes, ask_functions, ask_boundaries, ask_sliding, ask_solution, ask_quantity, ask_points, ask_systems});
    const SystemHandle system = system_of(c);
    std::size_t N = 1;
    if (system) claim(dh_system_masses(system.get(), &N, nullptr, nullptr) == DH_OK, "a system has masses");
    constexpr int most_calls = 6;
    for (int n = 0; n < most_calls && c.more(); ++n) {
        const std::size_t which = c.of(asks.size() + 1);
        if (which == asks.size())
            set_effort(c, calls_left);
        else
            asks[which](c, c.rarely() ? nullptr : system.get(), N);
    }
    return 0;
}
