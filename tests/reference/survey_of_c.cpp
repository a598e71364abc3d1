// Results of the functions of the C interface beside those that are proved.
#include <algorithm>
#include <array>

#include "denhartog/formulas/high_frequency.hpp"
#include "tests/conformance/c_fixtures.hpp"
#include "tests/reference/surveyed_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

using Numbers = std::vector<double>;

// A call that has to succeed.
void done(int status) {
    if (status == DH_ERROR_PRECISION) throw PrecisionError(dh_last_message());
    if (status != DH_OK) throw std::runtime_error(dh_last_message());
}

const Ball& full_turn() {
    static const Ball turn = 2 * pi<Ball>();
    return turn;
}

// The system and point of a scene, as C sees them.
struct PointOfC {
    Handle system;
    double r, beta, mu;
    std::size_t N = 0;

    explicit PointOfC(const SurveyedScene& s)
        : system(handle_of(s.text)), r(*s.source->in_double().r), beta(*s.source->in_double().beta),
          mu(s.source->in_double().mu) {
        done(dh_system_masses(system.get(), &N, nullptr, nullptr));
    }
};

bool in_a_cluster(const Truth& truth, std::size_t i) {
    return std::ranges::any_of(truth.modes.clusters, [i](const auto& c) { return c.first <= i && i < c.last; });
}

void survey_modes(const PointOfC& p, const Truth& truth, SurveyOfBounds& survey) {
    const std::size_t N = p.N;
    Numbers r_n(N), zeta(N), r_n_error(N), zeta_error(N), psi(N * N), psi_error(N * N), R(N), R_error(N);
    done(dh_natural_frequency_ratios(p.system.get(), N, r_n.data(), zeta.data()));
    done(dh_natural_frequency_ratio_errors(p.system.get(), N, r_n_error.data(), zeta_error.data()));
    done(dh_mode_shapes(p.system.get(), p.r, N * N, psi.data()));
    done(dh_mode_shape_errors(p.system.get(), p.r, N * N, psi_error.data()));
    done(dh_modal_functions(p.system.get(), p.r, N, R.data(), nullptr, nullptr, nullptr));
    done(dh_modal_function_errors(p.system.get(), p.r, N, R_error.data(), nullptr, nullptr, nullptr));
    for (std::size_t i = 0; i < N; ++i) {
        survey.take("C: natural frequency ratio", r_n[i], r_n_error[i], truth.point.scene.r / truth.modes.R[i]);
        survey.take("C: zeta", zeta[i], zeta_error[i], truth.modes.zeta[i]);
        survey.take("C: R", R[i], R_error[i], truth.modes.R[i]);
        if (in_a_cluster(truth, i)) continue; // any shapes of a plane
        std::size_t largest = 0;
        for (std::size_t k = 0; k < N; ++k)
            if (std::abs(psi[k * N + i]) > std::abs(psi[largest * N + i])) largest = k;
        const bool turned = psi[largest * N + i] * static_cast<double>(truth.modes.psi[largest][i]) < 0;
        for (std::size_t k = 0; k < N; ++k) {
            const Ball& proved = truth.modes.psi[k][i];
            survey.take("C: psi", psi[k * N + i], psi_error[k * N + i], turned ? -proved : proved);
        }
    }
}

void survey_modal_functions(const PointOfC& p, const Truth& truth, SurveyOfBounds& survey) {
    Numbers R(p.N), v(2 * p.N), u(p.N), g(p.N), R_error(p.N), v_error(2 * p.N), u_error(p.N), g_error(p.N);
    if (dh_modal_functions(p.system.get(), p.r, p.N, R.data(), v.data(), u.data(), g.data()) != DH_OK) return;
    done(dh_modal_function_errors(p.system.get(), p.r, p.N, R_error.data(), v_error.data(), u_error.data(), g_error.data()));
    for (std::size_t i = 0; i < p.N; ++i) {
        const Ball &of_R = truth.modes.R[i], &zeta = truth.modes.zeta[i];
        const Complex<Ball> of_v = paper::complex_response(of_R, zeta);
        survey.take("C: v", v[2 * i], v_error[2 * i], of_v.re);
        survey.take("C: v", v[2 * i + 1], v_error[2 * i + 1], of_v.im);
        survey.take("C: u", u[i], u_error[i], paper::first_damping_function(of_R, zeta));
        survey.take("C: g", g[i], g_error[i], paper::second_damping_function(of_R, zeta));
    }
}

