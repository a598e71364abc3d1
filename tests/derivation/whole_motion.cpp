// The shipped motion with all its formulas at once in (12), (25) and (30), in 50 digits: no formula in it can be altered unseen.
#include "derivation/forms/whole_motion.hpp"

#include <algorithm>

#include "derivation/algebra/zero_test.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

/// The largest of the values that are to be zero, at a point where the contact slides.
numeric largest(const std::vector<ex>& left_over) {
    const std::vector<Range> domain = domain_of(left_over);
    Point point = sample_points(domain, 1).front();
    for (auto& [symbol, value] : point)
        if (symbol.is_equal(symbols().beta)) value = numeric(1, 50);
    numeric worst = 0;
    for (const ex& e : left_over) worst = std::max(worst, abs(evaluate(e, point)));
    return worst;
}

} // namespace

TEST_CASE("the shipped motion satisfies the equation of motion, mirrors itself and starts from rest at the contact",
          "[eq:12][eq:25][eq:28][eq:29][eq:30][eq:33][eq:34][eq:35][eq:38][eq:39][eq:46][whole]") {
    for (int N = 1; N <= 3; ++N)
        for (int j = 0; j < N; ++j)
            for (int l = 0; l < N; ++l) {
                INFO("N = " << N << ", j = " << j + 1 << ", l = " << l + 1);
                CHECK(largest(whole_conditions(N, j, l)) < numeric("1e-45"));
            }
}

TEST_CASE("no operation of the formulas in the motion can be altered without being seen", "[eq:12][eq:46][whole]") {
    const std::vector<ex> shipped = whole_conditions(2, 0, 1); // makes the symbols, outside of a mutation
    long operations = 0;
    {
        const Mutation none(-1);
        CHECK(whole_conditions(2, 0, 1).size() == shipped.size());
        operations = none.operations();
    }
    REQUIRE(operations > 200);
    long altered_nothing = 0;
    for (long position = 0; position < operations; ++position) {
        std::string replaced;
        numeric left_over = 1;
        try {
            std::vector<ex> altered;
            {
                const Mutation mutation(position);
                altered = whole_conditions(2, 0, 1);
                replaced = mutation.replaced();
            }
            if (std::ranges::equal(altered, shipped,
                                   GiNaC::ex_is_equal())) { // tau - 0 and tau for tau + 0, at the contact itself
                ++altered_nothing;
                continue;
            }
            left_over = largest(altered);
        } catch (const std::exception&) { // an alteration that divides by zero is seen as well
        }
        INFO("operation " << position << ", " << replaced);
        CHECK(left_over > numeric("1e-20"));
    }
    CHECK(altered_nothing == 4);
}
