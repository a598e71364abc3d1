// The common part of the subcommands that answer scenes: their options, the loop over the scenes of a file, and the place of a
// scene in the message of its error.
#include "denhartog/program/commands/scene_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "denhartog/number/effort.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/json/number_json.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog::program {
namespace {

// The object in the place of a scene without an answer; the message is a sentence for people.
std::string as_json(const InputError& e, const std::string& message) {
    return Json{{"error",
                 {{"quantity", e.quantity}, {"rule", e.rule}, {"value", e.value}, {"place", e.place}, {"message", message}}}}
               .dump() +
           "\n";
}

// A fault of a scene's key that was found after reading has its place there too. A scene of masses has a frequency in place of r.
InputError with_place(const InputError& e, const SceneText& part) {
    const bool is_key = std::ranges::find(scene_keys(), e.quantity) != scene_keys().end();
    if (!e.place.empty() || !is_key) return e;
    std::string key = e.quantity;
    if (key == "r") {
        const Json scene = Json::parse(part.text, nullptr, false);
        for (const char* dimensional_key : {"frequency", "frequency_hz"})
            if (scene.contains(dimensional_key)) key = dimensional_key;
    }
    return InputError(key, e.rule, e.value, "/" + key);
}

std::string in_place(const SceneText& part, const InputError& e) {
    const bool has_line = e.place.find("line ") != std::string::npos;
    return std::string(e.what()) + (part.alone || has_line ? "" : " (line " + std::to_string(part.line) + ")");
}

} // namespace

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command.add_option(
        "SCENE", options.scene,
        "file with one scene as JSON, or with one scene on each line (JSON Lines); standard input if it is - or missing");
    command.add_flag("--json", options.json, "one JSON object for each scene, each on a line of its own, instead of tables");
    add_effort_and_damping(command, options);
}

void add_digits_option(CLI::App& command, SceneOptions& options) {
    command.add_option("--digits", options.digits,
                       "significant digits to be reached, 1 to " + std::to_string(most_digits) +
                           "; above 15, numbers in JSON are text. If they cannot be reached, the exit status is 3");
    command.add_flag(
        "--proved", options.proved,
        "have every number proved: the reference answers, in ball arithmetic. Where it has no proof, the exit status is 3");
}

void add_one_scene_option(CLI::App& command, SceneOptions& options) {
    command.add_option("SCENE", options.scene, "file with one scene as JSON; standard input if it is - or missing");
}

void add_samples_option(CLI::App& command, int& samples, const std::string& help) {
    const auto take = [&samples](const long& given) {
        if (given < 1 || given > static_cast<long>(most_samples))
            throw InputError("samples", "must be from 1 to " + std::to_string(most_samples), std::to_string(given));
        samples = static_cast<int>(given);
    };
    CLI::Option* option = command.add_option_function<long>("--samples", take, help);
    if (samples > 0) option->default_str(std::to_string(samples));
}

void add_effort_and_damping(CLI::App& command, SceneOptions& options) {
    command.add_option(
        "--effort", options.effort,
        "work that a question may cost, in operations of about a tenth of a microsecond, each of which evaluates a mode at an "
        "instant in double. If it does not suffice, the exit status is 3. Default: 1e7, and more if there are more than 12 "
        "masses, 4.5e8 for 100");
    command
        .add_option("--damping", options.damping,
                    "how to treat a damping matrix that couples the modes: as-given includes the coupling;\n"
                    "nearest-classical leaves it out, as the paper does")
        ->check(CLI::IsMember({as_given, nearest_classical}))
        ->capture_default_str();
}

std::optional<long> allowed_operations(const std::optional<double>& effort) {
    if (!effort) return std::nullopt;
    if (!(*effort >= 1 && *effort <= 1e18))
        throw InputError("effort", "must be from 1 to 1e18 operations", number_to_text(*effort));
    return static_cast<long>(*effort);
}

SceneSource source_of(const SceneText& part, const std::string& damping, Effort* effort) {
    const SceneSource source = with_effort(scene_source(part), effort);
    return damping == as_given ? source : with_damping_tolerance(source, largest_damping_tolerance);
}

SceneText only_scene(const std::string& text) {
    const std::vector<SceneText> parts = split_scenes(text);
    if (parts.size() > 1) throw InputError("the input", "must be one scene", std::to_string(parts.size()) + " scenes");
    return parts.front();
}

void answer_scenes(const SceneOptions& options, const std::function<std::string(const SceneText&, Effort*)>& answer,
                   ExitStatus& status) {
    const std::optional<long> allowed = allowed_operations(options.effort);
    const std::string text = read_input(options.scene);
    for (const SceneText& part : split_scenes(text)) {
        std::string output;
        try {
            std::optional<QuestionEffort> effort;
            if (allowed) effort.emplace(0, allowed);
            output = answer(part, effort ? &*effort : nullptr);
        } catch (const InputError& fault) {
            const InputError e = with_place(fault, part);
            status.bad_input = true;
            report(in_place(part, e));
            if (options.json && !part.alone) output = as_json(e, e.what());
        } catch (const std::exception& e) {
            const bool short_of_digits = dynamic_cast<const PrecisionError*>(&e) != nullptr;
            const std::string why = in_own_words(e);
            status.digits_missing = true;
            report(why + (part.alone ? "" : " (line " + std::to_string(part.line) + ")"));
            if (options.json && !part.alone) {
                const InputError no_answer(short_of_digits ? "digits" : "the answer", why, "");
                output = as_json(no_answer, no_answer.rule);
            }
        }
        write_standard_output(output);
    }
}

} // namespace denhartog::program
