// The system of a question as matrices, M, K and C of (8), (73) and (19), with the rows of contact and load, and its responses
// without friction and with the contact held. Read `plain_system` first.
#include "conformance/plain/system.hpp"

#include <algorithm>
#include <cmath>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

PlainMatrix by_rows(const PlainRow& entries, std::size_t N) {
    PlainMatrix A;
    for (std::size_t i = 0; i < N; ++i)
        A.emplace_back(entries.begin() + static_cast<long>(i * N), entries.begin() + static_cast<long>((i + 1) * N));
    return A;
}

// Each spring of a chain as sqrt(kappa) times its elongation, of some of its masses: K is the product of the rows.
PlainMatrix springs_of(const PlainRow& kappa, std::size_t from, std::size_t to) {
    PlainMatrix rows;
    for (std::size_t n = from; n <= to && n < kappa.size(); ++n) {
        PlainRow row(to - from);
        const double root = std::sqrt(kappa[n]);
        if (n < to) row[n - from] = root;
        if (n > from) row[n - 1 - from] = -root;
        rows.push_back(std::move(row));
    }
    return rows;
}

// A question may break any rule: without masses, springs and a frequency there is no answer.
void require_system(const ProtocolQuestion& q, std::size_t N) {
    const auto is = [&](const PlainRow& numbers, const PlainRow& matrix, double least) {
        if (!matrix.empty()) return matrix.size() == N * N;
        return numbers.size() == N && std::ranges::all_of(numbers, [&](double x) { return x >= least && std::isfinite(x); });
    };
    constexpr double positive = 1e-300;
    const bool is_system = is(q.mass_ratios, q.mass_matrix, positive) && is(q.stiffness_ratios, q.stiffness_matrix, positive) &&
                           is(q.damping_ratios, q.damping_matrix, 0) && (q.loads.empty() || q.loads.size() == N) &&
                           (q.load_phases.empty() || q.load_phases.size() == q.loads.size());
    if (N == 0 || !is_system || !(q.r > 0) || !std::isfinite(q.r) || (!is_of_the_paper(q) && !(q.beta >= 0)))
        throw NoPlainAnswer();
}

PlainMatrix dynamic_stiffness(const PlainSystem& s) {
    PlainMatrix D = s.K;
    for (std::size_t i = 0; i < s.size(); ++i)
        for (std::size_t k = 0; k < s.size(); ++k) D[i][k] -= s.r * s.r * s.M[i][k];
    return D;
}

PlainMatrix scaled(PlainMatrix A, double by) {
    for (PlainRow& row : A)
        for (double& x : row) x *= by;
    return A;
}

// (19) from the damping ratios of the modes.
PlainMatrix damping_of(const PlainSystem& s) {
    const PlainMatrix momenta = times(s.M, s.shapes.phi);
    PlainMatrix weighted = momenta;
    for (PlainRow& row : weighted)
        for (std::size_t i = 0; i < row.size(); ++i) row[i] *= 2 * s.zeta[i] * s.shapes.r_n[i];
    return times(weighted, transposed(momenta));
}

// The ratios of a damping matrix, and whether it couples the modes.
void read_damping(PlainSystem& s) {
    const PlainMatrix in_modes = times(transposed(s.shapes.phi), times(s.C, s.shapes.phi));
    for (std::size_t i = 0; i < s.size(); ++i) {
        s.zeta.push_back(in_modes[i][i] / (2 * s.shapes.r_n[i]));
        for (std::size_t k = 0; k < i; ++k)
            if (std::abs(in_modes[i][k]) > 1e-13 * std::sqrt(in_modes[i][i] * in_modes[k][k])) s.coupled = true;
    }
}

