// Every number that the library tells of the scenes of tests/scenes.jsonl in double lies within its bound of the proved number.
#include <fstream>
#include <set>

#include "denhartog/denhartog.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/reference/surveyed_scenes.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr slong bits = 256;

Ball full_turns(int n) { return 2 * n * pi<Ball>(); }

void survey_number(const std::string& kind, const Certified& told, const Certified& proved, SurveyOfBounds& survey,
                   const Ball& period = Ball(0)) {
    survey.take(kind, told.value, told.error, ball_of(proved), period);
}

void survey_limits(const Limits& told, const Limits& proved, SurveyOfBounds& survey) {
    survey_number("limits: exact", told.exact, proved.exact, survey);
    survey_number("limits: paper", told.paper, proved.paper, survey);
    survey_number("limits: approximate", told.approximate, proved.approximate, survey);
    survey.same("a sticking limit", told.sticking.has_value(), proved.sticking.has_value());
    if (told.sticking && proved.sticking) survey_number("limits: sticking", *told.sticking, *proved.sticking, survey);
}

void survey_mass(const std::string& kind, const SolvedMass& told, const SolvedMass& proved, SurveyOfBounds& survey) {
    survey_number(kind + ": amplitude", told.amplitude, proved.amplitude, survey);
    if (!proved.phase || !told.phase) return; // which masses do not move is told by amplitudes
    survey_number(kind + ": phase", *told.phase, *proved.phase, survey, full_turns(1));
    if (!told.sliding || !proved.sliding) return;
    const SlidingOfMass &a = *told.sliding, &b = *proved.sliding;
    survey_number("sliding: x0", a.x0, b.x0, survey);
    survey_number("sliding: v0", a.v0, b.v0, survey);
    survey_number("sliding: instant", a.instant, b.instant, survey, pi<Ball>()); // the end of the half-period mirrors its start
    survey_number("sliding: monoharmonic amplitude", a.amplitude_monoharmonic, b.amplitude_monoharmonic, survey);
    survey_number("sliding: monoharmonic phase", a.phase_monoharmonic, b.phase_monoharmonic, survey, full_turns(1));
}

// Distance of a stop of an answer from a proved stop some periods of the force later, in the period of the motion.
double apart_in_time(const SolvedStop& told, const SolvedStop& proved, int later, int periods) {
    const double turn = 2 * pi<double>();
    return std::abs(std::remainder(told.start.value - proved.start.value - turn * later, turn * periods));
}

const SolvedStop& nearest_stop(const SolvedStop& told, const Solution& proved, int later) {
    return *std::ranges::min_element(proved.stops, {},
                                     [&](const SolvedStop& stop) { return apart_in_time(told, stop, later, proved.periods); });
}

// A motion of several periods is the same motion whichever of them comes first.
int periods_later(const Solution& told, const Solution& proved) {
    const auto off = [&](int later) {
        double most = 0;
        for (const SolvedStop& stop : told.stops)
            most = std::max(most, apart_in_time(stop, nearest_stop(stop, proved, later), later, proved.periods));
        return most;
    };
    int best = 0;
    for (int later = 1; later < told.periods; ++later)
        if (off(later) < off(best)) best = later;
    return best;
}

void survey_orbit(const Solution& told, const Solution& proved, SurveyOfBounds& survey) {
    survey.same("the number of stops", told.stops.size(), proved.stops.size());
    survey.same("the period", told.periods, proved.periods);
    survey.same("the mirror image", told.symmetric, proved.symmetric);
    const int later = told.stops.size() == proved.stops.size() ? periods_later(told, proved) : 0;
    const auto instant = [&](const std::string& kind, const Certified& of, const Certified& is) {
        survey.take(kind, of.value, of.error, ball_of(is) + full_turns(later), full_turns(told.periods));
    };
    for (std::size_t n = 0; told.stops.size() == proved.stops.size() && n < told.stops.size(); ++n) {
        const SolvedStop &a = told.stops[n], &b = nearest_stop(a, proved, later);
        instant("stop: start", a.start, b.start);
        instant("stop: end", a.end, b.end);
        survey_number("stop: x", a.x, b.x, survey);
    }
    for (std::size_t k = 0; told.start && proved.start && later == 0 && k < told.start->x.size(); ++k) {
        survey_number("start: x", told.start->x[k], proved.start->x[k], survey);
        survey_number("start: x'", told.start->x_prime[k], proved.start->x_prime[k], survey);
    }
    if (!told.stability || !proved.stability) return;
    if (told.stability->stable) survey.same("stability", true, proved.stability->stable); // else it is not certain in double
    const auto &a = told.stability->multipliers, &b = proved.stability->multipliers;
    survey.same("the number of multipliers", a.size(), b.size());
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) survey_number("multipliers", a[n], b[n], survey);
}

} // namespace

