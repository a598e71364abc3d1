#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <cstdio>

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