void survey_sums(const PointOfC& p, const Truth& truth, SurveyOfBounds& survey) {
    Numbers V(2 * p.N), U(p.N), G(p.N), V_error(2 * p.N), U_error(p.N), G_error(p.N);
    double H = 0, S = 0, H_error = 0, S_error = 0;
    done(dh_sums(p.system.get(), p.r, p.N, V.data(), U.data(), G.data(), &H, &S));
    done(dh_sum_errors(p.system.get(), p.r, p.N, V_error.data(), U_error.data(), G_error.data(), &H_error, &S_error));
    for (std::size_t k = 0; k < p.N; ++k) {
        survey.take("C: V", V[2 * k], V_error[2 * k], truth.point.responses->V[k].re);
        survey.take("C: V", V[2 * k + 1], V_error[2 * k + 1], truth.point.responses->V[k].im);
        survey.take("C: U", U[k], U_error[k], truth.point.responses->U[k]);
        survey.take("C: G", G[k], G_error[k], truth.point.responses->G[k]);
    }
    survey.take("C: H_j", H, H_error, truth.point.responses->H);
    survey.take("C: S_j", S, S_error, truth.point.boundary->S_exact);
}

void survey_boundaries(const PointOfC& p, const Truth& truth, SurveyOfBounds& survey) {
    auto b = sized<dh_boundary>(), e = sized<dh_boundary>();
    done(dh_boundaries(p.system.get(), p.r, p.mu, &b));
    done(dh_boundary_errors(p.system.get(), p.r, p.mu, &e));
    survey.take("C: beta_lim exact", b.exact, e.exact, truth.point.boundary->exact);
    survey.take("C: beta_lim paper", b.paper, e.paper, truth.point.boundary->paper);
    survey.take("C: beta_lim approximate", b.approximate, e.approximate, truth.point.boundary->approximate);
    survey.same("a sticking limit in C", b.sticking_exists != 0, truth.point.stuck.has_value());
    if (truth.point.stuck) survey.take("C: beta_lim sticking", b.sticking, e.sticking, *truth.point.sticking);
    double limit = 0, error = 0;
    if (dh_high_frequency_limit(p.system.get(), p.mu, &limit) != DH_OK) return;
    done(dh_high_frequency_limit_error(p.system.get(), p.mu, &error));
    const reference::SceneInBalls& s = truth.point.scene;
    BallMatrix by_force; // M^-1 w: V_dj and U_dj fall with w^T M^-1 p and w^T M^-1 w
    REQUIRE(solved(s.M, s.w, by_force));
    const Complex<Ball> load{(transposed(s.p) * by_force)(0), s.p_i.rows() > 0 ? (transposed(s.p_i) * by_force)(0) : Ball(0)};
    survey.take("C: high-frequency limit", limit, error,
                paper::friction_ratio_limit_at_high_frequency(s.mu) * modulus(load) / (transposed(s.w) * by_force)(0));
}

