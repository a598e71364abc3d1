// A motion with stops, proved. Read `proved_orbit` first: it takes a guess from double, proves the motion
// (orbit_equations.cpp), the law of friction and amplitudes (orbit_proof.cpp), and how deviations grow over a period:
// `map_of_deviations` multiplies the parts of phases and events, and `sizes_of_eigenvalues` encloses the multipliers, in double by
// Gershgorin's discs or by Arb.
#include "denhartog/reference/orbit.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/orbit/floquet.hpp"

namespace denhartog::reference {
namespace {

constexpr double narrow_multiplier = 1e-9;

// Balls that hold the sizes of all eigenvalues, which Arb makes certain from approximate ones; false if they are not bounded.
bool enclosed(const ComplexMatrix& A, const ComplexMatrix& near, const ComplexMatrix& vectors, std::vector<Ball>& sizes) {
    const slong n = acb_mat_nrows(A.a);
    ComplexMatrix found(1, n);
    acb_mat_eig_multiple(found.all(), A.a, near.all(), vectors.a, ball_bits);
    sizes.assign(n, Ball());
    for (slong i = 0; i < n; ++i) acb_abs(sizes[i].a, found.all() + i, ball_bits);
    return std::ranges::all_of(sizes, &Ball::finite);
}

// The parts of a complex matrix, and a bound of the size of each number.
struct ComplexParts {
    Matrix<double> re, im, size;