void denhartog::tests::survey_answer(const std::string& kind, const Solution& told, const Solution& proved,
                                     SurveyOfBounds& survey) {
    if (!told.regime.on_boundary) survey.same("the regime of " + kind, name(told.regime.regime), name(proved.regime.regime));
    if (told.limits && proved.limits) survey_limits(*told.limits, *proved.limits, survey);
    if (told.sticking_by_88 && proved.sticking_by_88)
        survey_number("sticking by (88)", *told.sticking_by_88, *proved.sticking_by_88, survey);
    for (const SolvedMass& m : told.masses) {
        const auto k = told.only ? told.only->index : static_cast<std::size_t>(&m - told.masses.data());
        survey_mass(kind, m, proved.masses[k], survey);
    }
    if (told.between && proved.between) survey_mass(kind + ", between", *told.between, *proved.between, survey);
    if (told.rest_interval && proved.rest_interval) {
        survey_number("rest: from", told.rest_interval->from, proved.rest_interval->from, survey);
        survey_number("rest: to", told.rest_interval->to, proved.rest_interval->to, survey);
    }
    survey_orbit(told, proved, survey);
}

namespace {

// Holds `map` to its promises, which stand in the place of a bound.
void survey_map(const SurveyedScene& s, const Solution& proved, SurveyOfBounds& survey) {
    const Scene<double> scene = denhartog::scene(s.text);
    const RegimeMap told = map(scene, {*scene.r}, {*scene.beta});
    survey.same("whether the map answers", has_numbers(told.points[0].status), true);
    if (!has_numbers(told.points[0].status)) return;
    if (told.points[0].status == PointStatus::answered)
        survey.same("the regime of the map", name(told.points[0].regime), name(proved.regime.regime));
    survey.same<std::size_t>("the stops of the map", static_cast<std::size_t>(told.points[0].stops), proved.stops.size());
    for (std::size_t k = 0; k < told.amplitudes.size(); ++k) {
        const Ball amplitude = ball_of(proved.masses[k].amplitude);
        survey.take("promised by map: amplitude", told.amplitudes[k], 1e-6 * amplitude.high(), amplitude);
    }
}

void survey_quantities(const SceneSource& source, const Truth& truth, SurveyOfBounds& survey) {
    const std::vector<double> tau{0.5, 4.25};
    const QuantitiesAnswer told = quantities(source, tau, 10);
    std::map<std::string, std::size_t> read; // displacements by instant, then by mass
    list<Bounded<double>>(told.numbers,
                          [&](const char* name, std::size_t mass, const Bounded<double>& x, const Bounded<double>&) {
                              const std::string of = name;
                              const std::size_t k = mass == 0 ? 0 : mass - 1;
                              const auto take = [&](const Ball& proved, const Ball& period = Ball(0)) {
                                  survey.take("quantities: " + of, x.x, x.e, proved, period);
                              };
                              if (of == "Re V") take(truth.point.responses->V[k].re);
                              if (of == "Im V") take(truth.point.responses->V[k].im);
                              if (of == "U") take(truth.point.responses->U[k]);
                              if (of == "G") take(truth.point.responses->G[k]);
                              if (of == "H") take(truth.point.responses->H);
                              if (of == "S") take(truth.point.boundary->S_exact);
                              if (of == "beta_lim") take(truth.point.boundary->exact);
                              if (of == "X_j") take(truth.contact.X_j);
                              if (of == "phi_j") take(truth.contact.phi_j, full_turns(1));
                              if (of == "x") take(truth.displacement(k, tau[read[of]++ / truth.masses.size()]));
                          });
}

// What `functions` and `boundary` of the program print, of a scene whose modes have functions.
void survey_program(const SurveyedScene& s, const Truth& truth, SurveyOfBounds& survey) {
    const auto printed = [&](const std::string& command) { return nlohmann::json::parse(run_program(command, s.text).output); };
    const nlohmann::json all = printed("functions --json"), b = printed("boundary --json");
    const auto take = [&](const std::string& key, const nlohmann::json& of, const nlohmann::json& bounds, const auto& proved) {
        const auto number = [&](const nlohmann::json& x, const Ball& is) {
            survey.take("program: " + key, x.get<double>(), bounds.at(key).get<double>(), is);
        };
        if constexpr (std::is_same_v<std::decay_t<decltype(proved)>, Ball>) {
            number(of.at(key), proved);
        } else {
            number(of.at(key).at(0), proved.re);
            number(of.at(key).at(1), proved.im);
        }
    };
    survey.same("how many modes the program prints", all.at("modes").size(), truth.modes.R.size());
    for (std::size_t i = 0; i < truth.modes.R.size(); ++i) {
        const nlohmann::json& mode = all.at("modes").at(i);
        const Ball &R = truth.modes.R[i], &zeta = truth.modes.zeta[i];
        take("natural_frequency_ratio", mode, mode.at("error_bounds"), truth.point.scene.r / R);
        take("R", mode, mode.at("error_bounds"), R);
        take("zeta", mode, mode.at("error_bounds"), zeta);
        take("v", mode, mode.at("error_bounds"), paper::complex_response(R, zeta));
        take("u", mode, mode.at("error_bounds"), paper::first_damping_function(R, zeta));
        take("g", mode, mode.at("error_bounds"), paper::second_damping_function(R, zeta));
    }
    const reference::ResponsesInBalls& sums = *truth.point.responses;
    const Boundary<Ball>& limits = *truth.point.boundary;
    for (std::size_t k = 0; k < all.at("masses").size(); ++k) {
        const nlohmann::json& mass = all.at("masses").at(k);
        take("V", mass, mass.at("error_bounds"), sums.V[k]);
        take("U", mass, mass.at("error_bounds"), sums.U[k]);
        take("G", mass, mass.at("error_bounds"), sums.G[k]);
    }
    take("H_j", all, all.at("error_bounds"), sums.H);
    take("exact", all.at("S_j"), all.at("error_bounds").at("S_j"), limits.S_exact);
    take("paper", all.at("S_j"), all.at("error_bounds").at("S_j"), limits.S_paper);
    const nlohmann::json &beta_lim = b.at("beta_lim"), &bounds = b.at("beta_lim_error_bounds");
    take("exact", beta_lim, bounds, limits.exact);
    take("paper", beta_lim, bounds, limits.paper);
    take("approximate", beta_lim, bounds, limits.approximate);
    if (truth.point.stuck) take("sticking", beta_lim, bounds, *truth.point.sticking);
}

// The point with each number taken as a double, as C gives it.
SceneSource in_doubles_of_c(const SurveyedScene& s) {
    const Scene<double>& scene = s.source->in_double();
    return at_point(with_static_friction(s.source, scene.mu), *scene.r, *scene.beta);
}

} // namespace

