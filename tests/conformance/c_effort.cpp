// Work from C: what a call may cost, and how it is cancelled.
#include <denhartog.h>

#include <limits>
#include <string>
#include <thread>

#include "tests/conformance/c_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

// The status of a question about a contact that stops: its motion is followed from event to event. Where it has no answer nothing
// is written.
int solve_stopping(bool proved = false) {
    static const Handle system = handle_of(chain_of({1, 2.5}, {1, 0.625}, {0.0625, 0.125}, 2, 1));
    dh_solution* made = nullptr;
    const int status = (proved ? dh_solve_proved : dh_solve)(system.get(), 1.125, 0.5, 1.25, 0, &made);
    const Answered solution(made);
    CHECK((made != nullptr) == (status == DH_OK));
    return status;
}

struct AllowedWork {
    AllowedWork(double operations, dh_cancelled cancelled = nullptr, void* context = nullptr) {
        REQUIRE(dh_set_effort(operations, cancelled, context) == DH_OK);
    }
    ~AllowedWork() { (void)dh_set_effort(0, nullptr, nullptr); }
};

// Ends the question when it was asked as often as the number says.
int after(void* context) {
    int& calls = *static_cast<int*>(context);
    return --calls <= 0;
}

bool says(const char* words) { return std::string(dh_last_message()).find(words) != std::string::npos; }

} // namespace

TEST_CASE("a call that has spent its work says so and writes nothing", "[c][effort][threads]") {
    REQUIRE(solve_stopping() == DH_OK);
    {
        const AllowedWork little(50);
        for (const bool proved : {false, true}) {
            CHECK(solve_stopping(proved) == DH_ERROR_PRECISION);
            CHECK(says("the work allowed is spent"));
        }
        int status = DH_ERROR_INTERNAL;
        std::thread([&] { status = solve_stopping(); }).join(); // which was told nothing
        CHECK(status == DH_OK);
    }
    CHECK(solve_stopping() == DH_OK);
}

TEST_CASE("a call can be cancelled from inside, at any time", "[c][effort]") {
    for (int calls : {1, 5, 40}) {
        int left = calls;
        const AllowedWork cancelled(0, after, &left);
        CHECK(solve_stopping() == DH_ERROR_PRECISION);
        CHECK(says("cancelled"));
        CHECK(left <= 0);
        CHECK(left > -20); // few calls after the first that says so
    }
    int never = std::numeric_limits<int>::max();
    const AllowedWork watched(0, after, &never);
    CHECK(solve_stopping() == DH_OK);
    CHECK(never < std::numeric_limits<int>::max());
}

TEST_CASE("work that is no number of operations is refused", "[c][effort]") {
    for (const double wrong : {-1.0, 0.5, 1e19, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK(dh_set_effort(wrong, nullptr, nullptr) == DH_ERROR_INPUT);
        CHECK(says("operations must be from 1 to 1e18, or 0"));
    }
}
