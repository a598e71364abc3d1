#include "denhartog/sliding/contact_modes.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/model/point_rules.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/boundary.hpp"

namespace denhartog {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double units_of_mode = 8; // the forms of v, u, g are good to 4
constexpr double most_change =
    1.0 / 64; // of what an error of R or zeta may change, relative; higher orders are below a sixteenth
constexpr double higher_orders = 1 + 1.0 / 16;

double relative(const Bounded& a) { return a.e / std::abs(a.x); }

// A mode at r, with bounds of its errors.
struct ModeAtContact {
    double R;
    Complex<double> v;
    double u, g;
    double of_v, of_u, of_g; // errors
    double change_of_R;      // relative error of R
};

// None where the errors of R and zeta change too much.
std::optional<ModeAtContact> at(const ContactMode& m, const Bounded& r) {
    ModeAtContact at{};
    const double R = at.R = r.x / m.r_n.x, zeta = m.zeta.x, w = m.w;
    const evaluation::ModeFunctions<double> f = evaluation::mode_functions(R, zeta);
    const double dR = at.change_of_R = (relative(r) + relative(m.r_n) + unit) * higher_orders, dzeta = m.zeta.e;
    const double v = std::sqrt(f.v.re * f.v.re + f.v.im * f.v.im);
    const double change_of_v = 2 * R * v * ((R + zeta) * dR + dzeta);
    const double real = R * w * f.u, imaginary = f.g + zeta * R * f.u, size_2 = real * real + imaginary * imaginary;
    const double change_of_w = dzeta / (w * w), dz = std::numbers::pi / R * (dR + dzeta / w) * higher_orders;
    if (!(change_of_v <= most_change && dz * (1 + size_2) <= most_change && change_of_w <= most_change)) return std::nullopt;
    const double change_of_tangent = higher_orders * dz * (1 + size_2) / 2;
    at.v = f.v;
    at.u = f.u;
    at.g = f.g;
    at.of_v = v * (higher_orders * change_of_v + units_of_mode * unit);
    at.of_u = higher_orders * (change_of_tangent / (R * w) + std::abs(f.u) * (dR + zeta * change_of_w + units_of_mode * unit));
    at.of_g = higher_orders *
              (change_of_tangent * (1 + zeta / w) + std::abs(real) * change_of_w / w + std::abs(f.g) * units_of_mode * unit);
    return at;
}

// A sum with the errors of its terms and of its rounding.
struct Sum {
    double x = 0, e = 0, size = 0;

