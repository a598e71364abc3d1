#include "denhartog/reference/friction.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/effort.hpp"

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
FrictionInTime friction_of_modes(const ModesInBalls& m, const OneByOne& modes) {
    FrictionInTime f;
    for (std::size_t row = 0; row <= static_cast<std::size_t>(m.N); ++row) {
        f.constant.emplace_back(0);
        std::vector<Ball>& weight = f.weight.emplace_back();
        for (std::size_t i = 0; i < m.R.size(); ++i) weight.push_back(m.psi[row][i] * m.at_contact()[i] * m.R[i] * m.R[i]);
    }
    f.shared = remembered([R = m.R, zeta = m.zeta, u = modes.u, g = modes.g](const Ball& tau) {
        std::vector<Series> e;
        for (std::size_t i = 0; i < R.size(); ++i) e.push_back(friction_motion_in_time(tau, R[i], zeta[i], u[i], g[i]));
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
    Series sum(constant[row]);
    for (std::size_t i = 0; i < e.size(); ++i)
        for (int n = 0; n < 5; ++n) arb_addmul(sum.c[n].a, weight[row][i].a, e[i].c[n].a, ball_bits);
    return sum;
}

Series friction_motion_in_time(const Ball& tau, const Ball& R, const Ball& zeta, const Ball& u, const Ball& g) {
    constexpr long cost = 20; // as `Effort` counts: three exponentials, sines and cosines of balls, and what goes with them
    QuestionEffort::pay(cost);
    const Ball F = paper::friction_motion(tau, R, zeta, u, g),
               rate = -(1 + g) * paper::d_prime(tau, R, zeta) - u * R * paper::q_prime(tau, R, zeta);
    // The mode obeys R^2 F'' + 2 zeta R F' + F = 1.
    const Ball squared = R * R, damping = 2 * zeta * R, second = (1 - F - damping * rate) / squared,
               third = -(rate + damping * second) / squared, fourth = -(second + damping * third) / squared;
    Series series;
    series.c = {F, rate, second / 2, third / 6, fourth / 24};
    return series;
}

std::function<std::vector<Series>(const Ball&)> remembered(std::function<std::vector<Series>(const Ball&)> shared) {
    using Stretch = std::pair<double, double>;
    using Known = std::pair<Ball, std::vector<Series>>;
    return [shared = std::move(shared), known = std::make_shared<std::map<Stretch, Known>>()](const Ball& tau) {
        if (ball_bits > bits_of_search) return shared(tau);
        const Stretch stretch{tau.low(), tau.high()};
        const auto found = known->find(stretch);
        // two balls may be so near that their ends are the same in double: each has a series of its own
        if (found != known->end() && arb_equal(found->second.first.a, tau.a) != 0) return found->second.second;
        return known->insert_or_assign(stretch, Known(tau, shared(tau))).first->second.second;
    };
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
    r.friction = friction_of_modes(m, modes);
    r.modes = std::move(m);
    return r;
}

} // namespace denhartog::reference
