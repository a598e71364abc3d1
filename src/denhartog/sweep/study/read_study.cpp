// A study from its JSON text.
#include <algorithm>
#include <array>
#include <cmath>

#include "denhartog/number/errors.hpp"
#include "denhartog/scene/other_documents.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/sweep/study/study_items.hpp"

namespace denhartog::sweep {
namespace {

constexpr std::size_t deepest_of_a_study = 6;
constexpr std::uint64_t points_of_a_chunk_by_default = 1'000'000;
constexpr std::uint64_t most_points_of_a_chunk = std::uint64_t(1) << 24;

constexpr auto keys = std::to_array<std::string_view>(
    {"comment", "scene", "axes", "samples", "answers", "masses", "start", "effort", "reduce", "points_of_a_chunk"});
constexpr auto answers = std::to_array<std::string_view>({"regime", "amplitudes", "phases", "stops"});
constexpr auto starts = std::to_array<std::string_view>({"rest", "sliding"});

void check_targets(const Study& study) {
    std::vector<Target> targets;
    for (const Axis& each : study.axes) targets.push_back(each.target);
    if (study.samples)
        for (const Variable& each : study.samples->variables) targets.push_back(each.target);
    for (std::size_t n = 0; n < targets.size(); ++n)
        for (std::size_t m = 0; m < n; ++m)
            if (targets[n] == targets[m]) throw InputError(targets[n].name(), "must not vary twice", "");
}

std::vector<Mass> read_masses(const Item& item, std::size_t N) {
    std::vector<Mass> masses;
    for (const Item& each : item.entries()) {
        masses.push_back({each.whole(1, N) - 1});
        if (std::ranges::count(masses, masses.back()) > 1) each.fail("must not be given twice");
    }
    return masses;
}

Answers read_answers(const Item& item) {
    Answers asked;
    for (const Item& each : item.entries()) {
        bool* const all[] = {&asked.regime, &asked.amplitudes, &asked.phases, &asked.stops};
        *all[each.one_of(answers)] = true;
    }
    return asked;
}

} // namespace

Study read_study(std::string_view text) {
    const nlohmann::json json = read_json(text, 1, "study", deepest_of_a_study);
    const Item item(json, "study", "");
    item.allow(keys, "a study");
    Study study;
    study.scene = item["scene"].json();
    if (!study.scene.is_object()) item["scene"].fail("must be a JSON object");
    const std::size_t N = number_of_masses(scene_from_json<double>(study.scene).system);
    if (item.has("axes"))
        for (const Item& each : item["axes"].entries()) study.axes.push_back(read_axis(each));
    if (item.has("samples")) study.samples = read_samples(item["samples"]);
    check_targets(study);
    if (item.has("reduce"))
        for (const Item& each : item["reduce"].entries()) study.reductions.push_back(read_reduction(each));
    if (item.has("answers"))
        study.answers = read_answers(item["answers"]);
    else if (study.reductions.empty())
        study.answers.regime = study.answers.amplitudes = true;
    if (item.has("masses"))
        study.masses = read_masses(item["masses"], N);
    else
        study.masses = {scene_from_json<double>(study.scene).system.contact};
    if (item.has("start")) study.start = static_cast<MapStart>(item["start"].one_of(starts));
    if (item.has("effort")) study.effort = static_cast<long>(item["effort"].whole(1, 1'000'000'000'000'000));
    study.points_of_a_chunk = points_of_a_chunk_by_default;
    if (item.has("points_of_a_chunk")) study.points_of_a_chunk = item["points_of_a_chunk"].whole(1, most_points_of_a_chunk);
    return study;
}

} // namespace denhartog::sweep
