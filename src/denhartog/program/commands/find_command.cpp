// `denhartog find`: the inverse question, the values of a number of the scene at which an amplitude is as wanted. Read `found`,
// which asks `find_places`; JSON and table come before it.
#include <CLI/CLI.hpp>
#include <memory>

#include "denhartog/number/number_text.hpp"
#include "denhartog/program/commands/commands.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/number_json.hpp"
#include "denhartog/scene/scene_rules.hpp"
#include "denhartog/solve/find.hpp"

namespace denhartog::program {
namespace {

struct FindOptions : SceneOptions {
    std::string vary, between, so_that;
    int samples = 128;
};

constexpr const char* whole = "what shows at no sample is not found";

Json found_json(const FoundPlaces& found, const FindOptions& options, const VariedNumber& varied) {
    const NumberWriter write{std::nullopt};
    Json places = Json::array();
    for (const FoundPlace& p : found.places)
        places.push_back({{"is", name_of(p.is)},
                          {"at", write(p.at)},
                          {"from", write(p.from)},
                          {"to", write(p.to)},
                          {"amplitude", write(p.amplitude)},
                          {"error_bound", write.bound(p.amplitude.error)},
                          {"proved", p.amplitude.proved}});
    Json answer{{"vary", varied.key},
                {"between", {write(varied.from), write(varied.to)}},
                {"so_that", options.so_that},
                {"places", places},
                {"complete", "not known"},
                {"complete_because", whole},
                {"unanswered", found.unanswered}};
    if (!found.why.empty()) answer["unanswered_because"] = in_words(found.why);
    answer["questions"] = found.questions;
    if (found.left_out > 0) {
        answer["left_out"] = found.left_out;
        answer["left_out_because"] = in_words(found.left_out_why);
    }
    return answer;
}

std::string found_table(const Json& a) {
    std::string text = a.at("so_that").get<std::string>() + "\n";
    if (a.at("places").empty())
        text += "at none of the samples of " + a.at("vary").get<std::string>() + ", nor between two that tell it\n";
    else
        text += aligned({a.at("vary").get<std::string>(), "from", "to", "amplitude", "error bound", ""}, a.at("places"),
                        {"at", "from", "to", "amplitude", "error_bound", "is"});
    if (const std::size_t n = a.at("unanswered").size(); n > 0)
        text += std::to_string(n) + (n == 1 ? " place has" : " places have") + " no answer, the first at " +
                in_table(a.at("unanswered").front()) + ": " + a.at("unanswered_because").get<std::string>() + "\n";
    if (a.contains("left_out"))
        text += std::to_string(a.at("left_out").get<long>()) +
                " motions over the second number have no answer and are left out, the first: " +
                a.at("left_out_because").get<std::string>() + "\n";
    return text + std::string(whole) + "; " + std::to_string(a.at("questions").get<long>()) + " motions were asked for\n\n";
}

std::string found(const SceneText& part, const FindOptions& options, Effort* effort) {
    const VariedNumber varied = interval_from(options.vary, options.between, "between");
    const FoundPlaces places = find_places(part.text, varied, wanted_from(options.so_that), options.samples,
                                           options.damping == as_given ? 0 : largest_damping_tolerance, effort, part.line);
    const Json answer = found_json(places, options, varied);
    return options.json ? answer.dump() + "\n" : found_table(answer);
}

} // namespace

void add_find_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command = app.add_subcommand("find", "What a number of a scene has to be so that an amplitude is as wanted");
    const auto options = std::make_shared<FindOptions>();
    add_scene_options(*command, *options);
    command
        ->add_option("--vary", options->vary,
                     "the number of the scene that varies: its key, such as friction, force, frequency_hz, r or beta; of a list\n"
                     "with the place, counted from 1, such as damping_ratios/2")
        ->required();
    command->add_option("--between", options->between, "the interval in which it varies, A:B")->required();
    command
        ->add_option("--so-that", options->so_that,
                     "what is wanted: \"amplitude of mass 2 = 0.075\", \"amplitude of mass 2 is least\" (or largest), or\n"
                     "\"largest amplitude of mass 2 over frequency_hz 1:10 is least\", where a second number varies")
        ->required();
    command->add_option("--samples", options->samples, "parts into which an interval is divided at first")->capture_default_str();
    command->footer(
        "The amplitude is asked for at evenly spaced places and, if the frequency varies, at the natural frequencies. Two\n"
        "neighbours at which it certainly is on different sides of the value hold a place, which is then narrowed. `from` and\n"
        "`to` are its ends: there the amplitude, with its error bound, certainly is on different sides; of an extreme, it is\n"
        "certainly less (or more) at both. `is` says what the place is:\n"
        "crossing            the amplitude passes the value\n"
        "jump                it jumps over the value: with mu above 1 another motion may take over\n"
        "undecided           it reaches the value, or only comes near: the digits do not tell; or a place without an answer\n"
        "                    lies between; or an extreme that is not certain on both sides, because others are as good\n"
        "extreme             the largest, or least, amplitude of all that were seen\n"
        "end of the interval the same, at an end of the interval\n"
        "What shows at no sample is not found: more --samples look closer. Displacements are those that\n"
        "`solve` lists, not those seen from the ground. Amplitudes are in the scene's unit of length, or in\n"
        "units of P / k_1 if it is given in ratios. An amplitude over a second number is the largest, or least, that was seen.\n"
        "Motions over it without an answer are left out, and `left_out` counts them.\n"
        "If nothing was found and some samples have no answer, the exit status is 3.");
    answer_every_scene(*command, options, status, found);
}

} // namespace denhartog::program