void survey_sliding(const PointOfC& p, const Truth& truth, SurveyOfBounds& survey) {
    if (!truth.slides) return;
    for (std::size_t k = 0; k < p.N; ++k) {
        auto m = sized<dh_sliding_mass>(), e = sized<dh_sliding_mass>();
        done(dh_sliding_motion(p.system.get(), p.r, p.beta, p.mu, k + 1, &m));
        done(dh_sliding_motion_errors(p.system.get(), p.r, p.beta, p.mu, k + 1, &e));
        const MassResponse<Ball>& proved = truth.masses[k];
        survey.take("C: x0", m.initial_displacement, e.initial_displacement, proved.x0);
        survey.take("C: v0", m.initial_velocity, e.initial_velocity, proved.v0);
        survey.take("C: sliding amplitude", m.amplitude, e.amplitude, proved.amplitude);
        survey.take("C: monoharmonic amplitude", m.amplitude_monoharmonic, e.amplitude_monoharmonic,
                    proved.amplitude_monoharmonic);
        if (proved.amplitude.may_vanish()) continue;
        survey.take("C: sliding phase", m.phase, e.phase, proved.phase, full_turn());
        survey.take("C: instant", m.instant, e.instant, proved.instant, pi<Ball>());
        survey.take("C: monoharmonic phase", m.phase_monoharmonic, e.phase_monoharmonic, proved.phase_monoharmonic, full_turn());
        const std::array tau{0.0, 0.75, 3.0, 5.5};
        Numbers x(tau.size()), x_error(tau.size());
        done(dh_displacement(p.system.get(), p.r, p.beta, p.mu, k + 1, tau.size(), tau.data(), x.data()));
        done(dh_displacement_errors(p.system.get(), p.r, p.beta, p.mu, k + 1, tau.size(), tau.data(), x_error.data()));
        for (std::size_t n = 0; n < tau.size(); ++n)
            survey.take("C: displacement", x[n], x_error[n], truth.displacement(k, tau[n]));
    }
}

void survey_mass(const dh_mass& m, const SolvedMass& proved, SurveyOfBounds& survey) {
    survey.take("C: amplitude", m.amplitude, m.error, ball_of(proved.amplitude));
    if (proved.phase && m.moves != 0) survey.take("C: phase", m.phase, m.phase_error, ball_of(*proved.phase), full_turn());
}

void survey_stops(const dh_solution* solution, const dh_summary& all, const Solution& proved, SurveyOfBounds& survey) {
    survey.same("the number of stops in C", all.stops, proved.stops.size());
    if (all.stops != proved.stops.size()) return;
    Numbers start(all.stops), end(all.stops), start_error(all.stops), end_error(all.stops);
    done(dh_solution_stops(solution, all.stops, start.data(), end.data()));
    done(dh_solution_stop_errors(solution, all.stops, start_error.data(), end_error.data()));
    const Ball period = all.periods * full_turn();
    for (std::size_t n = 0; n < all.stops; ++n) {
        survey.take("C: start of a stop", start[n], start_error[n], ball_of(proved.stops[n].start), period);
        survey.take("C: end of a stop", end[n], end_error[n], ball_of(proved.stops[n].end), period);
    }
}

// Holds the samples of a motion to their promise: a millionth of the amplitude beside its error.
void survey_samples(const dh_solution* solution, const Solution& proved, const Truth& truth, std::size_t N,
                    SurveyOfBounds& survey) {
    constexpr std::size_t samples = 8;
    Numbers x(samples * N);
    done(dh_solution_motion(solution, samples, x.size(), x.data(), nullptr));
    for (std::size_t n = 0; n < samples; ++n)
        for (std::size_t k = 0; k < N; ++k) {
            const Ball tau = full_turn() * Ball(n) / Ball(samples);
            Ball is;
            if (truth.slides && proved.method.model == "closed form") {
                Ball since = tau - truth.contact.phi_j; // the maximum of the contact lags phi_j behind that of the force
                while (since < Ball(0)) since += full_turn();
                while (since > full_turn()) since -= full_turn();
                is = truth.displacement(k, static_cast<double>(since)); // a double is near enough to a promise of 6 digits
            } else if (proved.method.model == "stuck response") {
                is = truth.point.stuck->X[k].re * cos(tau) - truth.point.stuck->X[k].im * sin(tau);
            } else if (n == 0) {
                is = ball_of(proved.start->x[k]);
            } else {
                continue;
            }
            survey.take("promised by C: motion", x[n * N + k], 1e-6 * proved.masses[k].amplitude.value + 1e-14, is);
        }
}

// A quantity by its name: the numbers of the other functions, to 12 digits.
void survey_quantity(const PointOfC& p, const char* name, std::size_t mass, const std::vector<Ball>& proved,
                     SurveyOfBounds& survey, const Ball& period = Ball(0)) {
    Numbers x(std::max<std::size_t>(proved.size(), 1)), e(x.size());
    std::size_t count = 0;
    if (dh_quantity(p.system.get(), name, p.r, p.beta, p.mu, mass, 0, x.size(), x.data(), &count) != DH_OK) return;
    done(dh_quantity_errors(p.system.get(), name, p.r, p.beta, p.mu, mass, 0, e.size(), e.data(), &count));
    survey.same(std::string("how many numbers there are of ") + name, count, proved.size());
    for (std::size_t n = 0; n < std::min(count, proved.size()); ++n)
        survey.take(std::string("C by name: ") + name, x[n], e[n], proved[n], period);
}

