/// @file
/// @brief The two kinds of phases of one system at one excitation, and the events that end them.
///
/// A phase is a stretch of linear motion in modal coordinates: those of the system while the contact slides, those of the stuck
/// configuration while it sticks. Sliding ends where the velocity of the contact is zero, sticking where the load on the
/// contact leaves what static friction can hold, (74), (75).
#pragma once

#include <algorithm>
#include <utility>

#include "denhartog/scene/point_rules.hpp"
#include "denhartog/search/first_zero.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/linear_motion.hpp"

namespace denhartog {

/// @brief The phases of one system at one excitation, one at a time.
template <class T>
struct ContactPhases {
    const ContactSystem<T>* system; ///< the system
    Excitation<T> e{};              ///< frequency and friction
    std::size_t N;                  ///< number of masses
    LinearMotion<T> sliding;        ///< the motion while the contact slides
    LinearMotion<T> sticking;       ///< the motion while it sticks
    Column<T> w;                    ///< M^-1 e_j / r^2: accelerations that a unit force on the contact makes
    T inertia;                      ///< 1 / w_j
    Matrix<T> stuck_momentum;       ///< phi^T M of the stuck configuration: its modal coordinates of a state
    Column<T> k_j;                  ///< stiffness that the stuck modes bring to the contact
    Column<T> c_j;                  ///< damping that they bring
    Column<T> m_j;                  ///< inertia that they bring
    T load_per_energy;              ///< bound of a derivative of the load on the contact over the energy norm of that order
    T load_rest;                    ///< what the inertia of the others adds to that bound
    T load_growth;                  ///< how fast the bound grows
    T direct;                       ///< part of the force that acts on the contact itself
    T step;                         ///< a step that the search for events took
    std::vector<T> x;               ///< displacements at the start of the phase
    std::vector<T> v;               ///< velocities at the start of the phase
    int touching = 0;               ///< events so tangential that rounding decided them
    Effort* effort;                 ///< what the evaluations spend

    static constexpr int most_tangencies = 64; ///< in one phase; more are a load that lies on the limit to rounding

    /// @param s the system @param excitation frequency and friction @param allowed the work allowed
    ContactPhases(const ContactSystem<T>& s, const Excitation<T>& excitation, Effort& allowed)
        : system(&s), N(s.basis.r_n.size()), effort(&allowed) {
        sliding.resize(N);
        sticking.resize(N - 1);
        sliding.effort = sticking.effort = &effort;
        stuck_momentum = transpose_times(s.stuck.phi, s.stuck.M);
        set(excitation);
    }

    /// @brief Sets frequency and friction anew. @param excitation frequency and friction @throws InputError
    void set(const Excitation<T>& excitation) {
        check_frequency_ratio(excitation.r);
        check_friction_ratio(excitation.beta);
        check_static_friction(excitation.mu);
        step = T(1);
        const bool same_frequency = excitation.r == e.r;
        e = excitation;
        if (same_frequency) return;
        const ModalBasis<T>& basis = system->basis;
        const T r2 = e.r * e.r;
        for (std::size_t i = 0; i < N; ++i) {
            set_mode(sliding, i, basis.r_n[i], T(basis.zeta[i] * basis.r_n[i]));
            sliding.F[i] = system->modal_load[i] / r2;
        }
        if (basis.coupled()) sliding.D = basis.D / e.r;
        sliding.prepare();
        w = basis.phi * basis.phi.row(system->contact.index).transpose() / r2;
        inertia = 1 / w[system->contact.index];
        direct = direct_load(system->stuck, system->contact, system->load);
        set_sticking(r2);
    }

    /// @brief Sets a mode of a motion at the frequency of the load. @param m the motion @param i the mode
    /// @param r_n           natural frequency ratio
    /// @param half_damping  decay rate over omega_1, zeta r_n
    void set_mode(LinearMotion<T>& m, std::size_t i, const T& r_n, const T& half_damping) {
        m.omega_0[i] = r_n / e.r;
        m.gap[i] = (e.r - r_n) / e.r * (1 + m.omega_0[i]);
        m.decay[i] = half_damping / e.r;
    }

    /// @brief Sets the motion while the contact sticks. @param r2 square of the frequency ratio
    void set_sticking(const T& r2) {
        const StuckConfiguration<T>& s = system->stuck;
        k_j = s.phi.transpose() * column(s.k_j);
        c_j = s.phi.transpose() * column(s.c_j) * e.r;
        m_j = s.phi.transpose() * column(s.m_j) * r2;
        column(sticking.F) = column(system->stuck_load) / r2;
        for (std::size_t i = 0; i + 1 < N; ++i) {
            set_mode(sticking, i, s.r_n[i], T(s.damping(i, i) / 2));
        }
        if (!s.modes_diagonalise_damping) sticking.D = s.damping / e.r;
        sticking.prepare();
        T stiffness(0), fastest(0); // for the bound of a derivative of the load by the energy of the stuck modes
        for (std::size_t i = 0; i + 1 < N; ++i) {
            const T k = k_j[i] / sticking.omega_0[i];
            stiffness += k * k;
            fastest = std::max(fastest, T(sticking.omega_0[i] + 2 * sticking.decay[i]));
        }
        if (sticking.coupled()) fastest += largest_row_sum(sticking.D);
        const T force = column(sticking.F).norm(), inertial = m_j.norm();
        load_per_energy = sqrt(stiffness) + c_j.norm() + fastest * inertial;
        load_rest = inertial * force;
        load_growth = load_per_energy * force;
    }

