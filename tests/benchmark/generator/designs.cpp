#include "tests/benchmark/generator/designs.hpp"

#include <Eigen/LU>
#include <cmath>

#include "denhartog/answer/reference.hpp"
#include "denhartog/number/errors.hpp"
#include "tests/conformance/generator/linear_half_period.hpp"
#include "tests/support/scene_builder.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::benchmark {
namespace {

using Index = Eigen::Index;
using List = std::vector<double>;

constexpr int bits_of_friction = 10;
constexpr double next_to_a_boundary = 1.0 / 64; // relative: friction this near is not rounded

// Of one mass: damping ratio b / 2.
Design one(const char* id, double b, double mu, double omega, Measure measure, double part) {
    return {id, {1}, {1}, 0, b, 1, 1, mu, omega, measure, part};
}

} // namespace

std::vector<Design> designs() {
    using enum Measure;
    const List two{1, 1}, unequal{1, 2}, soft{1, 0.5}, three{1, 1, 1}, mixed{1, 0.5, 2}, stiff{1, 2, 1.5};
    const List four{1, 1, 1, 1}, five{1, 1, 1, 1, 1}, heavy{2, 1, 1, 0.5}, light{1, 0.75, 0.5, 0.75, 1.5};
    const List m_4{1, 2, 0.5, 1.5}, k_4{1, 0.5, 2, 1};
    const double zeta_16 = 0.125, zeta_128 = 1.0 / 64, zeta_1024 = 1.0 / 512;
    return {
        one("one-01", zeta_16, 1, 0.75, sliding, 0.5),
        one("one-02", zeta_16, 1, 1.5, sliding, 0.5),
        one("one-03", zeta_128, 1, 1, given, 0.25),
        one("one-04", zeta_1024, 1, 0.96875, given, 0.0625),
        one("one-05", zeta_1024, 1, 1.75, sliding, 0.25),
        one("one-06", zeta_16, 1, 0.5, between, 0.5),
        one("one-07", zeta_16, 1, 0.25, between, 0.25),
        one("one-08", zeta_128, 1, 0.125, between, 0.125),
        one("one-09", zeta_1024, 1, 0.0625, between, 0.0625),
        one("one-10", zeta_16, 1, 0.5, between, 0.9375),
        one("one-11", zeta_16, 1, 0.75, sticking, 1.25),
        one("one-12", zeta_16, 1, 0.75, sticking, 1 + 1e-4),
        one("one-13", zeta_16, 1, 0.75, sticking, 1 - 1e-2),
        one("one-14", zeta_16, 1, 0.75, sticking, 1 - 1e-4),
        one("one-15", zeta_16, 1, 0.75, sliding, 1 - 1e-2),
        one("one-16", zeta_16, 1, 0.75, sliding, 1 + 1e-2),
        one("one-17", zeta_16, 1, 0.75, sliding, 1 - 1e-4),
        one("one-18", zeta_16, 1, 0.75, sliding, 1 + 1e-4),
        one("one-19", zeta_16, 1, 0.75, sliding, 1 - 1e-8),
        one("one-20", zeta_16, 1, 0.75, sliding, 1 + 1e-8),
        one("one-21", zeta_16, 1.5, 0.5, between, 0.5),
        one("one-22", zeta_16, 2, 0.25, between, 0.5),
        one("one-23", zeta_16, 1.25, 0.5, sticking, 1.0625),
        one("one-24", zeta_1024, 1, 0.5, sliding, 0.5),
        {"two-01", two, two, 0, zeta_16, 2, 1, 1, 0.75, sliding, 0.5},
        {"two-02", two, two, 0, zeta_16, 2, 1, 1, 1.25, sliding, 0.5},
        {"two-03", unequal, soft, 0.0625, 0.0625, 1, 2, 1, 0.5, between, 0.5},
        {"two-04", two, two, 0, zeta_128, 2, 1, 1, 0.625, sliding, 0.75},
        {"two-05", unequal, soft, 0.0625, 0.0625, 2, 2, 1, 0.25, between, 0.25},
        {"two-06", two, two, 0, zeta_16, 2, 1, 1, 0.5, sticking, 1.5},
        {"two-07", two, two, 0, zeta_16, 2, 1, 1, 0.75, sliding, 1 + 1e-4},
        {"two-08", two, two, 0, zeta_16, 2, 1, 1, 0.75, sliding, 1 - 1e-4},
        {"two-09", unequal, soft, 0.0625, 0.0625, 1, 2, 1.5, 0.5, between, 0.5},
        {"two-10", unequal, two, 0, zeta_16, 1, 1, 1, 1, sticking, 1 - 1e-2},
        {"three-01", three, three, 0.03125, 0.0625, 3, 1, 1, 1, sliding, 0.5},
        {"three-02", mixed, stiff, 0.0625, 0.0625, 2, 1, 1, 0.5, between, 0.5},
        {"three-03", mixed, stiff, 0.0625, 0.0625, 1, 3, 1, 0.25, between, 0.25},
        {"three-04", three, three, 0, zeta_128, 2, 3, 1, 1.5, sliding, 0.75},
        {"three-05", mixed, stiff, 0.0625, 0.0625, 3, 1, 1, 0.75, sticking, 2},
        {"three-06", three, three, 0.03125, 0.0625, 3, 1, 1, 1, sliding, 1 + 1e-2},
        {"three-07", mixed, stiff, 0.0625, 0.0625, 2, 2, 1.25, 0.5, between, 0.5},
        {"four-01", four, four, 0.0625, 0.0625, 1, 4, 1, 0.75, sliding, 0.5},
        {"four-02", m_4, k_4, 0.0625, 0.0625, 3, 1, 1, 0.5, between, 0.5},
        {"four-03", m_4, k_4, 0.0625, 0.0625, 4, 2, 1, 0.25, between, 0.25},
        {"four-04", four, four, 0.0625, 0.0625, 2, 3, 1, 0.5, sticking, 2},
        {"five-01", five, five, 0, zeta_16, 1, 1, 1, 0.90625, sliding, 0.5},
        {"five-02", five, five, 0, zeta_16, 3, 1, 1, 0.90625, sliding, 0.5},
        {"five-03", five, light, 0.0625, 0.03125, 5, 2, 1, 0.5, between, 0.5},
        {"five-04", five, light, 0.0625, 0.03125, 2, 5, 1, 0.25, between, 0.25},
        {"five-05", five, five, 0, zeta_128, 3, 1, 1, 0.90625, sliding, 0.75},
        {"five-06", five, five, 0, zeta_16, 3, 1, 1, 0.90625, sliding, 1 + 1e-4},
        {"five-07", five, light, 0.0625, 0.03125, 3, 3, 1.5, 0.5, between, 0.5},
        {"five-08", five, five, 0, zeta_16, 3, 1, 1, 0.5, sticking, 2},
    };
}