// The load of the forces of the question; if there are none, that of the base or wall that moves: by inertia in the frame of a wall,
// by springs and dampers if it moves alone.
void read_load(PlainSystem& s, const ProtocolQuestion& q) {
    const std::size_t N = s.size();
    const bool with_wall = q.base_motion == "with_wall", wall = q.base_motion == "wall";
    s.p_i.assign(N, 0);
    if (!q.base_motion.empty()) {
        s.base = with_wall ? 1 / (s.r * s.r) : 1; // P is m_1 omega^2 X, or k_1 X
        s.frame = with_wall || wall ? s.base : 0;
        s.base_stays = wall;
    }
    if (!q.loads.empty() || q.base_motion.empty()) {
        s.p = q.loads.empty() ? place_of(q.load, N) : q.loads;
        for (std::size_t k = 0; k < q.load_phases.size(); ++k) {
            s.p_i[k] = s.p[k] * elementary::sin(q.load_phases[k]);
            s.p[k] *= elementary::cos(q.load_phases[k]);
        }
        return;
    }
    const PlainRow ones(N, 1), masses = times(s.M, ones), springs = times(s.K, ones), dampers = times(s.C, ones);
    s.p = with_wall ? masses : springs;
    for (std::size_t k = 0; k < N && !with_wall; ++k) {
        if (wall) s.p[k] = s.r * s.r * masses[k] - springs[k];
        s.p_i[k] = (wall ? -s.r : s.r) * dampers[k];
    }
}

} // namespace

PlainRow place_of(int mass, std::size_t N) {
    if (mass < 1 || static_cast<std::size_t>(mass) > N) throw NoPlainAnswer();
    PlainRow place(N);
    place[static_cast<std::size_t>(mass - 1)] = 1;
    return place;
}

PlainSystem plain_system(const ProtocolQuestion& q) {
    const std::size_t N = masses_of(q);
    require_system(q, N);
    PlainSystem s;
    s.r = q.r;
    s.beta = q.beta;
    s.mu = q.mu;
    if (q.mass_matrix.empty()) {
        s.M = square(N);
        for (std::size_t i = 0; i < N; ++i) s.M[i][i] = q.mass_ratios[i];
    } else {
        s.M = by_rows(q.mass_matrix, N);
    }
    if (!q.stiffness_matrix.empty()) s.K = by_rows(q.stiffness_matrix, N);
    const PlainMatrix springs = s.K.empty() ? springs_of(q.stiffness_ratios, 0, N) : transposed(triangle_of(s.K));
    if (s.K.empty()) s.K = times(transposed(springs), springs);
    s.shapes = shapes_of(springs, s.M);
    if (q.damping_matrix.empty()) {
        s.zeta = q.damping_ratios;
        s.C = damping_of(s);
    } else {
        s.C = by_rows(q.damping_matrix, N);
        read_damping(s);
    }
    s.w = place_of(q.contact, N);
    if (q.contact_with != 0) {
        const PlainRow other = place_of(q.contact_with, N);
        for (std::size_t i = 0; i < N; ++i) s.w[i] -= other[i];
    }
    read_load(s, q);
    return s;
}

std::vector<Phasor> plain_response(const PlainSystem& s) { return solved(dynamic_stiffness(s), scaled(s.C, s.r), s.p, s.p_i); }

std::vector<Phasor> plain_response_to_contact(const PlainSystem& s) {
    return solved(dynamic_stiffness(s), scaled(s.C, s.r), s.w, PlainRow(s.size()));
}

std::vector<Phasor> plain_response_from_ground(const PlainSystem& s) {
    const PlainRow ones(s.size(), s.base_stays ? 0 : s.base);
    PlainRow dampers = times(s.C, ones);
    for (double& x : dampers) x *= s.r;
    return solved(dynamic_stiffness(s), scaled(s.C, s.r), times(s.K, ones), dampers);
}

std::vector<Phasor> held_response(const PlainSystem& s) {
    const std::size_t N = s.size();
    PlainMatrix D = dynamic_stiffness(s), C = scaled(s.C, s.r);
    PlainRow load = s.p, load_i = s.p_i;
    for (std::size_t i = 0; i < N; ++i) {
        D[i].push_back(s.w[i]);
        C[i].push_back(0);
    }
    D.push_back(s.w);
    D.back().push_back(0);
    C.emplace_back(N + 1);
    load.push_back(0);
    load_i.push_back(0);
    return solved(D, C, load, load_i);
}

PlainPart part_of(const ProtocolQuestion& q, const PlainSystem& s, std::size_t from, std::size_t to) {
    const auto block = [&](const PlainMatrix& A) {
        PlainMatrix of;
        for (std::size_t i = from; i < to; ++i)
            of.emplace_back(A[i].begin() + static_cast<long>(from), A[i].begin() + static_cast<long>(to));
        return of;
    };
    return {block(s.M), block(s.K), block(s.C), springs_of(q.stiffness_ratios, from, to)};
}

} // namespace denhartog::conformance
