#include "tests/speed_accuracy/batches.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <thread>

#include "denhartog/evaluation/detail/vector_functions.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/contact_alone.hpp"
#include "tests/speed_accuracy/array_functions.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::tests {
namespace {

/// Nanoseconds an item, the least of many: on one thread of stretches of a fiftieth of a second, on several of single runs:
/// what else the machine does counts least.
double time_of(std::size_t items, int repeats, const std::function<void()>& run, unsigned threads = 1) {
    double least = std::numeric_limits<double>::infinity();
    for (int n = 0; n < repeats; ++n) {
        const double start = now(threads);
        double passed = 0, last = 0, single = least;
        int runs = 0;
        for (; passed < 2e7; ++runs) {
            run();
            passed = now(threads) - start;
            single = std::min(single, passed - last);
            last = passed;
        }
        least = std::min(least, threads == 1 ? passed / runs : single);
    }
    return least / static_cast<double>(items);
}

struct Rates {
    Table& table;
    int repeats;

    void add(const std::string& what, double time, const std::string& limit, double bare) {
        table.rows.push_back({what, digits(time), limit, digits(bare), digits(time / bare)});
    }
};

double ulps(double found, long double exact) {
    int exponent = 0;
    (void)std::frexp(static_cast<double>(exact), &exponent);
    return static_cast<double>(std::abs(found - exact) / std::ldexp(1.0L, exponent - 53));
}

} // namespace

Table batch_speed(int repeats) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    Table table{
        "Batches beside their limits",
        {"what", "ns", "limit", "ns of the limit", "ratio"},
        {},
        "Least of " + std::to_string(repeats) +
            " runs: processor time on one thread, time by the clock on several. Limits: the compiler's vector maths library, or "
            "the functions of evaluation/detail/vector_functions.hpp by themselves, for one exp, one sine and one cosine; one "
            "square "
            "root. Widest vectors: " +
            evaluation::name(evaluation::supported_vectors().back()) + "."};
    Rates rates{table, repeats};
    constexpr std::size_t n = 1024;
    std::vector<double> a(n), b(n), c(n), d(n);
    std::vector<std::uint8_t> marks(n);
    const std::vector<double> x = grid(-3, 2.9, n);
    const double library = time_of(n, repeats, [&] { bare_functions(x, a, b, c); });
    const double own = time_of(n, repeats, [&] { own_functions(x, a, b, c); });
    const std::string of_library = "exp, sin, cos of the compiler's library", of_own = "own exp, sin cos, cos^2";
    rates.add("exp, sin cos, cos^2 of vector_functions.hpp, an argument", own, of_library, library);
    for (const auto& [name, from, to] :
         {std::tuple("below 5/4", 0.05, 1.24), std::tuple("0.05 to 2.5", 0.05, 2.5), std::tuple("of 5/4 and more", 1.25, 50.0)}) {
        const std::vector<double> R = grid(from, to, n);
        for (const evaluation::Vectors vectors : evaluation::supported_vectors()) {
            const double time = time_of(n, repeats, [&] { evaluation::mode_functions(R, 0.01, {a, b, c, d, marks}, vectors); });
            rates.add(std::string("v, u, g, R ") + name + ", an (r, mode), " + evaluation::name(vectors), time, of_own, own);
            if (vectors == evaluation::supported_vectors().back())
                rates.add(std::string("v, u, g, R ") + name + ", an (r, mode), " + evaluation::name(vectors), time, of_library,
                          library);
        }
        const double scalar = time_of(n, repeats, [&] {
            for (std::size_t i = 0; i < n; ++i) a[i] = evaluation::mode_functions(R[i], 0.01).u;
        });
        rates.add(std::string("v, u, g, R ") + name + ", an (r, mode), scalar forms", scalar, of_library, library);
    }
    const System<double> five = five_masses<double>(3, 0.01);
    const ModalBasis<Bounded<double>> basis = with_errors(five, modal_basis(five));
    const std::vector<double> r = grid(1, 2.5, 10000);
    std::vector<unsigned> threads{1};
    if (cores > 1) threads.push_back(cores);
    const auto on = [](unsigned each) { return ", threads: " + std::to_string(each); };
    ContactSums sums;
    for (const unsigned each : threads) {
        const double time = time_of(
            5 * r.size(), repeats, [&] { contact_sums(basis, five.contact, five.load, r, each, sums); }, each);
        rates.add("modes and all sums of five masses, an (r, mode)" + on(each), time, of_own, own / each);
    }
    std::vector<double> squares(r.size(), 0.5), roots(r.size());
    const double root = time_of(squares.size(), repeats, [&] { bare_roots(squares, roots); });
    ContactLimits found;
    rates.add("beta_lim (69) and sticking, an r", time_of(r.size(), repeats, [&] { contact_limits(sums, 1, 1, found); }),
              "square root", root);
    table.note +=
        "\nOf these certain: " + std::to_string(std::ranges::count(found.certain, 1)) + " of " + std::to_string(r.size()) + ".";
    const std::vector<double> beta = grid(0, 0.5, 1024);
    std::vector<double> X(beta.size());
    rates.add("X_j, an (r, beta)",
              time_of(beta.size(), repeats,
                      [&] {
                          contact_amplitudes({2, 1}, 0.5, 0.25, beta, X);
                      }),
              "square root", root);
    Scene<double> scene;
    scene.system = five;
    const std::atomic<bool> never{false};
    MapRequest request{grid(1, 2.5, 500), {}, {five.contact}, MapStart::rest, 1};
    request.beta = grid(0, 0.999 * least_boundary(scene, request.r), 500);
    for (const unsigned each : threads) {
        request.threads = each;
        const double time = time_of(
            request.r.size() * request.beta.size(), repeats, [&] { (void)regime_map(scene, request, never); }, each);
        rates.add("a whole map of sliding points, an (r, beta)" + on(each), time, "square root", root / each);
    }
    return table;
}

