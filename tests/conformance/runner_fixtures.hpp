/// @file
/// @brief Small folders of vectors, and programs under test as lines of shell, for the tests of the runner.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "conformance/vector.hpp"
#include "tests/unit/program_runs.hpp"

namespace denhartog::tests {

/// @brief A vector of a chain of two masses. Only the runner is tested with it: its value need not be true.
inline conformance::Vector vector_of(const std::string& id, const std::string& quantity, const std::vector<double>& value,
                                     const std::string& tier = "must") {
    conformance::Vector v;
    v.question = {id, quantity, {1, 2.5}, {1, 0.625}, {0.0625, 0.125}, 2, 1, 1.25, 1.125, 0.125, 0, 0, 0};
    if (conformance::quantity(quantity).of_mass) v.question.mass = 1;
    v.group = id.substr(0, id.find('-'));
    v.equation = conformance::quantity(quantity).equation;
    v.tier = tier;
    double largest = 0;
    for (const double x : value) {
        char text[64];
        std::snprintf(text, sizeof text, "%.40g", x);
        v.value.emplace_back(text);
        largest = std::max(largest, std::abs(x));
    }
    v.nearest = value;
    v.scale = largest > 0 && !conformance::quantity(quantity).angle ? largest : 1;
    v.condition = {{"r", 2}};
    v.regime = "continuous";
    v.tolerance = {1e-12, 1e-9, 1e-3};
    v.routes = {"by hand", "by hand"};
    v.digits = {40, 40};
    return v;
}

inline conformance::Vector word_vector(const std::string& id, const std::string& word) {
    conformance::Vector v = vector_of(id, "regime", {});
    v.word = v.regime = word;
    return v;
}

inline conformance::Vector reject_vector(const std::string& id) {
    conformance::Vector v = vector_of(id, "H_j", {});
    v.question.mu = 0.5;
    v.reject = "mu must be at least 1";
    v.regime.clear();
    return v;
}

/// @brief Six vectors of every kind.
inline std::vector<conformance::Vector> six_vectors() {
    return {vector_of("modes-1", "modal_frequency_ratios", {1.5, 0.75}),
            vector_of("amplitude-1", "amplitude", {0.25}),
            vector_of("amplitude-2", "amplitude", {0.5}, "stress"),
            word_vector("regime-1", "continuous"),
            reject_vector("reject-1"),
            vector_of("phase-1", "phase", {3.0}, "should")};
}

inline const std::string right_answers =
    "modes-1 value 1.5 0.75\namplitude-1 value 0.25\namplitude-2 value 0x1p-1\nregime-1 value continuous\n"
    "reject-1 reject mu below 1\nphase-1 value 3\n";

/// @brief A folder of vectors, a file a group.
inline std::string folder_of(const std::string& name, const std::vector<conformance::Vector>& vectors) {
    const std::filesystem::path folder = scratch() / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    for (const conformance::Vector& v : vectors)
        std::ofstream(folder / (v.group + ".jsonl"), std::ios::app) << conformance::vector_json(v).dump() << '\n';
    return folder.string();
}

/// @brief A shell script.
inline std::string script(const std::string& name, const std::string& text) { return "bash " + file_with(name, text).string(); }

/// @brief A program that answers from a table, in the plain dialect; what is not in it is skipped.
inline std::string table_program(const std::string& name, const std::string& answers) {
    const std::string table = file_with(name + ".table", answers).string();
    return script(name + ".sh", "declare -A t\nwhile read -r id rest; do t[$id]=\"$id $rest\"; done < '" + table +
                                    "'\nread -r greeting\necho 'denhartog-conform 1 plain Table of answers'\n"
                                    "while read -r id rest; do echo \"${t[$id]:-$id skip not in the table}\"; done\n");
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

inline bool contains(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

/// @brief The folder of `six_vectors`.
inline const std::string& six() {
    static const std::string folder = folder_of("six", six_vectors());
    return folder;
}

inline std::string with_vectors(const std::string& folder, const std::string& rest) {
    return "--vectors '" + folder + "' " + rest;
}

inline Run conform(const std::string& arguments) { return run_program("conform " + arguments); }

} // namespace denhartog::tests