    explicit ComplexParts(const Matrix<std::complex<double>>& Z)
        : re(Z.real()), im(Z.imag()), size(re.cwiseAbs() + im.cwiseAbs()) {}
};

// Balls that hold the sizes of all eigenvalues, from approximate eigenvalues l and eigenvectors V in double, and their inverse W.
//
// The eigenvalues of A are those of (W V)^-1 W A V = diag(l) + (1 + F)^-1 S with S = W (A V - V diag(l)) and F = W V - 1. If
// Gershgorin's discs do not touch, each holds one. False if they do, or F is not small.
bool enclosed_in_double(const BallMatrix& map, std::vector<Ball>& sizes) {
    constexpr double u = 0x1p-53, more = 1 + 1e-9;
    const slong n = map.rows();
    Matrix<double> A(n, n), off(n, n); // the map in double, and how far it may be from that
    for (slong i = 0; i < n; ++i)
        for (slong k = 0; k < n; ++k) {
            A(i, k) = static_cast<double>(map(i, k));
            off(i, k) = abs(map(i, k) - Ball(A(i, k))).high();
        }
    const ApproximateEigenvectors guess = eigenvectors_of(A);
    if (guess.values.size() != n) return false;
    const ComplexParts l(guess.values), V(guess.vectors), W(guess.inverse);
    const auto scaled = [](const Matrix<double>& X, const Matrix<double>& by) { return X * by.col(0).asDiagonal(); };
    const double units = (static_cast<double>(n) + 8) * u * more; // of the sizes of what is added up
    const Matrix<double> terms = scaled(V.size, l.size) + product(A.cwiseAbs(), V.size),
                         re = product(A, V.re) - (scaled(V.re, l.re) - scaled(V.im, l.im)),
                         im = product(A, V.im) - (scaled(V.re, l.im) + scaled(V.im, l.re)),
                         left = re.cwiseAbs() + im.cwiseAbs() + units * terms + product(off, V.size) * more;
    const Matrix<double> one = Matrix<double>::Identity(n, n), F_re = product(W.re, V.re) - product(W.im, V.im) - one,
                         F_im = product(W.re, V.im) + product(W.im, V.re),
                         F = F_re.cwiseAbs() + F_im.cwiseAbs() + units * (product(W.size, V.size) + one);
    const Matrix<double> S = product(W.size, left);
    const double largest = largest_row_sum(S) * more, apart = largest_row_sum(F) * more;
    if (!(apart < 0.5)) return false;
    std::vector<double> reach;
    for (slong i = 0; i < n; ++i) reach.push_back((S.row(i).sum() + 2 * F.row(i).sum() * largest) * more);
    sizes.clear();
    for (slong i = 0; i < n; ++i) {
        for (slong k = 0; k < i; ++k)
            if (!(size_of(guess.values(i) - guess.values(k)) > (reach[i] + reach[k]) * more)) return false;
        const Ball x(l.re(i, 0)), y(l.im(i, 0));
        sizes.push_back(widened(root_of_positive(x * x + y * y), Ball(reach[i])));
    }
    return true;
}

// No eigenvalue is larger than the root of a norm of a power.
std::vector<Ball> bounded_sizes(const BallMatrix& map) {
    BallMatrix power = map;
    double least = norm(map);
    for (int n = 1; n < 12; ++n) {
        power = power * power;
        double root = norm(power);
        for (int k = 0; k < n; ++k) root = std::sqrt(root);
        root *= 1 + 1e-12;
        if (root < least) least = root; // false if a power has no bound
    }
    return std::vector<Ball>(map.rows(), Ball::within(0, least));
}

std::vector<Ball> sizes_of_eigenvalues(const BallMatrix& map, Effort* effort) {
    const slong n = map.rows();
    if (n == 1) return {abs(map(0, 0))};
    pay(effort, cost_of_ball_products(30 * static_cast<double>(n * n * n)));
    std::vector<Ball> sizes;
    if (enclosed_in_double(map, sizes) && are_narrow(sizes)) return sizes;
    const ComplexMatrix A(map);
    ComplexMatrix near(1, n), vectors(n, n);
    pay(effort, cost_of_ball_products(200 * static_cast<double>(n * n * n)));
    acb_mat_approx_eig_qr(near.all(), nullptr, vectors.a, A.a, nullptr, 0, ball_bits);
    return enclosed(A, near, vectors, sizes) ? sizes : bounded_sizes(map);
}

// The n-th largest is no less than the n-th largest lower end, and no more than the n-th largest upper end.
std::vector<Ball> descending(const std::vector<Ball>& sizes) {
    std::vector<Ball> low, high;
    for (const Ball& size : sizes) {
        Ball end;
        arb_get_abs_lbound_arf(arb_midref(end.a), size.a, ball_bits);
        low.push_back(end);
        arb_get_abs_ubound_arf(arb_midref(end.a), size.a, ball_bits);
        high.push_back(end);
    }
    const auto larger_first = [](const Ball& x, const Ball& y) { return x > y; };
    std::ranges::sort(low, larger_first);
    std::ranges::sort(high, larger_first);
    std::vector<Ball> sorted;
    for (std::size_t k = 0; k < low.size(); ++k) sorted.push_back(low[k] == high[k] ? low[k] : either(low[k], high[k]));
    return sorted;
}

// Deviations where the map starts, as columns: all of them, or those that do not move a contact at rest.
BallMatrix first_deviations(const ContactMechanics& s, bool at_rest) {
    const slong N = s.N, lead = N + s.lead;
    BallMatrix D(2 * N, at_rest ? 2 * N - 1 : 2 * N);
    for (slong c = 0, k = 0; k < 2 * N; ++k) {
        if (at_rest && k == lead) continue;
        D(k, c) = Ball(1);
        if (at_rest && k >= N) D(lead, c) = -s.w(k - N) / s.w(s.lead);
        ++c;
    }
    return D;
}

// Deviations at the end of a phase: exp(A (h + d)) = exp(A h) + A d exp(A h), and less than |A d| (exp(|A d|) - 1) |exp(A h)|.
BallMatrix through(const ProvedOrbit& orbit, const Linearised& along, slong i) {
    const BallMatrix A = orbit.s.phase(orbit.at.direction(i + 1)), &E = along.E[i];
    const Ball d = orbit.at.length(i + 1) - along.lengths[i];
    const double apart = norm(A) * abs(d).high();
    if (!(apart < 0.5)) throw Unproved("the length of a phase is too uncertain for its multipliers");
    return with_width(E + A * E * d,
                      2 * apart * elementary::expm1(apart)); // of an entry that is half of the largest in E or more
}

// Deviations after an event.
BallMatrix across(const ProvedOrbit& orbit, slong i, const BallMatrix& D) {
    const ContactMechanics& s = orbit.s;
    const slong z = 2 * s.N;
    const int before = orbit.at.direction(i), after = orbit.at.direction(i + 1);
    const BallMatrix& Z = orbit.Z[i];
    const BallMatrix row = s.ending(before, after), rate = s.phase(before) * Z, jump = rate - s.phase(after) * Z;
    const Ball falls = (row * rate)(0);
    if (falls.may_vanish()) throw Unproved("an event may be tangential");
    const BallMatrix later = -(part_of(row, 0, 0, 1, z) * D) / falls; // dt of each column
    return D + part_of(jump, 0, 0, z, 1) * later;
}

constexpr slong bits_of_multipliers[] = {64, 192}; // the next, with slopes of its own, if the slopes of the proof do not decide

// An instant moved by whole periods to [0, period), by its midpoint; the other by as many.
void bring_into_period(Ball& start, Ball& end, const Ball& period) {
    const Ball shift = Ball(std::floor(static_cast<double>(start) / static_cast<double>(period))) * period;
    start -= shift;
    end -= shift;
}

std::vector<StopOf<Ball>> stops_of(const ProvedOrbit& orbit) {
    const Ball period = Ball(2 * orbit.at.periods) * PiOf<Ball>::value();
    std::vector<StopOf<Ball>> stops;
    for (slong i = 1; i <= orbit.at.m(); ++i) {
        if (orbit.at.direction(i) != 0) continue;
        StopOf<Ball> stop{orbit.at.instant(i - 1), orbit.at.instant(i), (orbit.s.place() * orbit.Z[i - 1])(0)};
        StopOf<Ball> mirrored{stop.start + orbit.at.T(), stop.end + orbit.at.T(), -stop.x};
        bring_into_period(stop.start, stop.end, period);
        bring_into_period(mirrored.start, mirrored.end, period);
        stops.push_back(std::move(stop));
        if (orbit.at.mirrored) stops.push_back(std::move(mirrored));
    }
    std::ranges::sort(stops, {}, [](const StopOf<Ball>& stop) { return static_cast<double>(stop.start); });
    return stops;
}

void set_stability(const ProvedOrbit& orbit, OrbitInBalls& r) {
    for (const slong bits : bits_of_multipliers) {
        const Bits enough(bits + 4 * orbit.at.m());
        const MapOfDeviations map =
            map_of_deviations(orbit, bits == bits_of_multipliers[0] ? orbit.along : linearised(orbit.s, orbit.at));
        r.multipliers = multipliers_over_period(map, orbit.at.mirrored, orbit.s.effort);
        r.stable = r.multipliers.front() < Ball(1) || dies_out(map.A, orbit.s.effort);
        r.unstable = !r.stable && r.multipliers.front() > Ball(1);
        if ((r.stable || r.unstable) && are_narrow(r.multipliers)) return;
    }
}

} // namespace

MapOfDeviations map_of_deviations(const ProvedOrbit& orbit, const Linearised& along) {
    const ContactMechanics& s = orbit.s;
    const slong m = orbit.at.m(), z = 2 * s.N;
    slong first = 0; // the event that the map meets first
    while (first < m && orbit.at.direction(first) != 0) ++first;
    MapOfDeviations map{BallMatrix(), first < m};
    first %= m;
    BallMatrix D = first_deviations(s, map.from_a_stop);
    for (slong n = 0; n < m; ++n) {
        const slong i = (first + n) % m;
        D = part_of(through(orbit, along, i), 0, 0, z, z) * across(orbit, i, D);
    }
    map.A = BallMatrix(D.columns(), D.columns());
    for (slong c = 0, k = 0; k < z; ++k) {
        if (map.from_a_stop && k == s.N + s.lead) continue;
        for (slong q = 0; q < D.columns(); ++q) map.A(c, q) = orbit.at.mirrored ? -D(k, q) : D(k, q);
        ++c;
    }
    return map;
}

bool dies_out(const BallMatrix& map, Effort* effort) {
    BallMatrix power = map;
    for (int n = 0; n < 30; ++n, power = power * power) {
        const double size = norm(power);
        if (size < 1) return true;
        if (!(size < 1e100)) return false;
        pay(effort, cost_of_ball_products(static_cast<double>(map.rows() * map.rows() * map.rows())));
    }
    return false;
}

bool are_narrow(const std::vector<Ball>& sizes) {
    double largest = 1, widest = 0;
    for (const Ball& size : sizes) {
        largest = std::max(largest, size.high());
        widest = std::max(widest, size.radius());
    }
    return widest < narrow_multiplier * largest;
}

std::vector<Ball> multipliers_over_period(const MapOfDeviations& map, bool mirrored, Effort* effort) {
    std::vector<Ball> sizes = sizes_of_eigenvalues(map.A, effort);
    if (mirrored)
        for (Ball& size : sizes) size = size * size;
    if (map.from_a_stop) sizes.push_back(Ball(0));
    return descending(sizes);
}

BallMatrix OrbitInPhases::at(const Ball& tau) const {
    const OrbitUnknowns& o = orbit.at;
    const slong N = orbit.s.N;
    const Ball T = o.T();
    const double first = std::ceil(static_cast<double>(o.instant(0) - tau) / static_cast<double>(T));
    pay(orbit.s.effort, cost_of_ball_products(static_cast<double>(N * ball_bits) / 16));
    BallMatrix state(2 * N, 1);
    bool found = false;
    for (const double stretches : {first - 1, first, first + 1}) {
        const Ball there = tau + Ball(stretches) * T;
        const Ball sign(o.mirrored && std::fmod(stretches, 2) != 0 ? -1 : 1);
        for (slong i = 1; i <= o.m(); ++i) {
            const Ball start = o.instant(i - 1), end = o.instant(i);
            if (there < start || there > end) continue;
            BallMatrix Z = phases[i - 1].state((there - start) / (end - start));
            if (orbit.s.on_a_wall && o.direction(i) == 0) Z(N + orbit.s.lead) = Ball(0); // it sticks
            for (slong k = 0; k < 2 * N; ++k) {                                          // an event may be on either side
                const Ball value = sign * (k < N ? Z(k) : Z(k) * orbit.s.sigma);
                state(k) = found ? either(state(k), value) : value;
            }
            found = true;
        }
    }
    if (!found) throw Unproved("an instant is in none of the phases");
    return state;
}

OrbitInPhases orbit_in_phases(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits) {
    OrbitInPhases motion{proved_near(scene, guess, bits)};
    const Bits all(bits);
    const auto slides_and_sticks = [&](slong few) { // as friction demands
        motion.phases = in_stretches(motion.orbit, few);
        const Bits some(few);
        require_friction(motion.orbit, motion.phases);
        return true;
    };
    slong few = 64; // as many bits as it takes
    while (!if_proved([&] { return slides_and_sticks(few); }, few >= bits)) few *= 2;
    return motion;
}

OrbitInBalls proved_orbit(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits,
                          const std::vector<std::size_t>& masses, bool with_multipliers, const std::optional<Ball>& frame) {
    const OrbitInPhases motion = orbit_in_phases(scene, guess, bits);
    const ProvedOrbit& orbit = motion.orbit;
    const ContactMechanics& s = orbit.s;
    const Bits all(bits);
    OrbitInBalls r;
    r.mirrored = orbit.at.mirrored;
    r.periods = orbit.at.periods;
    r.masses.resize(s.N);
    const PeakInBalls& contact = r.masses.emplace_back(peak_of_contact(orbit));
    for (slong k = 0; k < s.N; ++k) {
        if (!masses.empty() && std::ranges::find(masses, static_cast<std::size_t>(k)) == masses.end()) continue;
        r.masses[k] = s.on_a_wall && k == s.lead ? contact : peak_of_mass(orbit, motion.phases, k);
    }
    for (slong k = 0; frame && k < s.N; ++k) r.from_ground.push_back(peak_of_mass(orbit, motion.phases, k, *frame));
    r.stops = stops_of(orbit);
    const BallMatrix start = motion.at(Ball(0));
    for (slong k = 0; k < s.N; ++k) {
        r.x.push_back(start(k));
        r.x_prime.push_back(start(s.N + k));
    }
    if (with_multipliers) set_stability(orbit, r);
    return r;
}

} // namespace denhartog::reference
