#include "tests/conformance/unknown_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog::tests {
namespace {

using conformance::Choices;
using conformance::PlainModes;
using conformance::ProtocolQuestion;
using conformance::Value;

std::string text_of(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", x);
    return text;
}

// Factors that known mistakes have: those drawn keep away from them.
bool is_known(double factor) {
    for (const double known : {0.5, 1.0, 2.0, std::sqrt(0.5), std::sqrt(2.0), 4 / pi<double>(), 1 / (2 * pi<double>())})
        if (std::abs(factor / known - 1) < 0.04) return true;
    return false;
}

class Draw {
public:
    explicit Draw(std::uint64_t seed) : random(seed) {}

    double factor() {
        for (;;) {
            const double x = std::exp(-0.7 + 1.4 * static_cast<double>(random() >> 11) * 0x1p-53);
            if (!is_known(x)) return x;
        }
    }

    std::size_t place(std::size_t most) { return random() % most; }

private:
    std::mt19937_64 random;
};

UnknownMistake reading(std::string rule, std::string told, std::function<void(ProtocolQuestion&)> read) {
    return {std::move(rule), std::move(told), std::move(read), {}, {}};
}

UnknownMistake in_modes(std::string rule, std::string told, std::function<void(PlainModes&)> change) {
    return {std::move(rule), std::move(told), {}, [change = std::move(change)](Choices& c) { c.change_modes = change; }, {}};
}

UnknownMistake in_sums(std::string rule, std::string told, std::function<void(PlainModes&)> change) {
    return {std::move(rule), std::move(told), {}, [change = std::move(change)](Choices& c) { c.change_sums = change; }, {}};
}

using List = std::vector<double> ProtocolQuestion::*;

void add_scaled(std::vector<UnknownMistake>& all, Draw& draw) {
    const std::pair<const char*, List> lists[] = {{"mass_ratios", &ProtocolQuestion::mass_ratios},
                                                  {"stiffness_ratios", &ProtocolQuestion::stiffness_ratios},
                                                  {"damping_ratios", &ProtocolQuestion::damping_ratios}};
    for (const auto& [name, list] : lists)
        for (int n = 0; n < 2; ++n) {
            const double f = draw.factor();
            const std::size_t from = list == &ProtocolQuestion::damping_ratios ? 0 : 1; // the first mass and spring are units
            all.push_back(reading("scale an input", "all " + std::string(name) + " times " + text_of(f),
                                  [list = list, f, from](ProtocolQuestion& q) {
                                      for (std::size_t i = from; i < (q.*list).size(); ++i) (q.*list)[i] *= f;
                                  }));
            const double g = draw.factor();
            const std::size_t place = from + draw.place(2);
            all.push_back(reading("scale an input",
                                  std::string(name) + ", number " + std::to_string(place + 1) + ", times " + text_of(g),
                                  [list = list, g, place](ProtocolQuestion& q) {
                                      if (place < (q.*list).size()) (q.*list)[place] *= g;
                                  }));
        }
    const std::pair<const char*, double ProtocolQuestion::*> numbers[] = {
        {"mu", &ProtocolQuestion::mu}, {"r", &ProtocolQuestion::r}, {"beta", &ProtocolQuestion::beta}};
    for (const auto& [name, number] : numbers)
        for (int n = 0; n < 3; ++n) {
            const double f = draw.factor();
            all.push_back(reading("scale an input", std::string(name) + " times " + text_of(f),
                                  [number = number, f](ProtocolQuestion& q) { q.*number *= f; }));
        }
}

void add_swapped(std::vector<UnknownMistake>& all) {
    const std::string rule = "swap two";
    const auto add = [&](const char* told, std::function<void(ProtocolQuestion&)> read) {
        all.push_back(reading(rule, told, std::move(read)));
    };
    add("mass and stiffness ratios", [](ProtocolQuestion& q) { std::swap(q.mass_ratios, q.stiffness_ratios); });
    add("the last two masses", [](ProtocolQuestion& q) {
        if (q.mass_ratios.size() > 2) std::iter_swap(q.mass_ratios.rbegin(), q.mass_ratios.rbegin() + 1);
    });
    add("the last two springs", [](ProtocolQuestion& q) {
        if (q.stiffness_ratios.size() > 2) std::iter_swap(q.stiffness_ratios.rbegin(), q.stiffness_ratios.rbegin() + 1);
    });
    add("the first two damping ratios", [](ProtocolQuestion& q) {
        if (q.damping_ratios.size() > 1) std::iter_swap(q.damping_ratios.begin(), q.damping_ratios.begin() + 1);
    });
    add("the masses behind the first, in the other order",
        [](ProtocolQuestion& q) { std::reverse(q.mass_ratios.begin() + 1, q.mass_ratios.end()); });
    add("the springs behind the first, in the other order",
        [](ProtocolQuestion& q) { std::reverse(q.stiffness_ratios.begin() + 1, q.stiffness_ratios.end()); });
    add("mu and r", [](ProtocolQuestion& q) { std::swap(q.mu, q.r); });
    add("mu and beta", [](ProtocolQuestion& q) { std::swap(q.mu, q.beta); });
    add("r and beta", [](ProtocolQuestion& q) { std::swap(q.r, q.beta); });
    add("the mass asked about and the loaded one", [](ProtocolQuestion& q) {
        if (q.mass > 0) std::swap(q.mass, q.load);
    });
    add("the mass asked about and the one in contact", [](ProtocolQuestion& q) {
        if (q.mass > 0) std::swap(q.mass, q.contact);
    });
    add("the ends of the chain for all three masses named", [](ProtocolQuestion& q) {
        const int N = static_cast<int>(q.mass_ratios.size());
        q.contact = N + 1 - q.contact;
        q.load = N + 1 - q.load;
        if (q.mass > 0) q.mass = N + 1 - q.mass;
    });
}

void add_dropped(std::vector<UnknownMistake>& all, Draw& draw) {
    const std::string rule = "drop a term";
    const auto modes = [&](const char* told, std::function<void(PlainModes&)> change) {
        all.push_back(in_modes(rule, told, std::move(change)));
    };
    const auto sums = [&](const char* told, std::function<void(PlainModes&)> change) {
        all.push_back(in_sums(rule, told, std::move(change)));
    };
    modes("u_di of every mode", [](PlainModes& m) { m.u.setZero(); });
    modes("g_i of every mode", [](PlainModes& m) { m.g.setZero(); });
    modes("the imaginary part of v_di", [](PlainModes& m) { m.v.imag().setZero(); });
    modes("the real part of v_di", [](PlainModes& m) { m.v.real().setZero(); });
    modes("the last mode", [](PlainModes& m) {
        if (m.psi.rows() > 1) m.psi.rightCols(1).setZero();
    });
    modes("the first mode", [](PlainModes& m) {
        if (m.psi.rows() > 1) m.psi.leftCols(1).setZero();
    });
    modes("the 1 - R^2 of a mode below its resonance", [](PlainModes& m) {
        for (Eigen::Index i = 0; i < m.R.size(); ++i)
            if (m.R[i] < 1) m.v[i].real(1);
    });
    modes("one R_i of R_i^2", [](PlainModes& m) { m.R = m.R.cwiseSqrt().eval(); });
    sums("U_dj", [](PlainModes& m) { m.U[m.j] = 0; });
    sums("G_k of all masses but the contact", [](PlainModes& m) {
        for (Eigen::Index k = 0; k < m.G.size(); ++k)
            if (k != m.j) m.G[k] = 0;
    });
    sums("H_j", [](PlainModes& m) { m.H_j = 0; });
    sums("the 2 zeta_i R_i u_di in H_j",
         [](PlainModes& m) { m.H_j -= 2 * m.psi.row(m.j).cwiseAbs2().dot(m.zeta.cwiseProduct(m.R).cwiseProduct(m.u)); });
    sums("the g_i in H_j", [](PlainModes& m) { m.H_j -= m.psi.row(m.j).cwiseAbs2().dot(m.g); });
    sums("gamma_j in (65)", [](PlainModes& m) { m.sum_of_squares = 1 / (m.r * m.r); });
    sums("the imaginary part of V_dj", [](PlainModes& m) { m.V[m.j].imag(0); });
    const double f = draw.factor(), g = draw.factor();
    all.push_back(in_modes("scale a function", "u_di times " + text_of(f), [f](PlainModes& m) { m.u *= f; }));
    all.push_back(in_modes("scale a function", "g_i times " + text_of(g), [g](PlainModes& m) { m.g *= g; }));
    all.push_back(in_modes("scale a function", "damped natural frequencies in R_i", [](PlainModes& m) {
        for (Eigen::Index i = 0; i < m.R.size(); ++i)
            if (m.zeta[i] < 1) m.R[i] /= std::sqrt(1 - m.zeta[i] * m.zeta[i]);
    }));
    all.push_back(in_modes("scale a function", "v_di with the other sign of its imaginary part",
                           [](PlainModes& m) { m.v = m.v.conjugate().eval(); }));
}

// Every mode shape over a norm of its own.
UnknownMistake norm(std::string told, std::function<double(const PlainModes&, Eigen::Index i)> size) {
    return in_modes("use another norm", std::move(told), [size = std::move(size)](PlainModes& m) {
        for (Eigen::Index i = 0; i < m.R.size(); ++i) {
            const double by = size(m, i);
            if (std::abs(by) > 1e-12) m.psi.col(i) /= by;
        }
    });
}

void add_norms(std::vector<UnknownMistake>& all) {
    using Index = Eigen::Index;
    all.push_back(norm("the entries add up to 1", [](const PlainModes& m, Index i) { return m.psi.col(i).sum(); }));
    all.push_back(
        norm("the sizes of the entries add up to 1", [](const PlainModes& m, Index i) { return m.psi.col(i).cwiseAbs().sum(); }));
    all.push_back(norm("the entry of the first mass is 1", [](const PlainModes& m, Index i) { return m.psi(0, i); }));
    all.push_back(
        norm("the entry of the last mass is 1", [](const PlainModes& m, Index i) { return m.psi(m.psi.rows() - 1, i); }));
    all.push_back(norm("the entry of the contact is 1", [](const PlainModes& m, Index i) { return m.psi(m.j, i); }));
    all.push_back(norm("the modal stiffness is 1", [](const PlainModes& m, Index i) { return m.r_n[i]; }));
    all.push_back(norm("the root mean square of the entries is 1", [](const PlainModes& m, Index i) {
        return std::sqrt(m.psi.col(i).squaredNorm() / static_cast<double>(m.psi.rows()));
    }));
}

void add_answers(std::vector<UnknownMistake>& all, Draw& draw) {
    const auto add = [&](std::string told, std::vector<std::string> of, std::function<double(double)> change) {
        all.push_back({"change an answer",
                       std::move(told),
                       {},
                       {},
                       [of = std::move(of), change = std::move(change)](const ProtocolQuestion& q, Value& value) {
                           if (std::find(of.begin(), of.end(), q.quantity) == of.end()) return;
                           for (double& x : value.numbers) x = change(x);
                       }});
    };
    const std::vector<std::string> phases{"phase", "phase_monoharmonic"}, amplitudes{"amplitude", "amplitude_monoharmonic"},
        limits{"beta_lim_exact", "beta_lim_paper", "beta_lim_approximate", "beta_lim_sticking"};
    for (const auto& [name, of] : {std::pair<std::string, std::vector<std::string>>{"amplitudes", amplitudes},
                                   {"boundaries", limits},
                                   {"U_dk", {"first_damping_function"}},
                                   {"V_dk", {"complex_response"}},
                                   {"H_j", {"H_j"}},
                                   {"S_j", {"S_j"}}}) {
        const double f = draw.factor();
        add(name + " times " + text_of(f), of, [f](double x) { return f * x; });
    }
    const double late = 0.3 * draw.factor(), more = 0.1 * draw.factor();
    add("phases plus " + text_of(late), phases, [late](double x) { return conformance::wrapped_angle(x + late); });
    add("phases plus pi", phases, [](double x) { return conformance::wrapped_angle(x + pi<double>()); });
    add("amplitudes plus " + text_of(more), amplitudes, [more](double x) { return x + more; });
    add("amplitudes squared", amplitudes, [](double x) { return x * x; });
    add("boundaries squared", limits, [](double x) { return x * x; });
    add("phases in gradians", phases, [](double x) { return x * 200 / pi<double>(); });
}

template <class... Arguments>
std::function<void(Arguments...)> one_after_other(const std::function<void(Arguments...)>& a,
                                                  const std::function<void(Arguments...)>& b) {
    if (!a || !b) return a ? a : b;
    return [a, b](Arguments... arguments) {
        a(arguments...);
        b(arguments...);
    };
}

} // namespace

