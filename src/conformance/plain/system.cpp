// The system of a question as matrices, M, K and C of (8), (73) and (19), with the rows of contact and load, and its responses
// without friction and with the contact held. Read `plain_system` first.
#include "conformance/plain/system.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

PlainRow part_of_row(const PlainRow& row, std::size_t from, std::size_t to) {
    return {row.begin() + static_cast<long>(from), row.begin() + static_cast<long>(to)};
}

PlainMatrix by_rows(const PlainRow& entries, std::size_t N) {
    PlainMatrix A;
    for (std::size_t i = 0; i < N; ++i) A.push_back(part_of_row(entries, i * N, (i + 1) * N));
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
    const PlainMatrix momenta = times(s.M, s.phi);
    PlainMatrix weighted = momenta;
    for (PlainRow& row : weighted)
        for (std::size_t i = 0; i < row.size(); ++i) row[i] *= 2 * s.zeta[i] * s.r_n[i];
    return times(weighted, transposed(momenta));
}

// The ratios of a damping matrix, and whether it couples the modes.
void read_damping(PlainSystem& s) {
    const PlainMatrix in_modes = times(transposed(s.phi), times(s.C, s.phi));
    for (std::size_t i = 0; i < s.size(); ++i) {
        s.zeta.push_back(in_modes[i][i] / (2 * s.r_n[i]));
        for (std::size_t k = 0; k < i; ++k)
            if (std::abs(in_modes[i][k]) > 1e-13 * std::sqrt(in_modes[i][i] * in_modes[k][k])) s.coupled = true;
    }
}

// The load of the forces of the question; if there are none, that of the base or wall that moves: by inertia in the frame of a
// wall, by springs and dampers if it moves alone.
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

double modulus(const Phasor& a) { return elementary::hypot(a.re, a.im); }
double argument(const Phasor& a) { return elementary::atan2(a.im, a.re); }
double times_cosine(const Phasor& a, double tau) { return a.re * elementary::cos(tau) - a.im * elementary::sin(tau); }

double dot(const PlainRow& a, const PlainRow& b) {
    double sum = 0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += a[n] * b[n];
    return sum;
}

Phasor dot(const PlainRow& a, const std::vector<Phasor>& b) {
    Phasor sum;
    for (std::size_t n = 0; n < a.size(); ++n) {
        sum.re += a[n] * b[n].re;
        sum.im += a[n] * b[n].im;
    }
    return sum;
}

PlainRow times(const PlainMatrix& A, const PlainRow& x) {
    PlainRow y(A.size());
    std::size_t i = 0;
    for (; i + 4 <= A.size(); i += 4) { // four sums at a time, none of which waits for another
        const double *a = A[i].data(), *b = A[i + 1].data(), *c = A[i + 2].data(), *d = A[i + 3].data();
        std::array<double, 4> sums{};
        for (std::size_t k = 0; k < x.size(); ++k)
            sums = {sums[0] + a[k] * x[k], sums[1] + b[k] * x[k], sums[2] + c[k] * x[k], sums[3] + d[k] * x[k]};
        std::ranges::copy(sums, y.begin() + static_cast<long>(i));
    }
    for (; i < A.size(); ++i) y[i] = dot(A[i], x);
    return y;
}

PlainMatrix transposed(const PlainMatrix& A) {
    PlainMatrix B(A.front().size(), PlainRow(A.size()));
    for (std::size_t i = 0; i < A.size(); ++i)
        for (std::size_t k = 0; k < B.size(); ++k) B[k][i] = A[i][k];
    return B;
}

PlainMatrix times(const PlainMatrix& A, const PlainMatrix& B) {
    PlainMatrix product;
    const PlainMatrix columns = transposed(B);
    for (const PlainRow& row : A) product.push_back(times(columns, row));
    return product;
}

PlainMatrix square(std::size_t n) { return PlainMatrix(n, PlainRow(n)); }

PlainRow solved(PlainMatrix A, PlainRow b) {
    const std::size_t n = b.size();
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i + 1; k < n; ++k)
            if (std::abs(A[k][i]) > std::abs(A[pivot][i])) pivot = k;
        std::swap(A[i], A[pivot]);
        std::swap(b[i], b[pivot]);
        for (std::size_t k = i + 1; k < n; ++k) {
            const double factor = A[k][i] / A[i][i];
            for (std::size_t m = i; m < n; ++m) A[k][m] -= factor * A[i][m];
            b[k] -= factor * b[i];
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) b[i] -= A[i][k] * b[k];
        b[i] /= A[i][i];
    }
    return b;
}

std::vector<Phasor> solved(const PlainMatrix& A, const PlainMatrix& B, const PlainRow& b, const PlainRow& b_i) {
    const std::size_t n = b.size();
    PlainMatrix both = square(2 * n); // of real and imaginary parts
    PlainRow right = b;
    right.insert(right.end(), b_i.begin(), b_i.end());
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k) {
            both[i][k] = both[n + i][n + k] = A[i][k];
            both[i][n + k] = -B[i][k];
            both[n + i][k] = B[i][k];
        }
    const PlainRow parts = solved(std::move(both), std::move(right));
    std::vector<Phasor> X;
    for (std::size_t i = 0; i < n; ++i) X.push_back({parts[i], parts[n + i]});
    return X;
}

PlainMatrix triangle_of(const PlainMatrix& A) {
    PlainMatrix L = square(A.size());
    for (std::size_t i = 0; i < A.size(); ++i)
        for (std::size_t k = 0; k <= i; ++k) {
            const double rest = A[i][k] - dot(L[i], L[k]);
            L[i][k] = i == k ? std::sqrt(rest) : rest / L[k][k];
        }
    return L;
}