Solution denhartog::tests::proved_answer(const SceneSource& source) {
    Question question;
    question.digits = 25;
    question.proved = true;
    return solve(source, question);
}

namespace {

// A part of the library may say that it has no digits; that is no number, and no fault.
template <class Part>
void unless_refused(SurveyOfBounds& survey, const Part& part) {
    try {
        part();
    } catch (const PrecisionError& e) {
        survey.refusals.push_back(std::string(e.what()) + ", " + survey.scene);
    }
}

void survey_scene(const SurveyedScene& s, SurveyOfBounds& survey) {
    const Bits enough(bits);
    Solution proved = proved_answer(s.source);
    survey_answer("solve", solve(s.source, {}), proved, survey);
    for (const Asked asked : {Asked::amplitude, Asked::phase}) {
        Question question;
        question.asked = asked;
        survey_answer("solve in part", solve(s.source, question), proved, survey);
        question.mass = proved.contact;
        survey_answer("solve of the contact", solve(s.source, question), proved, survey);
    }
    if (s.of_doubles) survey_map(s, proved, survey);
    const SceneSource point = s.of_doubles ? s.source : in_doubles_of_c(s);
    if (!s.of_doubles) proved = proved_answer(point);
    const Truth truth(point);
    unless_refused(survey, [&] { survey_quantities(point, truth, survey); });
    if (s.of_doubles && !s.couples_modes) survey_program(s, truth, survey);
    unless_refused(survey, [&] { survey_c_functions(s, truth, survey); });
    unless_refused(survey, [&] { survey_c_answers(s, proved, truth, survey); });
}

const SurveyOfBounds& survey() {
    static const SurveyOfBounds all = [] {
        SurveyOfBounds made;
        for (const SurveyedScene& s : surveyed_scenes()) {
            made.scene = s.text;
            try {
                survey_scene(s, made);
            } catch (const std::exception& e) {
                made.differences.push_back(std::string(e.what()) + ", " + s.text);
            }
        }
        return made;
    }();
    return all;
}

// Where a promise of digits stands in place of a bound.
bool has_a_promise_only(const std::string& kind) { return kind.starts_with("promised"); }

} // namespace

