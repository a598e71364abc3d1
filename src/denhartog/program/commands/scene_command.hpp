// Common parts of the subcommands that answer scenes: options, the walk over the scenes, errors in their place.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "denhartog/number/errors.hpp"
#include "denhartog/program/exit_status.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/solve.hpp"

namespace denhartog::program {

inline constexpr const char* as_given = "as-given";                   // damping that couples the modes is taken in
inline constexpr const char* nearest_classical = "nearest-classical"; // the paper's approximation: the coupling is left out

// Options of a subcommand that answers scenes; they must outlive the parse.
struct SceneOptions {
    std::string scene;             // path; empty or `-` for standard input
    bool json = false;             // JSON in place of tables
    std::optional<int> digits;     // significant digits asked for
    bool proved = false;           // whether every number must be proved
    std::optional<double> effort;  // operations allowed a scene
    std::string damping{as_given}; // `as_given` or `nearest_classical`
};

// Adds SCENE, `--json`, `--effort` and `--damping`.
void add_scene_options(CLI::App& command, SceneOptions& options);

// Adds `--digits` and `--proved`.
void add_digits_option(CLI::App& command, SceneOptions& options);

// Adds SCENE for a subcommand that answers one.
void add_one_scene_option(CLI::App& command, SceneOptions& options);

// Adds `--samples`, a number of instants from 1 on, up to the most that can be printed.
void add_samples_option(CLI::App& command, int& samples, const std::string& help);

// Adds `--effort` and `--damping`.
void add_effort_and_damping(CLI::App& command, SceneOptions& options);

// The work that a user allows, in operations; none where `--effort` is not given. Throws InputError where it is no such number.
[[nodiscard]] std::optional<long> allowed_operations(const std::optional<double>& effort);

// A scene as the options have it, with the work that may be spent on it.
[[nodiscard]] SceneSource source_of(const SceneText& part, const std::string& damping, Effort* effort = nullptr);

// The only scene of a text, which must outlive it. Throws InputError where there are several.
[[nodiscard]] SceneText only_scene(const std::string& text);

// Answers every scene of the input in order, each written when it is complete; `answer` gives what is printed, its line end
// included; it gets the work that the user allows, null where that is not said. A fault of a scene is a line on standard error;
// among JSON Lines it is also an object `{"error": {...}}` in the scene's place. Throws InputError where the input cannot be read
// or the output not be written.
void answer_scenes(const SceneOptions& options, const std::function<std::string(const SceneText&, Effort*)>& answer,
                   ExitStatus& status);

// The answer of `ask`; a pole of a formula is a fault of the scene's r.
template <class Ask>
auto off_poles(const Ask& ask) {
    try {
        return ask();
    } catch (const DomainError& e) {
        throw InputError("r", std::string("must not be at a pole: ") + e.what(), "");
    }
}

// Makes a subcommand answer every scene of its input; its options must outlive the parse.
template <class Options>
void answer_every_scene(CLI::App& command, const std::shared_ptr<Options>& options, ExitStatus& status,
                        std::string (*answer)(const SceneText&, const Options&, Effort*)) {
    const auto answered = [options, answer](const SceneText& part, Effort* effort) {
        return off_poles([&] { return answer(part, *options, effort); });
    };
    command.callback([options, answered, &status] { answer_scenes(*options, answered, status); });
}

} // namespace denhartog::program