PlainShapes shapes_of(const PlainMatrix& B, const PlainMatrix& M) {
    const std::size_t n = M.size();
    const PlainMatrix L = triangle_of(M), upper = transposed(L);
    PlainMatrix columns, turned = square(n); // of B L^-T; the same rotations of the unit matrix
    for (std::size_t i = 0; i < n; ++i) turned[i][i] = 1;
    for (const PlainRow& row : B) columns.push_back(solved(L, row));
    columns = transposed(columns);
    constexpr int most_sweeps = 60;
    bool turns = true;
    for (int sweep = 0; turns && sweep < most_sweeps; ++sweep) {
        turns = false;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = i + 1; k < n; ++k) {
                const double a = dot(columns[i], columns[i]), b = dot(columns[k], columns[k]), c = dot(columns[i], columns[k]);
                if (std::abs(c) <= 1e-16 * std::sqrt(a) * std::sqrt(b)) continue;
                turns = true;
                const double z = (b - a) / (2 * c), t = (z < 0 ? -1 : 1) / (std::abs(z) + elementary::hypot(1, z));
                const double cosine = 1 / std::sqrt(1 + t * t), sine = t * cosine;
                for (PlainMatrix* of : {&columns, &turned})
                    for (std::size_t m = 0; m < (*of)[i].size(); ++m) {
                        const double x = (*of)[i][m], y = (*of)[k][m];
                        (*of)[i][m] = cosine * x - sine * y;
                        (*of)[k][m] = sine * x + cosine * y;
                    }
            }
    }
    std::vector<std::pair<double, PlainRow>> modes;
    for (std::size_t i = 0; i < n; ++i) modes.emplace_back(std::sqrt(dot(columns[i], columns[i])), solved(upper, turned[i]));
    std::ranges::sort(modes);
    PlainShapes shapes;
    for (const auto& [r_n, shape] : modes) {
        shapes.r_n.push_back(r_n);
        shapes.phi.push_back(shape);
    }
    shapes.phi = transposed(shapes.phi);
    return shapes;
}

PlainRow increment(const PlainMatrix& A, const PlainRow& z, double dt) {
    constexpr int most_terms = 80;
    PlainRow sum(z.size()), term = z;
    double largest = 1, all = 0;
    for (int k = 1; k < most_terms && largest > 1e-18 * all; ++k) {
        term = times(A, term);
        largest = all = 0;
        for (std::size_t n = 0; n < z.size(); ++n) {
            term[n] *= dt / k;
            sum[n] += term[n];
            largest = std::max(largest, std::abs(term[n]));
            all = std::max(all, std::abs(sum[n]));
        }
    }
    return sum;
}

PlainRow moved(const PlainMatrix& A, const PlainRow& z, double dt) {
    PlainRow sum = increment(A, z, dt);
    for (std::size_t n = 0; n < z.size(); ++n) sum[n] += z[n];
    return sum;
}

PlainMatrix propagator(const PlainMatrix& A, double dt) {
    PlainMatrix columns;
    for (std::size_t k = 0; k < A.size(); ++k) {
        PlainRow unit(A.size());
        unit[k] = 1;
        columns.push_back(moved(A, unit, dt));
    }
    return transposed(columns);
}

double zero_between(const std::function<double(double)>& f, double from, double to) {
    const double before = f(from), after = f(to);
    if (before == 0) return from;
    if (!(before * after < 0)) return to;
    std::uintmax_t most = 200;
    const auto [a, b] =
        boost::math::tools::toms748_solve(f, from, to, before, after, boost::math::tools::eps_tolerance<double>(52), most);
    return (a + b) / 2;
}

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
    s.M = q.mass_matrix.empty() ? square(N) : by_rows(q.mass_matrix, N);
    for (std::size_t i = 0; i < N && q.mass_matrix.empty(); ++i) s.M[i][i] = q.mass_ratios[i];
    if (!q.stiffness_matrix.empty()) s.K = by_rows(q.stiffness_matrix, N);
    const PlainMatrix springs = s.K.empty() ? springs_of(q.stiffness_ratios, 0, N) : transposed(triangle_of(s.K));
    if (s.K.empty()) s.K = times(transposed(springs), springs);
    static_cast<PlainShapes&>(s) = shapes_of(springs, s.M);
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

std::vector<Phasor> plain_response(const PlainSystem& s, const PlainRow& b, const PlainRow& b_i) {
    return solved(dynamic_stiffness(s), scaled(s.C, s.r), b, b_i);
}

std::vector<Phasor> plain_response_from_ground(const PlainSystem& s) {
    const PlainRow ones(s.size(), s.base_stays ? 0 : s.base);
    return plain_response(s, times(s.K, ones), scaled({times(s.C, ones)}, s.r).front());
}

std::vector<Phasor> held_response(const PlainSystem& s) {
    PlainMatrix D = dynamic_stiffness(s), C = scaled(s.C, s.r);
    PlainRow row = s.w, load = s.p, load_i = s.p_i;
    for (PlainRow* each : {&row, &load, &load_i}) each->push_back(0);
    for (std::size_t i = 0; i < s.size(); ++i) {
        D[i].push_back(s.w[i]);
        C[i].push_back(0);
    }
    D.push_back(row);
    C.emplace_back(row.size());
    return solved(D, C, load, load_i);
}

PlainPart part_of(const ProtocolQuestion& q, const PlainSystem& s, std::size_t from, std::size_t to) {
    const auto block = [&](const PlainMatrix& A) {
        PlainMatrix of;
        for (std::size_t i = from; i < to; ++i) of.push_back(part_of_row(A[i], from, to));
        return of;
    };
    return {block(s.M), block(s.K), block(s.C), springs_of(q.stiffness_ratios, from, to)};
}

} // namespace denhartog::conformance
