#include "denhartog/reference/friction.hpp"

#include <algorithm>

#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/reference/free_motions.hpp"

namespace denhartog::reference {
namespace {

// The paper's own formulas, mode by mode.
struct OneByOne {
    const ModesInBalls& m;
    std::vector<Complex<Ball>> v{};
    std::vector<Ball> u{}, g{};

    explicit OneByOne(const ModesInBalls& modes) : m(modes) {
        for (std::size_t i = 0; i < m.R.size(); ++i) {
            v.push_back(paper::complex_response(m.R[i], m.zeta[i]));        // (23)
            u.push_back(paper::first_damping_function(m.R[i], m.zeta[i]));  // (28)
            g.push_back(paper::second_damping_function(m.R[i], m.zeta[i])); // (29)
        }
    }
    [[nodiscard]] Complex<Ball> V(const std::vector<Ball>& k, const std::vector<Ball>& load) const { // (33)
        return paper::complex_response_of_mass<Ball>(k, load, m.R, v);
    }
    [[nodiscard]] Ball U(const std::vector<Ball>& k) const { // (34)
        return paper::damping_function_of_mass<Ball>(k, m.at_contact(), m.R, u);
    }
    [[nodiscard]] Ball G(const std::vector<Ball>& k) const { // (35)
        return paper::damping_function_of_mass<Ball>(k, m.at_contact(), m.R, g);
    }
    [[nodiscard]] Ball H() const { return paper::H<Ball>(m.at_contact(), m.R, m.zeta, u, g); } // (64)
};

// (41): each mode moves by itself.
FrictionInTime friction_of_modes(const ModesInBalls& m) {
    FrictionInTime f;
    for (std::size_t row = 0; row <= static_cast<std::size_t>(m.N); ++row) {
        f.constant.emplace_back(0);
        std::vector<Ball>& weight = f.weight.emplace_back();
        for (std::size_t i = 0; i < m.R.size(); ++i) weight.push_back(m.psi[row][i] * m.at_contact()[i] * m.R[i] * m.R[i]);
    }
    std::vector<FrictionMotionOfMode> motions;
    for (std::size_t i = 0; i < m.R.size(); ++i) motions.emplace_back(m.R[i], m.zeta[i]);
    f.modes = motions;
    using AllModes = std::vector<Series>;
    f.shared = std::make_shared<Remembered<AllModes>>(
        [motions](const Ball& tau) {
            AllModes e;
            for (const FrictionMotionOfMode& F : motions) e.push_back(F.at(tau));
            return e;
        },
        [motions](const AllModes& in_the_middle, const Ball& tau) {
            AllModes e;
            for (std::size_t i = 0; i < motions.size(); ++i) e.push_back(motions[i].over(in_the_middle[i], tau));
            return e;
        });
    return f;
}

} // namespace

Ball acceleration_of_contact(const SceneInBalls& s) {
    BallMatrix a;
    if (!solved(s.M, s.w, a)) throw Unproved("the mass matrix is not proved regular");
    return (transposed(s.w) * a)(0) / (s.r * s.r);
}

Series FrictionInTime::of(std::size_t row, const std::vector<Series>& e) const {
    return sum_of(weight[row], e, Series(constant[row]));
}

Series FrictionInTime::rate_and_third(std::size_t row, const std::vector<Series>& e) const {
    std::vector<Series> each;
    for (std::size_t i = 0; i < e.size(); ++i) each.push_back(modes[i].rate_and_third(e[i]));
    return sum_of(weight[row], each, Series());
}

Series FrictionMotionOfMode::rate_and_third(const Series& F) const {
    Series sum; // as F''' = -(2 zeta / R F'' + F' / R^2)
    for (int n = 0; n < 3; ++n) sum.c[n] = (1 - stiffness) * ((n + 1) * F.c[n + 1]) - damping * ((n + 1) * (n + 2) * F.c[n + 2]);
    return sum;
}

FrictionMotionOfMode::FrictionMotionOfMode(const Ball& R_i, const Ball& zeta_i)
    : R(R_i), zeta(zeta_i), u(paper::first_damping_function(R, zeta)), g(paper::second_damping_function(R, zeta)), speed(1 / R),
      stiffness(speed * speed), damping(2 * zeta * speed), turning(sqrt(1 - zeta * zeta) * speed),
      of_sine(((1 + g) * zeta + u * R) / sqrt(1 - zeta * zeta)) {
    largest = root_of_positive((1 + g) * (1 + g) + of_sine * of_sine);
}

Series FrictionMotionOfMode::at(const Ball& tau) const {
    constexpr long cost = 20; // as `Effort` counts: an exponential, a sine and a cosine of balls, and what goes with them
    QuestionEffort::pay(cost * (1 + ball_bits / 256));
    // `paper::friction_motion` and its rate, (A.8) put in: one exponential, one sine and one cosine.
    const Ball decay = damping / 2, e = exp(-(decay * tau)), angle = turning * tau, c = e * cos(angle), s = e * sin(angle),
               F = 1 - (1 + g) * c - of_sine * s, rate = (decay * of_sine + turning * (1 + g)) * s - u * c;
    // The mode obeys F'' + 2 zeta / R F' + F / R^2 = 1 / R^2.
    const Ball second = (1 - F) * stiffness - damping * rate, third = -(rate * stiffness + damping * second),
               fourth = -(second * stiffness + damping * third);
    Series series;
    series.c = {F, rate, second / 2, third / 6, fourth / 24};
    return series;
}

Series FrictionMotionOfMode::over(const Series& in_the_middle, const Ball& tau) const {
    // F - 1 is e^(-zeta tau / R) times a cosine, which is not larger later.
    const auto left = [&] {
        const Bits few(64);
        return upper_bound_of(largest * exp(-damping / 2 * Ball(tau.low())));
    };
    return over_stretch(in_the_middle, tau - middle(tau), Ball(1), left(), speed);
}

bool are_of_papers_form(const ModesInBalls& m) {
    return m.clusters.empty() && std::ranges::all_of(m.zeta, [](const Ball& zeta) { return zeta < Ball(1); });
}

ResponsesInBalls responses_of_modes(const SceneInBalls& s, ModesInBalls m) {
    const OneByOne modes(m);
    ResponsesInBalls r;
    for (std::size_t row = 0; row <= static_cast<std::size_t>(m.N); ++row) {
        r.V.push_back(modes.V(m.psi[row], m.at_load()));
        r.U.push_back(modes.U(m.psi[row]));
        r.G.push_back(modes.G(m.psi[row]));
    }
    r.H = modes.H();
    r.Y = modes.V(m.at_contact(), m.at_contact());
    r.squares = acceleration_of_contact(s);
    r.friction = friction_of_modes(m);
    r.modes = std::move(m);
    return r;
}

} // namespace denhartog::reference