const std::vector<SurveyedScene>& denhartog::tests::surveyed_scenes() {
    static const std::vector<SurveyedScene> all = [] {
        std::ifstream file(source_file("tests/scenes.jsonl"));
        std::vector<SurveyedScene> read;
        for (std::string line; std::getline(file, line);) {
            const nlohmann::json json = nlohmann::json::parse(line);
            bool of_doubles = !json.contains("masses");
            for (const nlohmann::json& value : json.flatten())
                if (value.is_string() && value != json.value("comment", "") && value != json.value("base_motion", ""))
                    of_doubles = false;
            const SceneSource source = scene_source(SceneText{line});
            const bool couples = json.contains("damping_matrix") && modal_basis(read_scene<Real100>(line).system).couples;
            read.push_back({line, json, source, couples, of_doubles});
        }
        return read;
    }();
    return all;
}

TEST_CASE("the surveyed scenes are of every kind", "[scenes]") {
    std::map<std::string, int> count;
    std::set<std::size_t> N;
    for (const SurveyedScene& s : surveyed_scenes()) {
        const Scene<double>& scene = s.source->in_double();
        const System<double>& system = scene.system;
        INFO(s.text);
        N.insert(number_of_masses(system));
        count["mu above 1"] += scene.mu > 1;
        count["between two masses"] += s.json["contact"].is_array();
        count["load vector"] += s.json.contains("load") && s.json["load"].is_array();
        count["load phases"] += s.json.contains("load_phases");
        count["base motion"] += s.json.contains("base_motion");
        count["load of a frequency"] += load_depends_on_frequency(system);
        count["dimensional"] += s.json.contains("masses");
        count["damping matrix"] += s.json.contains("damping_matrix");
        count["no chain"] += s.json.contains("stiffness_matrix");
        for (const double zeta : system.damping_ratios) {
            count["overdamped"] += zeta >= 1;
            count["no damping"] += zeta == 0;
        }
        count["small r"] += *scene.r < 0.06;
        count["large r"] += *scene.r > 10;
    }
    REQUIRE(surveyed_scenes().size() >= 120);
    REQUIRE(N.size() == 12);
    CHECK(*N.rbegin() == 12);
    CHECK(count.size() == 13);
    for (const auto& [kind, number] : count) {
        INFO(kind);
        CHECK(number >= 3);
    }
}

TEST_CASE("every number in double lies within its bound of the proved one",
          "[scenes][eq:33][eq:34][eq:35][eq:38][eq:39][eq:44][eq:45][eq:46][eq:47][eq:52][eq:53][eq:56][eq:64][eq:67][eq:69]"
          "[eq:86][eq:87][eq:88]") {
    long numbers = 0, without = 0;
    for (const auto& [kind, held] : survey().kinds) {
        numbers += static_cast<long>(held.size());
        for (const NumberHeld& n : survey().beyond(kind, 1)) {
            INFO(kind << " is off by " << n.off << ": " << n.where);
            CHECK(n.off <= n.bound);
        }
    }
    for (const auto& [kind, count] : survey().without_bound) without += count;
    std::printf("%ld numbers in %zu kinds, %ld without a bound\n", numbers, survey().kinds.size(), without);
    CHECK(numbers > 10000);
    CHECK(50 * without < numbers);
}

