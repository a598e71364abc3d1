// The library in double against the certified vectors.
#include <algorithm>
#include <cmath>
#include <map>

#include "conformance/vector.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/systems_in_double.hpp"
#include "tests/conformance/vector_folder.hpp"

using namespace denhartog;
using namespace denhartog::tests;
using conformance::quantity;
using conformance::Vector;

namespace {

using Numbers = std::vector<double>;
using Asks = conformance::ProtocolQuestion;

std::size_t mass_of(const Asks& q) { return q.mass > 0 ? static_cast<std::size_t>(q.mass - 1) : 0; }

Numbers of_modes(const Asks& q, const Scene<double>& scene) {
    const ModalBasis<double> basis = modal_basis(scene.system);
    if (q.quantity == "natural_frequency_ratios") return basis.r_n;
    Numbers all;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const auto mode = static_cast<Eigen::Index>(i);
        all.push_back(q.quantity == "modal_frequency_ratios"
                          ? q.r / basis.r_n[i]
                          : basis.phi(q.mass - 1, mode) * basis.phi(q.contact - 1, mode) / (q.r * q.r));
    }
    return all;
}

Numbers of_sums(const Asks& q, const Scene<double>& scene) {
    const ModalBasis<double> basis = modal_basis(scene.system);
    return numbers_of_sums(q, mode_sums(basis, scene.system.contact, scene.system.load, q.r), mass_of(q));
}

Numbers of_stuck_motion(const Asks& q, const Scene<double>& scene) {
    const StuckConfiguration stuck = stuck_configuration(scene.system, modal_basis(scene.system));
    const StuckResponse held = stuck_response(stuck, scene.system.load, q.r);
    if (q.quantity == "rest_interval")
        return {paper::sticking_margin(modulus(held.contact_load), q.mu, q.beta) / stuck.k_contact};
    const StuckMass& m = held.masses[mass_of(q)];
    if (q.quantity == "amplitude") return {m.amplitude};
    if (q.quantity == "phase") return {m.phase.value()};
    Numbers x;
    for (int n = 0; n < q.samples; ++n) {
        const double tau = 2 * n * pi<double>() / q.samples;
        x.push_back(m.X.re * std::cos(tau) - m.X.im * std::sin(tau));
    }
    return x;
}

Numbers of_stick_slip(const Asks& q, const Scene<double>& scene) {
    const Solution solution = solve(scene_source(scene), {Asked::motion, 12, false});
    const SolvedMass& m = solution.masses[mass_of(q)];
    if (q.quantity == "amplitude") return Numbers{m.amplitude.value};
    if (q.quantity == "phase") return Numbers{m.phase.value().value};
    Numbers all;
    for (const SolvedStop& stop : solution.stops) all.push_back(stop.end.value - stop.start.value);
    std::sort(all.begin(), all.end());
    if (q.quantity == "stops_per_period") return Numbers{static_cast<double>(all.size())};
    if (q.quantity == "stop_durations") return all;
    State start;
    for (const Certified& x : solution.start.value().x) start.x.push_back(x.value);
    for (const Certified& v : solution.start.value().x_prime) start.x_prime.push_back(v.value);
    const ContactSystem system = contact_system(scene.system);
    ExactSolver solver(system, {q.r, q.beta, q.mu});
    Numbers samples;
    for (int n = 0; n < q.samples; ++n)
        samples.push_back(n == 0 ? start.x[mass_of(q)]
                                 : solver.run(start, 0, 2 * n * pi<double>() / q.samples).end.x[mass_of(q)]);
    return samples;
}

bool is_of_modes(const std::string& name) {
    return name == "natural_frequency_ratios" || name == "modal_frequency_ratios" || name == "mode_shape_products";
}