std::vector<UnknownMistake> unknown_mistakes(std::uint64_t seed) {
    Draw draw(seed);
    std::vector<UnknownMistake> all;
    add_scaled(all, draw);
    add_swapped(all);
    add_dropped(all, draw);
    add_norms(all);
    add_answers(all, draw);
    return all;
}

UnknownMistake both(const UnknownMistake& a, const UnknownMistake& b) {
    UnknownMistake pair{"two of them",
                        a.told + "; " + b.told,
                        one_after_other<ProtocolQuestion&>(a.read, b.read),
                        {},
                        one_after_other<const ProtocolQuestion&, Value&>(a.answer_out, b.answer_out)};
    pair.choose = [a = a.choose, b = b.choose](Choices& c) {
        Choices first, second;
        if (a) a(first);
        if (b) b(second);
        c.change_modes = one_after_other<PlainModes&>(first.change_modes, second.change_modes);
        c.change_sums = one_after_other<PlainModes&>(first.change_sums, second.change_sums);
    };
    return pair;
}

std::optional<Value> answer_of(const UnknownMistake& mistake, const ProtocolQuestion& q) {
    ProtocolQuestion read = q;
    if (mistake.read) mistake.read(read);
    Choices c;
    if (mistake.choose) mistake.choose(c);
    c.closed_form_alone = true;
    std::optional<Value> value = conformance::plain_answer(read, c);
    if (value && mistake.answer_out) mistake.answer_out(q, *value);
    return value;
}

} // namespace denhartog::tests