Table vector_function_errors() {
    constexpr std::size_t n = 1 << 20;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> angle(-3.125, 3.125), turn(0, 0.25);
    std::vector<double> x(n), exps(n), sines(n), cosines(n);
    for (double& each : x) each = angle(random);
    bare_functions(x, exps, sines, cosines);
    double of_exp = 0, of_sin = 0, of_cos = 0, own_exp = 0, own_difference = 0, own_product = 0, own_square = 0;
    const long double half_circle = pi<long double>();
    for (std::size_t i = 0; i < n; ++i) {
        const long double y = std::abs(x[i]);
        of_exp = std::max(of_exp, ulps(exps[i], std::exp(-y)));
        of_sin = std::max(of_sin, ulps(sines[i], std::sin(static_cast<long double>(x[i]))));
        of_cos = std::max(of_cos, ulps(cosines[i], std::cos(static_cast<long double>(x[i]))));
        const evaluation::Exponential<double> e = evaluation::exponential_of_negative(-std::abs(x[i]));
        own_exp = std::max(own_exp, ulps(e.head * e.tail, std::exp(-y)));
        own_difference = std::max(own_difference, ulps(e.E_minus_one, std::expm1(-y)));
        const double z = turn(random);
        const evaluation::HalfAngleProducts<double> h = evaluation::half_angle_products(0.5, 1, z, 0);
        const long double s = std::sin(half_circle * z), c = std::cos(half_circle * z);
        own_product = std::max(own_product, ulps(h.sine_cosine, s * c));
        own_square = std::max(own_square, ulps(h.cosine_square, c * c));
    }
    return {"Errors of vector functions, units in the last place, " + std::to_string(n) + " seeded arguments",
            {"function", "compiler's vector library", "evaluation/detail/vector_functions.hpp"},
            {{"exp(-y)", digits(of_exp), digits(own_exp)},
             {"exp(-y) - 1", "", digits(own_difference)},
             {"sin(x)", digits(of_sin), ""},
             {"cos(x)", digits(of_cos), ""},
             {"sin(pi z) cos(pi z)", "", digits(own_product)},
             {"cos(pi z)^2", "", digits(own_square)}},
            "x from -3.125 to 3.125, y from 0 to 3.125, z from 0 to 1/4."};
}

} // namespace denhartog::tests