Numbers in_double(const Vector& v) {
    const Asks& q = v.question;
    if (!is_of_the_paper(q)) return answer_of_system(q).value().numbers;
    const Scene<double> scene = conformance::scene_of(q);
    if (is_of_modes(q.quantity)) return of_modes(q, scene);
    if (q.quantity == "beta_lim_high_frequency") return {paper::friction_ratio_limit_at_high_frequency(q.mu)};
    if (!v.margin || v.regime == "continuous") return of_sums(q, scene);
    return v.regime == "stick_slip" ? of_stick_slip(q, scene) : of_stuck_motion(q, scene);
}

// Largest error over scale; infinite where numbers are missing.
double error_of(const Vector& v, const Numbers& x) {
    if (x.size() != v.nearest.size()) return INFINITY;
    double largest = 0;
    for (std::size_t n = 0; n < x.size(); ++n) {
        double difference = x[n] - v.nearest[n];
        if (quantity(v.question.quantity).angle) difference = std::remainder(difference, 2 * pi<double>());
        if (!std::isfinite(difference)) return INFINITY;
        largest = std::max(largest, std::abs(difference));
    }
    return largest / v.scale;
}

double error_in_double(const Vector& v) {
    try {
        return error_of(v, in_double(v));
    } catch (const std::exception& e) {
        WARN(v.question.id << ": " << e.what());
        return INFINITY;
    }
}

} // namespace

TEST_CASE("the library in double reproduces every vector that must or should be reproduced", "[conformance][vectors]") {
    std::map<std::string, std::pair<double, std::string>> worst; // largest error over what passes, by tier
    std::size_t compared = 0;
    for (const Vector& v : vectors()) {
        if (v.value.empty() || v.tier == "stress") continue;
        const double error = error_in_double(v);
        INFO(v.question.id << " " << v.question.quantity << ": error " << hexadecimal(error) << ", passes up to "
                           << hexadecimal(v.tolerance.pass));
        CHECK(error <= v.tolerance.pass);
        ++compared;
        if (v.tolerance.pass > 0 && error / v.tolerance.pass >= worst[v.tier].first)
            worst[v.tier] = {error / v.tolerance.pass, v.question.id};
    }
    for (const auto& [tier, which] : worst)
        std::printf("%s: largest error %.2g of what passes, in %s\n", tier.c_str(), which.first, which.second.c_str());
    CHECK(compared > 1200);
}

TEST_CASE("in the stress tier the library in double is never wrong", "[conformance][vectors]") {
    std::vector<double> digits;
    std::size_t passed = 0;
    for (const Vector& v : vectors()) {
        if (v.value.empty() || v.tier != "stress") continue;
        const double error = error_in_double(v);
        INFO(v.question.id << " " << v.question.quantity << ": error " << hexadecimal(error));
        CHECK(error <= v.tolerance.inaccurate);
        if (error <= v.tolerance.pass) ++passed;
        digits.push_back(error > 0 ? -std::log10(error) : 16);
    }
    REQUIRE(digits.size() > 50);
    std::sort(digits.begin(), digits.end());
    std::printf("stress: %zu of %zu pass; digits: least %.1f, median %.1f\n", passed, digits.size(), digits.front(),
                digits[digits.size() / 2]);
    CHECK(10 * passed >= 9 * digits.size());
}

TEST_CASE("the library finds the regime of every vector that asks for it, and rejects what has to be rejected",
          "[conformance][vectors]") {
    int regimes = 0, rejected = 0;
    for (const Vector& v : vectors()) {
        INFO(v.question.id);
        if (!v.reject.empty()) {
            CHECK_THROWS_AS(conformance::scene_of(v.question), InputError);
            ++rejected;
        } else if (!v.word.empty() && !is_of_the_paper(v.question)) {
            CHECK(answer_of_system(v.question).value().word == v.word);
            ++regimes;
        } else if (!v.word.empty()) {
            const Scene<double> scene = conformance::scene_of(v.question);
            const ModeSums<double> s = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
            CHECK(name(regime_of(boundary(s, scene.mu), *scene.beta)) == v.word);
            ++regimes;
        }
    }
    CHECK(regimes > 60);
    CHECK(rejected >= 30);
}
