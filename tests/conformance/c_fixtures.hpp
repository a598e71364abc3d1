/// @file
/// @brief Scenes and handles for the tests of the C interface.
#pragma once

#include <denhartog.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/support/scene_builder.hpp"

namespace denhartog::tests {

/// @brief Destroys what the C interface made.
struct Destroy {
    void operator()(dh_system* system) const { dh_system_destroy(system); }
    void operator()(dh_solution* solution) const { dh_solution_destroy(solution); }
};
using Handle = std::unique_ptr<dh_system, Destroy>;
using Answered = std::unique_ptr<dh_solution, Destroy>;

/// @brief The scenes of the tests: one mass and more, j < l, j = l, j > l, mu above 1, every regime, a heavily damped mode.
inline std::vector<Scene<double>> c_scenes() {
    const System<double> one = chain_of({1}, {1}, {0.0625}, 1, 1);
    const System<double> two = chain_of({1, 2.5}, {1, 0.625}, {0.0625, 0.125}, 2, 1);
    const System<double> three = chain_of({1, 0.5, 2}, {1, 1.5, 0.75}, {0.03125, 1.5, 0.25}, 1, 3);
    const auto at = [](const System<double>& s, double mu, double r, double beta) { return scene_of(s, r, beta, mu); };
    return {at(two, 1.25, 1.125, 0.125),  at(one, 1.0, 0.75, 0.5),  at(one, 1.0, 0.25, 0.8125), at(one, 1.5, 0.75, 1.0),
            at(three, 1.0, 0.625, 0.125), at(two, 1.0, 0.25, 0.25), at(two, 1.25, 0.5, 2.0),    at(three, 1.5, 1.5, 0.03125)};
}

/// @brief The handle of a system. @param s the system @return its handle; throws where there is none
inline Handle handle_of(const System<double>& s) {
    dh_system* system = nullptr;
    if (dh_system_from_ratios(s.mass_ratios.size(), s.mass_ratios.data(), s.stiffness_ratios.data(), s.damping_ratios.data(),
                              s.contact.index + 1, s.load.index + 1, &system) != DH_OK)
        throw std::runtime_error(dh_last_message());
    return Handle(system);
}

/// @brief The handle of a scene's system. @param text its JSON @return its handle; throws where there is none
inline Handle handle_of(const std::string& text) {
    dh_system* system = nullptr;
    if (dh_system_from_json(text.data(), text.size(), &system) != DH_OK) throw std::runtime_error(dh_last_message());
    return Handle(system);
}

/// @brief The two computations are the same: not a digit may differ, and what is no number in one is none in the other.
inline void check_same(const std::vector<double>& found, const std::vector<double>& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t n = 0; n < found.size(); ++n) {
        INFO("number " << n << ": " << hexadecimal(found[n]) << " for " << hexadecimal(expected[n]));
        CHECK((found[n] == expected[n] || (std::isnan(found[n]) && std::isnan(expected[n]))));
    }
}

/// @brief A struct of the interface that knows its size. @return all else zero
template <class Struct>
[[nodiscard]] Struct sized() {
    Struct s{};
    s.size = sizeof s;
    return s;
}

/// @brief A request for a map; r and beta must outlive it. @return the request
inline dh_map_request map_request(const std::vector<double>& r, const std::vector<double>& beta, double mu) {
    auto request = sized<dh_map_request>();
    request.r_count = r.size();
    request.r = r.data();
    request.beta_count = beta.size();
    request.beta = beta.data();
    request.mu = mu;
    return request;
}

/// @brief The solution at a point, to some digits. @return its handle; throws where there is none
inline Answered solved(const dh_system* system, double r, double beta, double mu, int digits = 0) {
    dh_solution* solution = nullptr;
    if (dh_solve(system, r, beta, mu, digits, &solution) != DH_OK) throw std::runtime_error(dh_last_message());
    return Answered(solution);
}

/// @brief The summary of a solution. @return the summary
inline dh_summary summary_of(const dh_solution* solution) {
    auto all = sized<dh_summary>();
    REQUIRE(dh_solution_summary(solution, &all) == DH_OK);
    return all;
}

/// @brief The motion of a mass, from 1 on, or of the contact. @return its numbers
inline dh_mass mass_of(const dh_solution* solution, std::size_t k) {
    auto mass = sized<dh_mass>();
    REQUIRE(dh_solution_mass(solution, k, &mass) == DH_OK);
    return mass;
}
inline dh_mass contact_of(const dh_solution* solution) {
    auto mass = sized<dh_mass>();
    REQUIRE(dh_solution_contact(solution, &mass) == DH_OK);
    return mass;
}

/// @brief The amplitudes at a point. @return N amplitudes; none where a call fails
inline std::vector<double> amplitudes(const dh_system* system, double r, double beta, double mu) {
    dh_solution* made = nullptr;
    std::size_t N = 0;
    if (dh_system_masses(system, &N, nullptr, nullptr) != DH_OK || dh_solve(system, r, beta, mu, 0, &made) != DH_OK) return {};
    const Answered solution(made);
    std::vector<double> all(N);
    for (std::size_t k = 0; k < N; ++k) {
        auto mass = sized<dh_mass>();
        if (dh_solution_mass(made, k + 1, &mass) != DH_OK) return {};
        all[k] = mass.amplitude;
    }
    return all;
}

} // namespace denhartog::tests
