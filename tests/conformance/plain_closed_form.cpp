#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "conformance/vector.hpp"
#include "conformance/verdict.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/vector_folder.hpp"

using namespace denhartog;
using namespace denhartog::conformance;

TEST_CASE("the plain closed form agrees with every certified vector but motions of several periods",
          "[eq:38][eq:46][eq:69][conformance][vectors]") {
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

TEST_CASE("next to a pole of a mode without damping, where rounding alone would tell it, the plain closed form has no number",
          "[eq:23][eq:28][eq:29][conformance]") {
    ProtocolQuestion q{.id = "pole", .quantity = "", .mass_ratios = {1}, .stiffness_ratios = {1}, .damping_ratios = {0}};
    q.mass = 1;
    for (const int harmonic : {1, 3, 5}) // (23) has the first alone, (28) and (29) all odd ones
        for (const char* asked : {"complex_response", "first_damping_function", "second_damping_function"}) {
            q.quantity = asked;
            INFO(asked << ", harmonic " << harmonic);
            const bool has_pole = harmonic == 1 || q.quantity != "complex_response";
            for (const double apart : {0.0, 1e-15, -1e-15, 1e-11, -1e-11}) {
                q.r = (1 + apart) / harmonic;
                CHECK(plain_answer(q).has_value() == (!has_pole || std::abs(apart) > 1e-12));
            }
        }
}
