// The functions of the C++ interface. Each reads its scene, asks the part of the library that answers, and adds no number of its
// own.
#include "denhartog/denhartog.hpp"

#include <algorithm>
#include <thread>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/solve/solve.hpp"

namespace denhartog {

Scene<double> scene(std::string_view json) { return read_scene<double>(json); }

Solution solve(const Scene<double>& scene, const Question& question) { return solve(source_of_kept(scene), question); }

Limits boundary(const Scene<double>& scene, std::optional<int> digits) {
    const Solution s = sliding_answer(without_friction_ratio(source_of_kept(scene)), digits, false);
    return *s.limits;
}

RegimeMap map(const Scene<double>& scene, const std::vector<double>& r, const std::vector<double>& beta) {
    MapRequest request{r, beta, {}, MapStart::rest, std::max(1U, std::thread::hardware_concurrency())};
    for (std::size_t k = 0; k < number_of_masses(scene.system); ++k) request.masses.push_back(Mass{k});
    const std::atomic<bool> stop{false};
    return regime_map(scene, request, stop);
}

SampledSolution motion(const Scene<double>& scene, std::size_t samples) {
    check_samples("samples", samples, std::max<std::size_t>(number_of_masses(scene.system), 1));
    return sampled_solution(source_of_kept(scene), solve(scene), samples);
}

Energies energies(const Scene<double>& scene, std::optional<int> digits) {
    const SceneSource source = source_of_kept(scene);
    Question question;
    question.digits = digits;
    return energies(source, solve(source, question), digits);
}

} // namespace denhartog