    /// @brief The state at the start of a phase, taken into the coordinates of its motion.
    /// @param direction  1 or -1 as the contact slides, 0 where it sticks
    /// @param tau        instant of the start
    void start_phase(int direction, const T& tau) {
        LinearMotion<T>& motion = direction == 0 ? sticking : sliding;
        const std::size_t j = system->contact.index;
        const T r2 = e.r * e.r;
        if (direction != 0) {
            column(sliding.q[0]).noalias() = system->momentum * column(x);
            column(sliding.q[1]).noalias() = system->momentum * column(v);
            column(sliding.G) = -direction * e.beta / r2 * system->basis.phi.row(j).transpose();
        } else if (N > 1) {
            Column<T> others_x(N - 1), others_v(N - 1);
            for (std::size_t n = 0; n + 1 < N; ++n) {
                others_x(n) = x[system->stuck.masses[n].index];
                others_v(n) = v[system->stuck.masses[n].index];
            }
            column(sticking.q[0]).noalias() = stuck_momentum * others_x;
            column(sticking.q[1]).noalias() = stuck_momentum * others_v;
            column(sticking.G) = -x[j] / r2 * k_j;
        }
        motion.start(tau);
    }

    /// @brief Displacement, velocity or acceleration of every mass at the instant last evaluated.
    /// @param direction  1 or -1 as the contact slides, 0 where it sticks
    /// @param order      0 to 2
    /// @param out        gets a value a mass
    void masses_of(int direction, int order, std::vector<T>& out) const {
        out.resize(N);
        if (direction != 0) {
            column(out).noalias() = system->basis.phi * column(sliding.q[order]);
            return;
        }
        out[system->contact.index] = order == 0 ? x[system->contact.index] : T(0);
        if (N == 1) return;
        const Column<T> others = system->stuck.phi * column(sticking.q[order]);
        for (std::size_t n = 0; n + 1 < N; ++n) out[system->stuck.masses[n].index] = others(n);
    }

    /// @brief Velocity of the contact in the direction of the phase.
    /// @param direction  1 or -1
    /// @param t          time from the start of the phase
    /// @return           value, three derivatives and their bounds
    Jet<T> velocity(int direction, const T& t) {
        using std::abs;
        effort->spend(sliding.cost());
        sliding.differentiate_at(t);
        Jet<T> jet{{T(0), T(0), T(0), T(0)}, T(0), T(0), T(0), T(0)};
        for (std::size_t i = 0; i < N; ++i) {
            const T phi = direction * system->basis.phi(system->contact.index, i);
            for (int m = 0; m < 4; ++m) jet.f[m] += phi * sliding.q[m + 1][i];
            if (!sliding.coupled()) {
                jet.bound += abs(phi) * sliding.energy_norm(4, i);
                jet.second += abs(phi) * sliding.energy_norm(2, i);
            }
            jet.growth += abs(phi * sliding.F[i]);
            jet.noise += abs(phi * sliding.q[1][i]);
        }
        if (sliding.coupled()) { // energy goes from mode to mode
            const T size = system->basis.phi.row(system->contact.index).norm();
            jet.bound = size * sliding.energy_norm(4);
            jet.second = size * sliding.energy_norm(2);
            jet.growth = size * column(sliding.F).norm();
        }
        jet.noise *= std::numeric_limits<T>::epsilon();
        return jet;
    }

    /// @brief What the contact carries while it sticks: everything but friction.
    /// @param t  time from the start of the phase
    /// @return   value, three derivatives and their bounds
    Jet<T> load(const T& t) {
        using std::abs;
        effort->spend(sticking.cost());
        sticking.differentiate_at(t);
        const T &c = sticking.cos_tau(), &s = sticking.sin_tau();
        const T pull = system->stuck.k_jj * x[system->contact.index];
        Jet<T> jet{
            {direct * c - pull, -direct * s, -direct * c, direct * s}, abs(direct), T(0), abs(pull) + abs(direct), abs(direct)};
        for (std::size_t i = 0; i + 1 < N; ++i) {
            for (int m = 0; m < 4; ++m)
                jet.f[m] -= k_j[i] * sticking.q[m][i] + c_j[i] * sticking.q[m + 1][i] + m_j[i] * sticking.q[m + 2][i];
            jet.noise += abs(k_j[i] * sticking.q[0][i]) + abs(c_j[i] * sticking.q[1][i]) + abs(m_j[i] * sticking.q[2][i]);
        }
        if (N > 1) {
            jet.bound += load_per_energy * sticking.energy_norm(4) + load_rest;
            jet.second += load_per_energy * sticking.energy_norm(2) + load_rest;
            jet.growth = load_growth;
        }
        jet.noise *= std::numeric_limits<T>::epsilon();
        return jet;
    }