TEST_CASE("modes, what they contribute, and the sums over them are within their bounds of 50 digits",
          "[program][scenes][eq:15][eq:33]") {
    std::size_t all = 0, close = 0;
    for (const std::string kind : {"natural_frequency_ratio", "R", "zeta", "v", "u", "g", "V", "U", "G", "H_j", "exact", "paper",
                                   "approximate", "sticking"}) {
        INFO(kind);
        CHECK(survey().kinds.at("program: " + kind).size() > 60);
        CHECK(survey().beyond("program: " + kind, 1).empty());
        all += survey().kinds.at("program: " + kind).size();
        close += survey().beyond("program: " + kind, 1.0 / 1024).size();
    }
    CHECK(4 * close > all); // the bounds are of use
}

TEST_CASE("invariant points are within their bounds of those to 30 digits", "[program][eq:87]") {
    const Bits enough(bits);
    SurveyOfBounds held;
    for (std::size_t n = 0; n < surveyed_scenes().size(); n += 5) {
        const SurveyedScene& s = surveyed_scenes()[n];
        // (87) is for forces in phase, and for one load at all frequencies.
        if (!s.of_doubles || s.json.contains("load_phases") || s.json.value("base_motion", "") == "wall") continue;
        held.scene = s.text;
        const auto printed = [&](const std::string& digits) {
            return nlohmann::json::parse(run_program("boundary --json --invariant-points 0.8:2" + digits, s.text).output)
                .at("invariant_points");
        };
        const nlohmann::json few = printed(""), many = printed(" --digits 30");
        for (std::size_t k = 0; k < few.size(); ++k) {
            const nlohmann::json &a = few[k].at("points"), &b = many[k].at("points");
            if (many[k].contains("undecided")) continue;
            INFO(s.text);
            REQUIRE(a.size() == b.size());
            for (std::size_t i = 0; i < a.size(); ++i) {
                for (const auto& [key, bound] : {std::pair("r", "r_error_bound"), std::pair("amplitude", "error_bound")}) {
                    const Ball is = Ball::of_text(b[i][key].get<std::string>());
                    held.take(key, a[i][key], a[i][bound], widened(is, is * Ball(1e-29))); // what 30 digits are good to
                }
                CHECK(a[i]["kind"] == b[i]["kind"]);
            }
        }
    }
    for (const std::string kind : {"r", "amplitude"}) {
        const std::size_t numbers = held.kinds.at(kind).size();
        INFO(kind << ": " << numbers);
        CHECK(numbers > 200);
        CHECK(held.beyond(kind, 1).empty());
        CHECK(4 * held.beyond(kind, 0x1p-10).size() > numbers); // bounds a thousand times smaller would not hold
    }
}

TEST_CASE("hardly a number is refused", "[scenes]") {
    for (const std::string& refusal : survey().refusals) WARN(refusal);
    CHECK(survey().refusals.size() <= 6);
}

TEST_CASE("regimes, stops and symmetry are those proved", "[scenes]") {
    REQUIRE_FALSE(survey().kinds.empty());
    for (const std::string& difference : survey().differences) {
        INFO(difference);
        CHECK(difference.empty());
    }
}

TEST_CASE("every kind of number has a bound that some number uses: a millionth of it would be noticed", "[scenes]") {
    CHECK(survey().kinds.size() > 50);
    for (const auto& [kind, held] : survey().kinds) {
        if (has_a_promise_only(kind)) continue;
        double most_used = 0;
        for (const NumberHeld& n : held)
            if (n.bound > 0) most_used = std::max(most_used, n.off / n.bound);
        INFO(kind << " uses " << most_used << " of its bounds, in " << held.size() << " numbers");
        CHECK(most_used > 1e-3);
        CHECK_FALSE(survey().beyond(kind, 1e-6).empty());
    }
}
