// Seeded scenes of every kind: what `solve` tells of them in double lies within its bounds of the proved numbers. A sample here;
// a hundred thousand of them with the preset `sweeps`, or as many as DENHARTOG_SCENES says, from DENHARTOG_SEED on.
#include <cmath>
#include <cstdlib>
#include <random>

#include "denhartog/number/errors.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/reference/surveyed_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

// Numbers of three digits, so that a scene that fails can be read.
class RandomScenes {
public:
    explicit RandomScenes(std::uint64_t seed) : bits_(seed) {}

    nlohmann::json scene() {
        const int N = whole(1, 5);
        nlohmann::json s;
        s["mass_ratios"] = ratios(N);
        s["stiffness_ratios"] = ratios(N);
        if (whole(0, 2) == 0)
            s["damping_matrix"] = dashpots(N);
        else
            for (int i = 0; i < N; ++i)
                s["damping_ratios"].push_back(whole(0, 11) == 0 ? 0 : power(-3.5, whole(0, 4) == 0 ? 0.5 : -0.7));
        const int contact = whole(1, N);
        s["contact"] = contact;
        if (N > 1 && whole(0, 3) == 0) s["contact"] = {contact, contact % N + 1};
        s["load"] = whole(1, N);
        if (whole(0, 3) == 0) {
            s["load"] = nlohmann::json::array();
            for (int i = 0; i < N; ++i) s["load"].push_back(rounded(uniform(-1, 1)));
        }
        if (whole(0, 1) == 0) s["mu"] = rounded(uniform(1, 2));
        s["r"] = power(-1.5, whole(0, 2) == 0 ? 2.2 : 0.5);
        s["beta"] = whole(0, 15) == 0 ? 0 : power(-4, 0.2);
        return s;
    }

private:
    double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53; }
    int whole(int low, int high) { return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1)); }
    static double rounded(double x) {
        if (x == 0) return 0;
        const double unit = std::pow(10.0, 2 - std::floor(std::log10(std::abs(x))));
        return std::round(x * unit) / unit;
    }
    double power(double low, double high) { return rounded(std::pow(10.0, uniform(low, high))); }
    nlohmann::json ratios(int N) {
        nlohmann::json all{1};
        for (int i = 1; i < N; ++i) all.push_back(rounded(uniform(0.4, 2.5)));
        return all;
    }
    // Dashpots beside the springs: they couple the modes.
    nlohmann::json dashpots(int N) {
        std::vector<std::vector<double>> C(static_cast<std::size_t>(N), std::vector<double>(static_cast<std::size_t>(N)));
        for (std::size_t i = 0; i < C.size(); ++i) {
            const double c = rounded(uniform(0.01, 0.3));
            C[i][i] += c;
            if (i == 0) continue;
            C[i - 1][i - 1] += c;
            C[i][i - 1] = C[i - 1][i] = -c;
        }
        return C;
    }

    std::mt19937_64 bits_;
};

} // namespace

TEST_CASE("every number of random scenes in double lies within its bound of the proved one", "[scenes][accuracy]") {
    const bool all = std::getenv("DENHARTOG_SWEEPS") != nullptr;
    const char *scenes_asked = std::getenv("DENHARTOG_SCENES"), *seed = std::getenv("DENHARTOG_SEED");
    const int count = scenes_asked != nullptr ? std::stoi(scenes_asked) : all ? 100'000 : 150;
    RandomScenes scenes(seed != nullptr ? std::stoull(seed) : 20261128);
    SurveyOfBounds survey;
    int refused = 0;
    for (int n = 0; n < count; ++n) {
        const std::string text = scenes.scene().dump();
        INFO(text);
        const SceneSource source = scene_source(SceneText{text});
        survey.scene = text;
        try {
            survey_answer("solve", solve(source, {}), proved_answer(source), survey);
        } catch (const PrecisionError&) {
            ++refused; // by double, or for want of a proof
        } catch (const DomainError&) {
            ++refused;
        }
    }
    for (const std::string& difference : survey.differences) {
        INFO(difference);
        CHECK(difference.empty());
    }
    long numbers = 0;
    for (const auto& [kind, held] : survey.kinds) {
        numbers += static_cast<long>(held.size());
        for (const NumberHeld& n : survey.beyond(kind, 1)) {
            INFO(kind << " is off by " << n.off << ": " << n.where);
            CHECK(n.off <= n.bound);
        }
    }
    std::printf("%ld numbers of %d random scenes; %d scenes without an answer or a proof\n", numbers, count, refused);
    CHECK(numbers > 10 * count);
    CHECK(50 * refused < count);
}