Scene<double> scene_of(const Design& d, double F) {
    const auto N = static_cast<Index>(d.m.size());
    Scene<double> scene;
    scene.system.mass_ratios = d.m;
    scene.system.stiffness_ratios = d.k;
    Matrix<double>& C = scene.system.damping_matrix = Matrix<double>::Zero(N, N);
    for (Index i = 0; i < N; ++i) {
        const auto n = static_cast<std::size_t>(i);
        connect(C, i, i - 1, d.b * d.k[n]);
        connect(C, i, -1, d.a * d.m[n]);
    }
    scene.system.contact = Mass{static_cast<std::size_t>(d.contact - 1)};
    scene.system.load = Mass{static_cast<std::size_t>(d.load - 1)};
    scene.mu = d.mu;
    scene.r = d.omega;
    scene.beta = F;
    return scene;
}

Onsets onsets_of(const Design& d) {
    ReferenceQuestion question;
    question.asked = Asked::regime;
    question.digits = 48;
    const SceneSource scene = without_friction_ratio(scene_source(scene_of(d, 0)));
    Tried<Solution> answer = solution_by_reference(scene, question, [] { return std::vector<OrbitGuess>(); });
    const Limits limits = *answer.required().limits;
    if (!limits.sticking) throw DomainError("no friction holds the contact of " + d.id);
    return {Real50(limits.exact.decimal), Real50(limits.sticking->decimal)};
}

Onsets onsets_of_half_period(const Design& d) {
    using namespace conformance::generator;
    const HalfPeriodProblem<Real50> p = half_period_problem(scene_of(d, 0));
    const Index N = p.M.rows(), j = static_cast<Index>(p.contact.index), l = static_cast<Index>(p.load.index);
    const Real50 mu(d.mu);
    const LinearHalfPeriod<Real50> h = linear_half_period(p, 512);
    const Real50 re = h.Y(j, 0), im = h.Y(N + j, 0), U = U_of(h, h.w);
    const Real50 demand = std::max(largest_demand(h), Real50(acceleration_at_start(h) + (mu - 1) / p.M(j, j)));
    Matrix<Real50> A(2 * N, 2 * N), load = Matrix<Real50>::Zero(2 * N, 1);
    A << p.K - p.M, -p.C, p.C, p.K - p.M;
    load(l, 0) = Real50(1);
    for (const Index held : {j, N + j}) {
        A.row(held).setZero();
        A(held, held) = Real50(1);
        load(held, 0) = Real50(0);
    }
    const Matrix<Real50> X = Eigen::FullPivLU<Matrix<Real50>>(A).solve(load);
    const Matrix<Real50> x = X.topRows(N), y = X.bottomRows(N);
    const Real50 held_re = (p.K.row(j) * x - p.C.row(j) * y)(0, 0) - (j == l ? 1 : 0);
    const Real50 held_im = (p.K.row(j) * y + p.C.row(j) * x)(0, 0);
    return {sqrt(Real50((re * re + im * im) / (U * U + demand * demand))),
            sqrt(Real50(held_re * held_re + held_im * held_im)) / mu};
}

double friction_of(const Design& d, const Onsets& onsets) {
    if (d.measure == Measure::given) return d.part;
    const Real50 part(d.part);
    if (std::abs(d.part - 1) <= next_to_a_boundary)
        return static_cast<double>(Real50(part * (d.measure == Measure::sliding ? onsets.sliding : onsets.sticking)));
    const Real50 F = d.measure == Measure::between   ? Real50(onsets.sliding + part * (onsets.sticking - onsets.sliding))
                     : d.measure == Measure::sliding ? Real50(part * onsets.sliding)
                                                     : Real50(part * onsets.sticking);
    int exponent = 0;
    const Real50 mantissa = frexp(F, &exponent);
    return std::ldexp(static_cast<double>(Real50(round(ldexp(mantissa, bits_of_friction)))), exponent - bits_of_friction);
}

} // namespace denhartog::benchmark