void survey_map(const PointOfC& p, const Solution& proved, SurveyOfBounds& survey) {
    Numbers amplitude(p.N);
    signed char status = 0, regime = 0;
    auto request = sized<dh_map_request>();
    request.r_count = request.beta_count = 1;
    request.r = &p.r;
    request.beta = &p.beta;
    request.mu = p.mu;
    request.threads = 1;
    auto result = sized<dh_map_result>();
    result.status = &status;
    result.regime = &regime;
    result.mass_step = 1;
    result.amplitude = amplitude.data();
    done(dh_map(p.system.get(), &request, &result));
    survey.same("whether the map of C answers", status <= DH_POINT_ON_BOUNDARY, true);
    if (status == DH_POINT_ANSWERED)
        survey.same("the regime of the map of C", static_cast<int>(regime), static_cast<int>(proved.regime.regime));
    for (std::size_t k = 0; k < p.N; ++k) {
        const Ball is = ball_of(proved.masses[k].amplitude);
        survey.take("promised by C: map", amplitude[k], 1e-6 * is.high(), is);
    }
}

} // namespace

void denhartog::tests::survey_c_functions(const SurveyedScene& scene, const Truth& truth, SurveyOfBounds& survey) {
    const PointOfC p(scene);
    survey_modes(p, truth, survey);
    survey_modal_functions(p, truth, survey);
    survey_sums(p, truth, survey);
    survey_boundaries(p, truth, survey);
    survey_sliding(p, truth, survey);
}

void denhartog::tests::survey_c_answers(const SurveyedScene& scene, const Solution& proved, const Truth& truth,
                                        SurveyOfBounds& survey) {
    const PointOfC p(scene);
    dh_solution* made = nullptr;
    done(dh_solve(p.system.get(), p.r, p.beta, p.mu, 0, &made));
    const Answered solution(made);
    auto all = sized<dh_summary>();
    done(dh_solution_summary(solution.get(), &all));
    if (all.on_boundary == 0) survey.same("the regime in C", all.regime, static_cast<int>(proved.regime.regime));
    survey.same("the period in C", all.periods, proved.periods);
    if (all.rest_interval_exists != 0 && proved.rest_interval) {
        survey.take("C: rest", all.rest_from, all.rest_error, ball_of(proved.rest_interval->from));
        survey.take("C: rest", all.rest_to, all.rest_error, ball_of(proved.rest_interval->to));
    }
    auto m = sized<dh_mass>();
    for (std::size_t k = 0; k < p.N; ++k) {
        done(dh_solution_mass(solution.get(), k + 1, &m));
        survey_mass(m, proved.masses[k], survey);
        if (k > 0) continue; // each asks for the whole motion anew, to 12 digits
        survey_quantity(p, "amplitude", 1, {ball_of(proved.masses[0].amplitude)}, survey);
        if (proved.masses[0].phase) survey_quantity(p, "phase", 1, {ball_of(*proved.masses[0].phase)}, survey, full_turn());
    }
    done(dh_solution_contact(solution.get(), &m));
    survey_mass(m, proved.between ? *proved.between : proved.masses[proved.contact.index], survey);
    survey_stops(solution.get(), all, proved, survey);
    survey_samples(solution.get(), proved, truth, p.N, survey);
    std::vector<Ball> durations;
    for (const SolvedStop& stop : proved.stops) durations.push_back(ball_of(stop.end) - ball_of(stop.start));
    std::ranges::sort(durations, [](const Ball& x, const Ball& y) { return static_cast<double>(x) < static_cast<double>(y); });
    survey_quantity(p, "stop_durations", 1, durations, survey);
    if (proved.rest_interval) survey_quantity(p, "rest_interval", 1, {ball_of(proved.rest_interval->to)}, survey);
    survey_map(p, proved, survey);
}
