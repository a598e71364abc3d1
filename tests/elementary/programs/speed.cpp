// Prints the nanoseconds of each elementary function beside those of the system's, the least of many runs: a call after another
// that do not wait for each other, and calls each of which waits for the one before.
// Usage: g++ -std=c++20 -O2 -fno-builtin -Isrc -Ibuild/verify/include -c tests/elementary/programs/speed.cpp
//        g++ -std=c++20 -O2 -ffp-contract=off -Isrc -Ibuild/verify/include speed.o src/elementary/*.cpp
// The system's functions are to be called; ours are compiled as in the library.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "elementary/elementary.hpp"

using namespace denhartog;

namespace {

template <class Function>
double time_of(const std::vector<double>& x, Function f, double waits) {
    using Clock = std::chrono::steady_clock;
    volatile double kept = 0;
    double best = 1e9;
    for (int n = 0; n < 400; ++n) {
        const auto start = Clock::now();
        double sum = 0;
        if (waits != 0)
            for (const double each : x) sum = 1e-300 * f(each + sum);
        else
            for (const double each : x) sum += f(each);
        kept = sum;
        best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
    }
    static_cast<void>(kept);
    return best / static_cast<double>(x.size());
}

template <class Ours, class Systems>
void compare(const char* name, double from, double to, Ours ours, Systems systems) {
    std::vector<double> x(2000);
    unsigned long state = 23;
    for (double& each : x) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        each = from + (to - from) * (static_cast<double>(state >> 11U) * 0x1p-53);
    }
    const double apart[2] = {time_of(x, ours, 0), time_of(x, systems, 0)},
                 in_line[2] = {time_of(x, ours, 1), time_of(x, systems, 1)};
    std::printf("%s,%.1f,%.1f,%.2f,%.1f,%.1f,%.2f\n", name, apart[0], apart[1], apart[0] / apart[1], in_line[0], in_line[1],
                in_line[0] / in_line[1]);
}

} // namespace

#define COMPARE(function, from, to)                                                                                              \
    compare(                                                                                                                     \
        #function, from, to, [](double x) { return elementary::function(x); }, [](double x) { return std::function(x); })

int main() {
    std::printf("function,ours apart,system's apart,ratio,ours in line,system's in line,ratio\n");
    COMPARE(exp, -20, 20);
    COMPARE(expm1, -3, 3);
    COMPARE(sinh, -3, 3);
    COMPARE(cosh, -3, 3);
    COMPARE(log, 0.1, 10);
    COMPARE(log10, 0.1, 10);
    COMPARE(sin, -10, 10);
    COMPARE(cos, -10, 10);
    COMPARE(atan, -3, 3);
    compare(
        "atan2", -3, 3, [](double x) { return elementary::atan2(x, 1.3); }, [](double x) { return std::atan2(x, 1.3); });
    compare(
        "hypot", -3, 3, [](double x) { return elementary::hypot(x, 1.3); }, [](double x) { return std::hypot(x, 1.3); });
}
