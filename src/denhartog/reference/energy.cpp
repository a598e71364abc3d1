// The energy that friction dissipates in a period, the work of load, dampers and base, and the largest forces. Read
// `energies_of_orbit` first. The work of the load is that of the first harmonic of the motion, which `HarmonicMotions` takes
// from the equation of motion (6); `balance` fills in the rest.
#include "denhartog/reference/energy.hpp"

namespace denhartog::reference {
namespace {

using Number = Complex<Ball>;

Number operator-(const Number& a, const Number& b) { return {a.re - b.re, a.im - b.im}; }
Number operator/(const Number& a, const Number& b) { return Ball(Ball(1) / squared_modulus(b)) * (a * Number{b.re, -b.im}); }
Number turned_back(const Ball& tau) { return {cos(tau), -sin(tau)}; } // e^(-i tau)

Number load_on(const SceneInBalls& s, slong k) { return {s.p(k), s.p_i.rows() > 0 ? s.p_i(k) : Ball(0)}; }

// A^-1 p and A^-1 w: the harmonic motions that the load and a unit force on the contact make by themselves, of the masses first
// and then of the contact.
struct HarmonicMotions {
    std::vector<Number> X_of_load, X_of_contact;
    Number g{X_of_load.back()}, h{X_of_contact.back()}; // of the contact: w^T A^-1 p and w^T A^-1 w

    explicit HarmonicMotions(const SceneInBalls& s)
        : X_of_load(harmonic_response(s, s.p, s.p_i)), X_of_contact(harmonic_response(s, s.w)) {}

    // X of the masses, with the first harmonic of friction.
    [[nodiscard]] std::vector<Number> with(const Number& friction) const {
        std::vector<Number> X;
        for (std::size_t k = 0; k + 1 < X_of_load.size(); ++k) X.push_back(X_of_load[k] - X_of_contact[k] * friction);
        return X;
    }

    // The textbooks' amplitude |Y| of the contact, with 4 beta / (pi |Y|) for a dashpot:
    // g = Y (1 + 4 i beta h / (pi |Y|)).
    [[nodiscard]] std::optional<Ball> by_textbooks(const Ball& beta) const {
        const Ball b = 4 * beta / pi<Ball>(), left = squared_modulus(g) - b * b * h.re * h.re;
        if (!(left > Ball(0))) return std::nullopt;
        const Ball Y = b * h.im + sqrt(left);
        return Y > Ball(0) ? std::optional(Y) : std::nullopt;
    }
};

// The force that base or wall take up: that on the base is the row `row_of_x` of the displacements, `row_of_v` of their rates.
struct ForceOnBase {
    std::vector<Ball> row_of_x{}, row_of_v{};
    Ball part_of_d{}, part_of_d_prime{}; // the same of the base's own motion d cos tau
    bool none = true;                    // no spring and no damper touches the base

    ForceOnBase(const SceneInBalls& s, const Ball& d) {
        for (slong k = 0; k < s.N(); ++k) {
            Ball x(0), v(0);
            for (slong n = 0; n < s.N(); ++n) {
                x += s.K(n, k);
                v += s.r * s.C(n, k);
            }
            part_of_d += x * d;
            part_of_d_prime += v * d;
            none = none && x.is_zero() && v.is_zero();
            row_of_x.push_back(x);
            row_of_v.push_back(v);
        }
    }

