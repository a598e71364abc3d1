/// @file
/// @brief What the subcommands that answer scenes share: options, the walk over the scenes, errors in their place.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/program/exit_status.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

inline constexpr const char* as_given = "as-given";                   ///< damping that couples the modes is taken in
inline constexpr const char* nearest_classical = "nearest-classical"; ///< the paper's approximation: the coupling is left out

/// @brief Options of a subcommand that answers scenes.
struct SceneOptions {
    std::string scene;             ///< path; empty or `-` for standard input
    bool json = false;             ///< JSON in place of tables
    std::optional<int> digits;     ///< significant digits asked for
    bool proved = false;           ///< whether every number must be proved
    std::optional<double> effort;  ///< operations allowed a scene
    std::string damping{as_given}; ///< `as_given` or `nearest_classical`
};

/// @brief A scene as the options have it. @param part its text @param damping the option `--damping` @return the scene
[[nodiscard]] SceneSource source_of(const SceneText& part, const std::string& damping);

/// @brief Adds `--damping`.
/// @param command  the subcommand
/// @param damping  where it goes; must outlive the parse
void add_damping_option(CLI::App& command, std::string& damping);

/// @brief Adds SCENE and `--json` to a subcommand.
/// @param command  the subcommand
/// @param options  where they go; must outlive the parse
void add_scene_options(CLI::App& command, SceneOptions& options);

/// @brief Adds `--digits`.
/// @param command  the subcommand
/// @param options  where it goes; must outlive the parse
void add_digits_option(CLI::App& command, SceneOptions& options);

/// @brief Adds `--effort`.
/// @param command  the subcommand
/// @param effort   where it goes; must outlive the parse
void add_effort_option(CLI::App& command, std::optional<double>& effort);

/// @brief The work that a user allows. @param effort of the command line @return operations; none where none are given
/// @throws InputError where it is no such number
[[nodiscard]] std::optional<long> allowed_operations(const std::optional<double>& effort);

/// @brief Answers every scene of the input in order, each written when it is complete.
///
/// A fault of a scene is a line on standard error; among JSON Lines it is also an object `{"error": {...}}` in the scene's place.
/// @param options  the options
/// @param answer   from the text of a scene to what is printed, its line end included
/// @param status   where faults are noted
/// @throws         InputError where the input cannot be read or the output not be written
void answer_scenes(const SceneOptions& options, const std::function<std::string(const SceneText&)>& answer, ExitStatus& status);

/// @brief The answer to a scene, with what makes it none put in words for its author.
/// @param source   the scene
/// @param options  digits, and whether they must be proved
/// @return         the answer, to the digits asked for
/// @throws        InputError; PrecisionError where the digits asked for are not reached
[[nodiscard]] Solution answer_or_reason(const SceneSource& source, const SceneOptions& options);

/// @brief A formula asked for at a pole, as a fault of the scene's r.
/// @param e  the error
/// @return   the same as bad input
[[nodiscard]] InputError at_a_pole(const DomainError& e);

} // namespace denhartog::program