    void add(const Bounded& weight, double term, double error) {
        x += weight.x * term;
        e += (std::abs(weight.x) + weight.e) * error + weight.e * std::abs(term);
        size += std::abs(weight.x * term);
    }
    [[nodiscard]] Bounded bounded(std::size_t N) const { return with_bound(x, e, static_cast<double>(N + 2) * unit * size); }
};

// Demand (57) of a mode at the start, over phi_ji^2 / r^2; whether it is largest there.
Bounded demand_at_start(const ContactMode& m, const ModeAtContact& f, bool& certain) {
    const double of_u = 2 * m.zeta.x * f.R;
    const double value = f.g + of_u * f.u + 1;
    const double error = f.of_g + of_u * (f.of_u + std::abs(f.u) * (2 * f.change_of_R)) + 2 * m.zeta.e * f.R * std::abs(f.u);
    const double R_1 = 1 + f.R, terms = std::abs(f.u) * R_1 * R_1 * f.R + 2 * m.zeta.x * (1 + std::abs(f.g));
    const double doubt = R_1 * R_1 * f.R * f.of_u + 2 * m.zeta.x * f.of_g + 8 * (f.change_of_R + relative(m.zeta)) * terms;
    const double certainty = evaluation::certainty_of_start(f.R, m.zeta.x, f.u, f.g);
    certain = certainty > doubt && certainty > 8 * f.change_of_R * f.R * f.R;
    return with_bound(value, error, 4 * unit * (std::abs(f.g) + std::abs(of_u * f.u) + 1));
}

// An upper bound of the same wherever it is largest: that of `few_modes.hpp`.
double largest_demand(const ContactMode& m, const ModeAtContact& f) {
    const double c = 1 + std::abs(f.g) + f.of_g, u = std::abs(f.u) + f.of_u, uR = u * f.R, w = m.w;
    return std::numbers::pi / 2 * (std::hypot(c, (c * m.zeta.x + uR) / w) + uR * f.R) * (1 + 64 * (f.change_of_R + m.zeta.e / w));
}

struct SumsAtContact {
    Complex<Bounded> V;
    Bounded U, G;
    double demand; // an upper bound of the largest (57)
    double least;  // its value at the start, a lower bound
};

std::optional<SumsAtContact> sums_at(const ContactModes& all, const Bounded& r) {
    Sum V_re, V_im, U, G, demand, at_start;
    double others = 0;
    for (const ContactMode& m : all.modes) {
        const std::optional<ModeAtContact> f = at(m, r);
        if (!f) return std::nullopt;
        V_re.add(m.load, f->v.re, f->of_v);
        V_im.add(m.load, f->v.im, f->of_v);
        U.add(m.contact, f->u, f->of_u);
        G.add(m.contact, f->g, f->of_g);
        bool certain = false;
        const Bounded start = demand_at_start(m, *f, certain);
        at_start.add(m.square, start.x, start.e);
        if (certain)
            demand.add(m.square, start.x, start.e);
        else
            others += (m.square.x + m.square.e) * largest_demand(m, *f);
    }
    count_mode_evaluations(static_cast<long>(all.modes.size()));
    const std::size_t N = all.modes.size();
    const Bounded known = (demand.bounded(N) + with_bound(others, 0, static_cast<double>(N) * unit * others)) / (r * r);
    const Bounded least = at_start.bounded(N) / (r * r);
    return SumsAtContact{
        {V_re.bounded(N), V_im.bounded(N)}, U.bounded(N), G.bounded(N), known.x + known.e, std::max(0.0, least.x - least.e)};
}

// What the boundary (69) is not below, with a demand that is not exceeded.
double least_boundary(const SumsAtContact& s, double demand) {
    const Bounded size = modulus(s.V);
    return (size.x - size.e) / std::hypot(demand, std::abs(s.U.x) + s.U.e) * (1 - 16 * unit);
}

// What the boundary (69) is not above.
double largest_boundary(const SumsAtContact& s) {
    const Bounded size = modulus(s.V);
    return (size.x + size.e) / std::hypot(s.least, std::max(0.0, std::abs(s.U.x) - s.U.e)) * (1 + 16 * unit);
}

// The largest demand by a search, with its bound; twice that, because the instant found is not followed.
std::optional<double> demand_by_search(const ContactModes& all, const Bounded& r) {
    try {
        BoundedModes functions(all.basis, r);
        const ModeSums<Bounded> sums = mode_sums(all.basis, Mass{0}, all.load, r, functions.all());
        const double instant = instant_of_largest_demand(values_of(sums));
        const Bounded largest = sliding_demand(sums, Bounded(instant));
        const Bounded held = paper::static_friction_demand(sums.H_j, Bounded(1), sums.sum_of_squares);
        return std::max(largest.x + 2 * largest.e, held.x + 2 * held.e);
    } catch (const DomainError&) {
    } catch (const PrecisionError&) {
    }
    return std::nullopt;
}

} // namespace

ContactModes contact_modes(ModalBasis<Bounded> basis) {
    ContactModes all{std::move(basis), Mass{0}, {}};
    if (all.basis.phi.rows() > 1) all.load = Mass{1};
    const auto l = static_cast<Eigen::Index>(all.load.index);
    for (std::size_t i = 0; i < all.basis.r_n.size(); ++i) {
        const Bounded &r_n = all.basis.r_n[i], &zeta = all.basis.zeta[i];
        if (!(zeta.x + zeta.e < 1)) {
            all.modes.clear();
            return all;
        }
        const auto mode = static_cast<Eigen::Index>(i);
        const Bounded phi_j = all.basis.phi(0, mode), phi_l = all.basis.phi(l, mode), square = phi_j * phi_j;
        all.modes.push_back(
            {r_n, zeta, std::sqrt((1 - zeta.x) * (1 + zeta.x)), phi_j * phi_l / (r_n * r_n), square / (r_n * r_n), square});
    }
    return all;
}

std::optional<ContactSolution> contact_solution(const ContactModes& modes, const Bounded& r, const Bounded& beta) {
    check_frequency_ratio(r.x);
    check_friction_ratio(beta.x);
    if (modes.modes.empty()) return std::nullopt;
    const std::optional<SumsAtContact> s = sums_at(modes, r);
    if (!s) return std::nullopt;
    double slides_below = least_boundary(*s, s->demand);
    if (!(beta.x + beta.e < slides_below)) {
        if (beta.x - beta.e > largest_boundary(*s)) return std::nullopt;
        const std::optional<double> demand = demand_by_search(modes, r);
        if (!demand) return std::nullopt;
        slides_below = least_boundary(*s, *demand);
        if (!(beta.x + beta.e < slides_below)) return std::nullopt;
    }
    const Bounded X_j = evaluation::displacement_transmissibility_of_contact(s->V, s->U, s->G, beta);
    const Bounded phi_j = evaluation::phase_of_contact(s->V, s->U, beta);
    if (!(X_j.x > 0)) return std::nullopt;
    const double turn = 2 * std::numbers::pi, back = phi_j.x > std::numbers::pi ? -turn : phi_j.x <= -std::numbers::pi ? turn : 0;
    return ContactSolution{X_j, phi_j + Bounded(back, 4 * unit), slides_below};
}

} // namespace denhartog