    // Of a harmonic motion.
    [[nodiscard]] Number of(const std::vector<Number>& X) const {
        Number force{-part_of_d, -part_of_d_prime};
        for (std::size_t k = 0; k < X.size(); ++k) force = force + row_of_x[k] * X[k] + row_of_v[k] * times_i(X[k]);
        return force;
    }
};

// Fills in the energies of a motion with the first harmonic X, whose contact dissipates what is in `e` already.
//
// In the frame of the displacements the load does the work pi sum Im(conj(X_k) p_k). If the base moves by d cos tau there,
// dampers are strained by x - 1 d cos tau, and not by x.
void balance(const SceneInBalls& s, const std::vector<Number>& X, const ForceOnBase& force, const Ball& d, EnergiesInBalls& e) {
    Ball work(0);
    e.at_most = Ball(0);
    for (std::size_t k = 0; k < X.size(); ++k) {
        const Number p = load_on(s, static_cast<slong>(k));
        work += p.im * X[k].re - p.re * X[k].im;
        e.at_most += pi<Ball>() * size_in_balls(p) * size_in_balls(X[k]);
        work -= 2 * d * force.row_of_v[k] * X[k].re;
    }
    e.dampers = pi<Ball>() * (work + d * force.part_of_d_prime) - e.contact;
}

// The integral of e^(-i n tau) between two instants.
Number integral(const Ball& from, const Ball& to, int n) {
    return Ball(Ball(1) / n) * times_i(turned_back(n * to) - turned_back(n * from));
}

// A_w^T (r^2 M (x' + i x) + r C x) e^(-i tau) of a state.
Number boundary_term(const SceneInBalls& s, const HarmonicMotions& A, const BallMatrix& Z, const Ball& sigma, const Ball& tau) {
    const slong N = s.N();
    Number sum{Ball(0), Ball(0)};
    for (slong k = 0; k < N; ++k) {
        Ball re(0), im(0);
        for (slong n = 0; n < N; ++n) {
            re += s.r * s.r * s.M(k, n) * sigma * Z(N + n) + s.r * s.C(k, n) * Z(n);
            im += s.r * s.r * s.M(k, n) * Z(n);
        }
        sum = sum + A.X_of_contact[k] * Number{re, im};
    }
    return sum * turned_back(tau);
}

} // namespace

Ball motion_of_base_in_frame(BaseMotion motion) {
    return Ball(motion == BaseMotion::alone ? 1 : motion == BaseMotion::wall ? -1 : 0);
}

EnergiesInBalls energies_of_sliding(const SceneInBalls& s, const ResponsesInBalls& r, const Ball& d) {
    const Ball& beta = *s.beta;
    const HarmonicMotions A(s);
    const ForceOnBase force(s, d);
    const SteadyState<Ball> motion = sliding_motion_in_balls(r, beta);
    EnergiesInBalls e;
    e.amplitude = motion.X_j;
    e.friction = beta;
    e.contact = 4 * beta * motion.X_j;
    e.by_textbooks = A.by_textbooks(beta);
    // The velocity is minus the sine of the time from the maximum of the contact, in sign.
    const std::vector<Number> X = A.with(Ball(4 * beta / pi<Ball>()) * times_i(turned_back(motion.phi_j)));
    balance(s, X, force, d, e);
    if (force.none) return e;
    if (beta.is_zero()) {
        e.on_base = size_in_balls(force.of(X));
        return e;
    }
    const LargestBothWays largest = largest_size_of([&](const Ball& tau) {
        const Series t = Series::time(tau) + Series(motion.phi_j);
        Series sum = Series(Ball(-force.part_of_d)) * cos(t) + Series(force.part_of_d_prime) * sin(t);
        for (std::size_t k = 0; k < motion.masses.size(); ++k) {
            if (force.row_of_x[k].is_zero() && force.row_of_v[k].is_zero()) continue;
            const Series x = displacement_in_balls(r, motion.masses[k], beta, k, tau);
            sum = sum + Series(force.row_of_x[k]) * x + Series(force.row_of_v[k]) * x.derivative();
        }
        return sum;
    });
    e.on_base = largest.up ? largest.up->value : Ball(0);
    if (largest.down) e.on_base = largest.up ? larger(e.on_base, largest.down->value) : largest.down->value;
    return e;
}

EnergiesInBalls energies_of_orbit(const SceneInBalls& s, const OrbitInPhases& motion, const Ball& d) {
    const ProvedOrbit& orbit = motion.orbit;
    const OrbitUnknowns& at = orbit.at;
    // At a resonance there are none. Without a damper friction then takes all the work of the load.
    const std::optional<HarmonicMotions> A = if_proved([&] { return HarmonicMotions(s); }, norm(s.C) > 0);
    const ForceOnBase force(s, d);
    const BallMatrix place = orbit.s.place();
    Number conjugate{Ball(0), Ball(0)}, Y{Ball(0), Ball(0)}; // A_w^T conj(p); the integral of the contact's displacement
    for (slong k = 0; A && k < s.N(); ++k) {
        const Number p = load_on(s, k);
        conjugate = conjugate + A->X_of_contact[k] * Number{p.re, -p.im};
    }
    const Ball half = Ball(1) / 2;
    Ball path(0);
    bool stops = false;
    for (slong i = 1; i <= at.m(); ++i) {
        const BallMatrix &before = orbit.Z[i - 1], &after = orbit.Z[i];
        const Ball from = at.instant(i - 1), to = at.instant(i), x = (place * before)(0);
        const Number once = integral(from, to, 1);
        const int direction = at.direction(i);
        if (direction == 0) {
            stops = true;
            Y = Y + x * once;
            continue;
        }
        path += Ball(direction) * ((place * after)(0) - x);
        if (!A) continue;
        Y = Y + Ball(half * (to - from)) * A->g + half * (conjugate * integral(from, to, 2));
        Y = Y - A->h * (Ball(Ball(direction) * *s.beta) * once);
        Y = Y - (boundary_term(s, *A, after, orbit.s.sigma, to) - boundary_term(s, *A, before, orbit.s.sigma, from));
    }
    const Ball stretches = Ball(at.mirrored ? 2 : 1) / Ball(at.periods); // in a period of the force
    Y = Ball(stretches / pi<Ball>()) * Y;
    EnergiesInBalls e;
    e.amplitude = peak_of_contact(orbit).size;
    e.friction = stops ? s.mu * *s.beta : *s.beta;
    e.contact = stretches * *s.beta * path;
    if (A) {
        e.by_textbooks = A->by_textbooks(*s.beta);
        balance(s, A->with((A->g - Y) / A->h), force, d, e);
    } else {
        e.dampers = Ball(0);
        e.at_most = e.contact;
    }
    if (force.none) return e;
    BallMatrix row(1, orbit.s.n());
    for (slong k = 0; k < s.N(); ++k) {
        row(0, k) = force.row_of_x[k];
        row(0, s.N() + k) = orbit.s.sigma * force.row_of_v[k];
    }
    row(0, 2 * s.N()) = -force.part_of_d;
    row(0, 2 * s.N() + 1) = force.part_of_d_prime;
    e.on_base = largest_of_row(orbit, motion.phases, row);
    return e;
}

EnergiesInBalls energies_of_rest(const SceneInBalls& s, const StuckInBalls& stuck, const Ball& d) {
    const ForceOnBase force(s, d);
    EnergiesInBalls e;
    e.friction = size_in_balls(stuck.load);
    balance(s, stuck.X, force, d, e);
    if (!force.none) e.on_base = size_in_balls(force.of(stuck.X));
    return e;
}

} // namespace denhartog::reference
