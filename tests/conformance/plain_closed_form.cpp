#include "conformance/plain/closed_form.hpp"

#include <cmath>
#include <cstdio>
#include <map>

#include "conformance/vector.hpp"
#include "conformance/verdict.hpp"
#include "denhartog/scene/scene.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/seeded_questions.hpp"
#include "tests/conformance/vector_folder.hpp"
#include "tests/support/plain_response.hpp"

using namespace denhartog;
using namespace denhartog::conformance;

namespace {

void agree(ProtocolQuestion q, const std::string& quantity, double truth, double size, double tolerance) {
    q.quantity = quantity;
    const std::optional<Value> value = plain_answer(q);
    INFO(question_plain(q) << " has " << std::hexfloat << truth);
    REQUIRE(value);
    REQUIRE(value->numbers.size() == 1);
    INFO("and the plain closed form " << std::hexfloat << value->numbers.front());
    CHECK(std::abs(value->numbers.front() - truth) <= tolerance * size);
}

} // namespace

TEST_CASE("the plain closed form without a mistake agrees with the response on seeded scenes",
          "[eq:38][eq:46][eq:69][conformance]") {
    int sliding = 0;
    for (ProtocolQuestion q : tests::seeded_questions(7, 60)) {
        const Response<double> truth = response(scene_of(q));
        agree(q, "beta_lim_exact", truth.boundary.exact, truth.boundary.exact, 1e-10);
        agree(q, "beta_lim_paper", truth.boundary.paper, truth.boundary.paper, 1e-10);
        agree(q, "beta_lim_approximate", truth.boundary.approximate, truth.boundary.approximate, 1e-10);
        agree(q, "beta_lim_sticking", *truth.boundary.sticking, *truth.boundary.sticking, 1e-10);
        agree(q, "S_j", truth.boundary.S_exact, truth.boundary.S_exact, 1e-10);
        if (!truth.steady_state) continue;
        ++sliding;
        for (std::size_t k = 0; k < q.mass_ratios.size(); ++k) {
            const MassResponse<double>& mass = truth.steady_state->masses[k];
            q.mass = static_cast<int>(k) + 1;
            agree(q, "amplitude", mass.amplitude, mass.amplitude, 1e-9);
            agree(q, "phase", mass.phase, 1, 1e-6);
            agree(q, "amplitude_monoharmonic", mass.amplitude_monoharmonic, mass.amplitude_monoharmonic, 1e-9);
            agree(q, "phase_monoharmonic", mass.phase_monoharmonic, 1, 1e-8);
            agree(q, "initial_displacement", mass.x0, mass.amplitude, 1e-9);
            agree(q, "initial_velocity", mass.v0, mass.amplitude, 1e-9);
        }
    }
    CHECK(sliding >= 30);
}

TEST_CASE("the plain closed form agrees with every certified vector but motions of several periods", "[conformance][vectors]") {
    constexpr double of_what_passes = 5; // in double nothing is done here to keep digits where terms cancel
    std::size_t compared = 0, several_periods = 0;
    std::pair<double, std::string> worst{0, ""};
    for (const Vector& v : tests::vectors()) {
        if (!v.reject.empty()) continue;
        const std::optional<Value> value = plain_answer(v.question);
        INFO(v.question.id << " " << v.question.quantity);
        if (!value && std::ranges::find(v.flags, "several-periods") != v.flags.end()) {
            ++several_periods;
            continue;
        }
        REQUIRE(value);
        CHECK(value->word == v.word);
        REQUIRE(value->numbers.size() == v.nearest.size());
        ++compared;
        if (v.nearest.empty()) continue;
        const double error = difference(quantity(v.question.quantity), value->numbers, v.nearest).size / v.scale;
        CHECK(error <= of_what_passes * v.tolerance.pass);
        if (v.tolerance.pass > 0) worst = std::max(worst, {error / v.tolerance.pass, v.question.id});
    }
    std::printf("plain closed form: %zu vectors, largest error %.2g of what passes, in %s\n", compared, worst.first,
                worst.second.c_str());
    CHECK(several_periods == 10);
    CHECK(compared > 4000);
}
