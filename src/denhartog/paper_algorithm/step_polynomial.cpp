#include "denhartog/paper_algorithm/step_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "denhartog/elementary/elementary.hpp"
#include "denhartog/search/largest_in_double.hpp"

namespace denhartog {
namespace {

constexpr int deepest = 52;

using Coefficients = std::array<double, StepPolynomial::highest_degree + 1>;

constexpr void raise_degree(Coefficients& b, int degree) {
    b[static_cast<std::size_t>(degree) + 1] = b[static_cast<std::size_t>(degree)];
    for (int i = degree; i > 0; --i) {
        const double part = static_cast<double>(i) / (degree + 1);
        b[static_cast<std::size_t>(i)] = part * b[static_cast<std::size_t>(i) - 1] + (1 - part) * b[static_cast<std::size_t>(i)];
    }
}

// Row k: (2 theta - 1)^k, whose coefficients at its own degree are 1 and -1 in turn, at the highest degree.
constexpr std::array<Coefficients, StepPolynomial::highest_degree + 1> powers() {
    std::array<Coefficients, StepPolynomial::highest_degree + 1> rows{};
    for (int k = 0; k <= StepPolynomial::highest_degree; ++k) {
        Coefficients& b = rows[static_cast<std::size_t>(k)];
        for (int i = 0; i <= k; ++i) b[static_cast<std::size_t>(i)] = (k - i) % 2 == 0 ? 1 : -1;
        for (int degree = k; degree < StepPolynomial::highest_degree; ++degree) raise_degree(b, degree);
    }
    return rows;
}

constexpr std::array<Coefficients, StepPolynomial::highest_degree + 1> powers_by_degree = powers();

int sign(double x) { return (x > 0) - (x < 0); }

double value(const Coefficients& b, int degree, double theta) {
    const double rest = 1 - theta;
    double power = 1, binomial = 1, sum = b[0] * rest;
    for (int i = 1; i < degree; ++i) {
        power *= theta;
        binomial *= static_cast<double>(degree - i + 1) / i;
        sum = (sum + power * binomial * b[static_cast<std::size_t>(i)]) * rest;
    }
    return sum + power * theta * b[static_cast<std::size_t>(degree)];
}

// The zero of a polynomial with one change of sign, on the side of the end.
double zero_between(const Coefficients& b, int degree) {
    const std::function<double(const double&)> f = [&](double theta) { return value(b, degree, theta); };
    return root_bracket(f, 0.0, 1.0, b[0], b[static_cast<std::size_t>(degree)]).second;
}

// Walks over the changes of sign in order; ends where `visit` returns true.
template <class Visit>
struct Walk {
    int degree;
    int sign_before; // of the polynomial left of where the walk is; 0 where it is not known
    Visit visit;

    bool turn(int to, double theta) {
        const bool changed = sign_before != 0 && to != 0 && to != sign_before;
        if (to != 0) sign_before = to;
        return changed && visit(theta);
    }

    bool over(const Coefficients& b, double from, double to, int depth) {
        const auto end = static_cast<std::size_t>(degree);
        int first = 0, last = 0, changes = 0;
        for (std::size_t i = 0; i <= end; ++i) {
            const int s = sign(b[i]);
            if (s == 0) continue;
            if (last != 0 && s != last) ++changes;
            if (first == 0) first = s;
            last = s;
        }
        if (changes == 0) return turn(first, from);
        if (changes == 1 && b[0] != 0 && b[end] != 0)
            return turn(first, from) || turn(last, from + (to - from) * zero_between(b, degree));
        if (depth == deepest) return turn(last, to);
        Coefficients left{}, right = b;
        for (std::size_t i = 0; i <= end; ++i) {
            left[i] = right[0];
            for (std::size_t n = 0; n + i < end; ++n) right[n] = (right[n] + right[n + 1]) / 2;
        }
        const double middle = (from + to) / 2;
        return over(left, from, middle, depth + 1) || over(right, middle, to, depth + 1);
    }
};

} // namespace

StepPolynomial quintic(const StepValues& v) {
    const double b_1 = v.f_0 + v.h_f_prime_0 / 5, b_4 = v.f_1 - v.h_f_prime_1 / 5;
    const double s = (243 * v.f_third - 32 * v.f_0 - 80 * b_1 - 10 * b_4 - v.f_1) / 40;
    const double t = (243 * v.f_two_thirds - v.f_0 - 10 * b_1 - 80 * b_4 - 32 * v.f_1) / 40;
    return {{v.f_0, b_1, (2 * s - t) / 3, (2 * t - s) / 3, b_4, v.f_1}, 5};
}

StepPolynomial with_cosine(const StepPolynomial& p, double a, double tau, double h) {
    StepPolynomial sum = p;
    for (; sum.degree < StepPolynomial::highest_degree; ++sum.degree) raise_degree(sum.b, sum.degree);
    // Taylor's series about the middle of the step.
    const double cosine = elementary::cos(tau + h / 2), sine = elementary::sin(tau + h / 2);
    const std::array<double, 4> derivatives = {cosine, -sine, -cosine, sine};
    double factor = a;
    for (int k = 0; k <= StepPolynomial::highest_degree; ++k) {
        const double term = factor * derivatives[static_cast<std::size_t>(k) % 4];
        const Coefficients& power = powers_by_degree[static_cast<std::size_t>(k)];
        for (std::size_t i = 0; i < sum.b.size(); ++i) sum.b[i] += term * power[i];
        factor *= h / 2 / (k + 1);
    }
    return sum;
}

double value(const StepPolynomial& p, double theta) { return value(p.b, p.degree, theta); }

void sign_changes(const StepPolynomial& p, std::vector<double>& zeros) {
    zeros.clear();
    const auto keep = [&zeros](double theta) {
        if (theta > 0 && theta < 1) zeros.push_back(theta);
        return false;
    };
    Walk<decltype(keep)>{p.degree, 0, keep}.over(p.b, 0, 1, 0);
}

std::optional<double> first_fall(const StepPolynomial& p, double noise) {
    StepPolynomial f = p;
    while (f.degree > 0 && std::abs(f.b[0]) <= noise) {
        // f = theta q, and q takes the place of f
        for (int i = 1; i <= f.degree; ++i)
            f.b[static_cast<std::size_t>(i) - 1] = f.b[static_cast<std::size_t>(i)] * f.degree / i;
        --f.degree;
    }
    if (f.degree == 0 && std::abs(f.b[0]) <= noise) return std::nullopt;
    const auto end = f.b.begin() + f.degree + 1;
    if (std::all_of(f.b.begin(), end, [](double b) { return b >= 0; })) return std::nullopt;
    std::optional<double> found;
    const auto stop = [&found](double theta) {
        found = theta;
        return true;
    };
    Walk<decltype(stop)>{f.degree, 1, stop}.over(f.b, 0, 1, 0);
    return found;
}

} // namespace denhartog