    /// @brief Where a sliding phase ends: its velocity is zero.
    /// @param direction  1 or -1
    /// @param length     length of the stretch that is left
    /// @param order      order of the zero at its start
    /// @return           the event
    Event<T> end_of_sliding(int direction, const T& length, int order) {
        auto at = [&](const T& t) { return velocity(direction, t); };
        const std::optional<Crossing<T>> zero = first_crossing(at, T(0), length, order, step, *effort);
        if (!zero) return {length, direction, 0, T(0), false};
        if (zero->open) return {zero->t, direction, 0, T(0), false, true};
        const Jet<T> jet = velocity(direction, zero->t);
        touching += zero->touches;
        const T along = e.beta + inertia * jet.f[1]; // load on the contact along the motion
        if (zero->touches && e.mu == 1 && jet.f[2] > 0 && order == 0)
            return {zero->t, direction, 2, T(direction * e.beta), true}; // it touches zero and goes on
        if (along < -e.mu * e.beta) return {zero->t, -direction, 1, T(direction * along), true};
        if (along > e.mu * e.beta) return {zero->t, direction, 1, T(direction * along), true};
        return {zero->t, 0, 0, T(direction * along), true};
    }

    /// @brief Where a sticking phase of a single mass ends: the load on it is p cos tau - k_jj x_j, whose passage out of the cone
    /// has a closed form.
    /// @param tau     instant of the start
    /// @param length  length of the stretch that is left
    /// @return        the event
    Event<T> end_of_sticking_alone(const T& tau, const T& length) {
        using std::ceil;
        using std::sqrt;
        const T holds = e.mu * e.beta;
        const T force = system->stuck.k_jj * x[0];
        Event<T> event{length, 0, 0, T(0), false};
        for (const int side : {1, -1}) {
            const T y = (force + side * holds) / direct;
            if (!(y > -1 && y < 1)) continue;
            const T angle = atan2(T(sqrt(T((1 - y) * (1 + y)))), y), passage = direct < 0 ? T(side * angle) : T(-side * angle);
            const T t = std::max(T(0), T(passage + 2 * pi<T>() * ceil(T((tau - passage) / (2 * pi<T>()))) - tau));
            if (t < event.t) event = {t, side, e.mu == 1 ? 2 : 1, T(side * holds), true};
        }
        return event;
    }

    /// @brief Where a sticking phase ends: the load on the contact is more than friction holds.
    /// @param length  length of the stretch that is left
    /// @return        the event
    Event<T> end_of_sticking(const T& length) {
        const T holds = e.mu * e.beta;
        Event<T> event{length, 0, 0, T(0), false};
        const Jet<T> at_start = load(T(0));
        for (const int side : {1, -1}) {
            auto at = [&](const T& t) {
                Jet<T> jet = t == 0 ? at_start : load(t);
                for (T& f : jet.f) f = -side * f;
                jet.f[0] += holds;
                return jet;
            };
            T from(0);
            int order = 0;
            for (int tangencies = 0; from < event.t;) {
                const std::optional<Crossing<T>> zero = first_crossing(at, from, event.t, order, step, *effort);
                if (!zero) break;
                if (!zero->open && zero->touches) {
                    ++touching;
                    const Jet<T> jet = at(zero->t);
                    const bool turns_back = jet.f[2] > 0 && zero->t > from, recedes = jet.f[1] > 0;
                    if ((turns_back || recedes) && ++tangencies < most_tangencies) {
                        from = zero->t; // the load reaches what friction holds and draws back: the contact stays
                        order = turns_back ? 2 : 1;
                        continue;
                    }
                }
                event = {zero->t, side, e.mu == 1 ? 2 : 1, T(side * holds), true};
                if (zero->open) event = {zero->t, 0, 0, T(0), false, true};
                break;
            }
        }
        return event;
    }

    /// @brief Direction of the first phase of a stretch, from the velocity or else from the load on the contact.
    /// @param tau  instant of the start
    /// @return     1, -1 or 0, and the order of the zero of the velocity there
    std::pair<int, int> first_direction(const T& tau) {
        const T& v_j = v[system->contact.index];
        if (v_j != 0) return {v_j > 0 ? 1 : -1, 0};
        start_phase(0, tau);
        const Jet<T> Q = load(T(0));
        const T holds = e.mu * e.beta;
        for (const int side : {1, -1})
            if (side * Q.f[0] > holds) return {side, 1};
        return {0, 0};
    }
};

} // namespace denhartog
