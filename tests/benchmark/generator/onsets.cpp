#include "denhartog/answer/reference.hpp"
#include "tests/benchmark/generator/pack.hpp"
#include "tests/conformance/generator/linear_half_period.hpp"
#include "tests/support/held_contact.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::benchmark {

Onsets onsets_of(const PackScene& s) {
    ReferenceQuestion question;
    question.asked = Asked::regime;
    question.digits = 48;
    const SceneSource scene = without_friction_ratio(scene_source(scene_of(s)));
    Tried<Solution> answer = solution_by_reference(scene, question, [] { return std::vector<OrbitGuess>(); });
    const Limits limits = *answer.required().limits;
    if (!limits.sticking) throw DomainError("no friction holds the contact of " + s.id);
    return {Real50(limits.exact.decimal), Real50(limits.sticking->decimal)};
}

Onsets onsets_of_half_period(const PackScene& s) {
    using namespace conformance::generator;
    const HalfPeriodProblem<Real50> p = half_period_problem(scene_of(s));
    const Eigen::Index N = p.M.rows(), j = static_cast<Eigen::Index>(p.contact.index);
    const Real50 mu = Real50(s.F_static) / s.F;
    const LinearHalfPeriod<Real50> h = linear_half_period(p, 512);
    const Real50 re = h.Y(j, 0), im = h.Y(N + j, 0), U = U_of(h, h.w);
    const Real50 demand = std::max(largest_demand(h), Real50(acceleration_at_start(h) + (mu - 1) / p.M(j, j)));
    return {sqrt(Real50((re * re + im * im) / (U * U + demand * demand))), modulus(tests::held_contact(p).load) / mu};
}

} // namespace denhartog::benchmark
