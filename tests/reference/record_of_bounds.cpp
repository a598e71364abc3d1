// The bounds of the numbers, and the work that they take, are those of the record, tests/reference/bounds.tsv.
//
// The surveys, which compare numbers with the reference, show that the bounds hold. A bound has many parts, and a single one of
// them could be ten times too small and would still pass every comparison, but not that with the record. The record asks the
// same questions of every named scene and of seeded ones; those that take long it asks of fewer. Its line for a scene and a
// question has the operations that were spent, how many bounds there are, how many of them are zero or infinite, and the sum of
// the binary logarithms of the others; or the outcome, if there is no answer. Most parts of a bound are small in most scenes. So
// that none of them goes unseen, a change of the product of the bounds by a part in 1e6 is a difference, and so is one operation
// more. Some questions are about numbers inside the library, of which the answers show less: the bounds of samples, which decide
// only whether double answers; maxima before the step that ends their search; balls of 192 bits, as an answer doubles its bits.
// With DENHARTOG_WRITE_BOUNDS in the environment the record is written anew; the test then fails once.
#include <flint/flint.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/denhartog.hpp"
#include "denhartog/reference/orbit.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/answer_numbers.hpp"
#include "tests/support/adversarial_scenes.hpp"
#include "tests/support/kinds_of_scenes.hpp"
#include "tests/support/named_scenes.hpp"

namespace denhartog::tests {
namespace {

std::vector<NamedNumber> all_numbers_of(const Solution& s) {
    std::vector<NamedNumber> all = numbers_of(s);
    all.push_back({"largest relative error", 0, {0, s.relative_error, {}}});
    for (const SolvedMass& mass : s.masses) all.push_back({"displacements", 0, {0, error_of_displacements(mass), {}}});
    if (s.between) all.push_back({"between", 0, s.between->amplitude});
    if (s.slides_below) all.push_back({"slides below", 0, *s.slides_below});
    if (s.kept_mode) all.push_back({"kept mode", s.kept_mode->mode, s.kept_mode->contact_at_most});
    for (const OtherMotion& other : s.motions)
        for (NamedNumber& n : numbers_of(other)) all.push_back(std::move(n));
    return all;
}

// The bounds of samples of the closed form in double, and the digits, as a bound of so many, up to which it samples them.
std::vector<NamedNumber> bounds_of_samples(const SceneSource& source) {
    std::vector<NamedNumber> all;
    const auto is_in_double = [&](int digits) {
        const SampledClosedForm sampled = sampled_closed_form(source, 0.5, 5, digits, true);
        if (sampled.found.method.precision != "double") return false;
        all = {{"digits of samples", 0, {0, std::exp2(-digits), {}}}};
        for (const evaluation::ErrorOfSamples& each : sampled.errors)
            for (const double bound : {each.x, each.x_prime}) all.push_back({"sample", 0, {0, bound, {}}});
        return true;
    };
    for (int digits = 1; digits <= most_digits_in_double && is_in_double(digits);) ++digits;
    return all;
}

// The maxima of the masses from instants that are no more than near, so that what a step of Newton's method neglects counts.
std::vector<NamedNumber> unsettled_maxima(const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    const ModeSums<Bounded<double>> sums =
        bounded_sums(scene.system, *modes_with_errors(scene.system, source->effort), as_input(*scene.r), source->effort);
    const SteadyState<Bounded<double>> start = steady_state_without_maxima(sums, as_input(*scene.beta));
    const ModeSums<double> values = values_of(sums);
    FrictionMotions motions(values, source->effort);
    std::vector<Bounded<double>> near;
    for (const double instant : instants_of_maxima(motions, *scene.beta).instants) near.emplace_back(instant + 1e-3, 1e-5);
    std::vector<NamedNumber> all;
    for (const MassResponse<Bounded<double>>& mass : with_maxima(sums, start, near).masses)
        for (const Bounded<double>& number : {mass.amplitude, mass.phase}) all.push_back({"maximum", 0, {0, number.e, {}}});
    return all;
}

// What the contact alone is asked for: sizes of the terms in sums over arrays of r, and a bound of the demand.
std::vector<NamedNumber> contact_alone(const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    const auto basis = modes_with_errors(scene.system, source->effort);
    if (basis->coupled()) throw DomainError(Why::nothing_holds);
    const std::vector<double> r{*scene.r, 2 * *scene.r};
    ContactSums sums;
    contact_sums(*basis, scene.system.contact, load_row(scene.system), r, 1, sums);
    std::vector<NamedNumber> all;
    const auto add = [&all](double bound) { all.push_back({"contact", 0, {0, std::abs(bound), {}}}); };
    for (const auto* sizes : {&sums.size_of_V, &sums.size_of_Y, &sums.size_of_U, &sums.size_of_H, &sums.certainty})
        for (const double size : *sizes) add(size);
    const ContactModes modes = contact_modes(basis, scene.system.contact, load_row(scene.system));
    if (const auto motion = contact_solution(modes, as_input(*scene.r), as_input(*scene.beta))) {
        for (const Bounded<double>& number : {motion->amplitude, motion->phase}) add(number.e);
        add(motion->slides_below.x);
    }
    return all;
}

// The numbers of a point in balls of 192 bits.
std::vector<NamedNumber> radii_of_balls(const SceneSource& source) {
    using namespace reference;
    constexpr slong bits = 192;
    const Bits all_bits(bits);
    std::vector<NamedNumber> all;
    const auto add = [&all](const Ball& x) { all.push_back({"radius", 0, {0, x.radius(), {}}}); };
    const auto add_complex = [&add](const Complex<Ball>& x) { add(x.re), add(x.im); };
    const PointInBalls p = point_in_balls(source, false);
    if (p.stuck) {
        for (const Complex<Ball>& X : p.stuck->X) add_complex(X);
        add_complex(p.stuck->load);
        add(p.stuck->compliance);
        add(*p.sticking);
    }
    if (p.boundary)
        for (const Ball& limit : {p.boundary->exact, p.boundary->paper, p.boundary->approximate, p.boundary->S_exact}) add(limit);
    if (p.responses) {
        const ResponsesInBalls& r = *p.responses;
        for (std::size_t k = 0; k < r.V.size(); ++k) {
            add_complex(r.V[k]);
            for (const Ball& number : {r.U[k], r.G[k]}) add(number);
        }
        add(r.H);
        if (*p.scene.beta < p.boundary->exact) {
            const SteadyState<Ball> contact = contact_in_balls(r, *p.scene.beta);
            for (std::size_t k = 0; k < r.V.size(); ++k) {
                const MassResponse<Ball> m = mass_in_balls(r, contact, k, p.scene.is_the_contact(static_cast<slong>(k)));
                for (const Ball& number : {m.amplitude, m.phase, m.x0, m.v0, m.instant, m.amplitude_monoharmonic}) add(number);
            }
            return all;
        }
    }
    if (p.sticking && *p.scene.beta >= *p.sticking) return all;
    const std::function<std::vector<OrbitGuess>()> made = [&source] {
        std::optional<PeriodicOrbit> followed;
        return guesses_at(PreparedSystem{source}, source, followed);
    };
    const OrbitInBalls orbit = OrbitGuesses(made).first_proved(source->effort, [&](const OrbitGuess& guess) {
        return proved_orbit([&] { return damped_scene_in_balls(source); }, guess, bits);
    });
    for (const std::vector<Ball>& numbers : {orbit.x, orbit.x_prime, orbit.multipliers})
        for (const Ball& number : numbers) add(number);
    for (const PeakInBalls& mass : orbit.masses) {
        add(mass.size);
        if (mass.phase) add(*mass.phase);
    }
    for (const StopOf<Ball>& stop : orbit.stops)
        for (const Ball& number : {stop.start, stop.end, stop.x}) add(number);
    return all;
}

// The modes and what they do at the frequency ratio, in double or by the reference where double has fewer than 6 digits.
std::vector<NamedNumber> modes(const SceneSource& source) {
    std::vector<NamedNumber> all;
    const auto add = [&all](const Bounded<double>& number) { all.push_back({"mode", 0, {0, number.e, {}}}); };
    const auto basis = certain_modes(source, modes_in_double(source).basis);
    for (const Bounded<double>& number : sizes_in(*basis)) add(number);
    for (const auto& functions : certain_mode_functions(source, basis))
        for (const Bounded<double>& number : {functions.v.re, functions.v.im, functions.u, functions.g}) add(number);
    return all;
}

std::vector<NamedNumber> bounds_of_energies(const SceneSource& source) {
    const Energies e = energies(source, solve(source, Question{}));
    std::vector<NamedNumber> all;
    for (const Certified& number : {e.contact, e.dampers, e.friction, e.on_base}) all.push_back({"energy", 0, number});
    if (!e.equivalent) return all;
    for (const Certified& number : {e.equivalent->coefficient, e.equivalent->ratio, e.equivalent->textbook_energy})
        all.push_back({"equivalent", 0, number});
    for (const auto& number : {e.equivalent->textbook_amplitude, e.equivalent->textbook_amplitude_error})
        if (number) all.push_back({"textbook", 0, *number});
    return all;
}

std::vector<NamedNumber> bounds_of_invariant_points(const SceneSource& source) {
    std::vector<NamedNumber> all;
    for (const InvariantPointsOfMass<Certified>& mass : invariant_points(source, {"0.25", "4"}))
        for (const InvariantPoint<Certified>& point : mass.points) all.push_back({"invariant point", 0, point.r});
    return all;
}

// The motion after the load is taken away, for a period and some more, from the contact far beyond where friction holds it.
std::vector<NamedNumber> bounds_of_decay(const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    State start = at_rest(number_of_masses(scene.system));
    start.x[contact_row(scene.system).index % start.x.size()] = 16 * *scene.beta;
    const FreeDecay motion = free_decay(source, start, 8);
    std::vector<NamedNumber> all{{"rest", 0, motion.rest_from}, {"rest", 0, motion.rest_at}};
    for (const SolvedStop& stop : motion.stops)
        for (const Certified& number : {stop.start, stop.end, stop.x}) all.push_back({"stop", 0, number});
    for (const DecayTurn& turn : motion.turns)
        for (const Certified& number : {turn.tau, turn.x}) all.push_back({"turn", 0, number});
    for (const Certified& x : motion.masses) all.push_back({"mass", 0, x});
    return all;
}

using Numbers = std::function<std::vector<NamedNumber>(const SceneSource&)>;

struct RecordedQuestion {
    std::string name;
    Numbers numbers;
    unsigned every = 1; // of about how many scenes it is asked of one; more than 1 if it takes long
};

// Whether a question is asked of a scene. The name decides, so that a new scene leaves those of the others as they are.
bool is_asked(const RecordedQuestion& question, const std::string& scene) {
    unsigned sum = 0;
    for (const char c : scene) sum = 31 * sum + static_cast<unsigned char>(c);
    return sum % question.every == 0;
}

const std::vector<RecordedQuestion>& questions() {
    const auto solved = [](Asked asked, std::optional<int> digits = {}, bool all = false) {
        return [question = Question{asked, digits, all}](const SceneSource& s) { return all_numbers_of(solve(s, question)); };
    };
    static const std::vector<RecordedQuestion> all{
        {"regime", solved(Asked::regime)},
        {"motion", solved(Asked::motion)},
        {"12 digits", solved(Asked::motion, 12)},
        {"all motions", solved(Asked::motion, {}, true)},
        {"contact",
         [](const SceneSource& s) {
             return all_numbers_of(solve(s, {Asked::phase, {}, false, s->in_double().system.contact}));
         }},
        {"quantities",
         [](const SceneSource& s) {
             return numbers_of(quantities(s, std::vector{0.5, 2.0}, 6).numbers);
         }},
        {"samples", bounds_of_samples},
        {"maxima", unsettled_maxima},
        {"contact alone", contact_alone},
        {"balls", radii_of_balls},
        {"modes", modes},
        {"energies", bounds_of_energies, 2},
        {"invariant points", bounds_of_invariant_points, 8},
        {"decay", bounds_of_decay, 4}};
    return all;
}

// The record of a question: the outcome instead where there is no answer.
std::string bounds_in_words(const Numbers& question, const SceneSource& scene) {
    flint_cleanup(); // Arb keeps pi in the most bits that were ever asked: radii would tell what was asked before
    Effort effort(1'000'000);
    effort.chosen = true;
    try {
        long zero = 0, infinite = 0, others = 0;
        double sum = 0;
        for (const NamedNumber& n : question(with_effort(scene, &effort))) {
            const double bound = n.number.error;
            if (bound == 0) {
                ++zero;
            } else if (!std::isfinite(bound)) {
                ++infinite;
            } else {
                ++others;
                sum += std::log2(bound);
            }
        }
        char text[80];
        std::snprintf(text, sizeof text, "%ld\t%ld\t%ld\t%ld\t%.6f", effort.spent, others, zero, infinite, sum);
        return text;
    } catch (const InputError&) {
        return "0\t0\t0\t0\tno scene";
    } catch (const DomainError&) {
        return std::to_string(effort.spent) + "\t0\t0\t0\tno answer";
    } catch (const PrecisionError&) {
        return std::to_string(effort.spent) + "\t0\t0\t0\tno digits";
    }
}

// Whether two records have the same outcome and work, as many bounds of each kind, and nearly one product of the bounds.
bool are_alike(const std::string& a, const std::string& b) {
    if (a == b) return true;
    const auto is_outcome = [](const std::string& record) { return record.find("no ") != std::string::npos; };
    if (is_outcome(a) || is_outcome(b)) return false;
    const std::size_t sum_of_a = a.rfind('\t') + 1, sum_of_b = b.rfind('\t') + 1;
    return a.substr(0, sum_of_a) == b.substr(0, sum_of_b) &&
           std::abs(std::atof(a.c_str() + sum_of_a) - std::atof(b.c_str() + sum_of_b)) < 1.5e-6; // of the logarithm
}

// Whether a scene has a frequency and a friction ratio; free motions have none.
bool has_point(const SceneSource& scene) {
    try {
        return scene->in_double().r && scene->in_double().beta;
    } catch (const InputError&) {
        return false;
    }
}

std::vector<std::pair<std::string, SceneSource>> scenes() {
    std::vector<std::pair<std::string, SceneSource>> all;
    std::ifstream named(source_file("tests/named_scenes.jsonl"));
    for (std::string line; std::getline(named, line);) {
        const std::string name = nlohmann::json::parse(line).at("name");
        const SceneSource scene = named_source(name);
        if (has_point(scene)) all.emplace_back(name, scene);
    }
    const auto draw = [&all](const std::string& range, const AdversarialRange& from, int count) {
        AdversarialScenes drawn(2026, from);
        for (int n = 1; n <= count; ++n) {
            try {
                all.emplace_back(range + " " + std::to_string(n), scene_source(placed(drawn.next())));
            } catch (const std::runtime_error&) { // it breaks a rule of scenes, or has no boundary to stand at
            }
        }
    };
    draw("mild", mild, 60);
    draw("contrasts", contrasts, 16);
    draw("units", units, 20);
    // Friction from 1/64 to 63/64, so that some slide, some stop and some rest
    const auto sample = [&all](const std::string& kind, const std::vector<RandomScene<double>>& from, std::size_t every) {
        for (std::size_t n = 0; n < from.size(); n += every) {
            Scene<double> scene = from[n].scene;
            scene.beta = from[n].fraction_of_limit;
            all.emplace_back(kind + " " + from[n].name, scene_source(scene));
        }
    };
    sample("phased", random_phased_scenes(2026), 27);
    sample("on a base", random_base_scenes(2026), 27);
    sample("in a direction", random_direction_scenes(2026), 40);
    sample("coupled", random_coupled_scenes(2026), 27);
    return all;
}

} // namespace

TEST_CASE("the bounds that leave with an answer have the product that is in the record", "[reference][bounds]") {
    const std::string file = source_file("tests/reference/bounds.tsv");
    std::map<std::string, std::string> record;
    std::ifstream lines(file);
    std::string text, heading = "scene\tquestion\twork\tbounds\tzero\tinfinite\tsum of binary logarithms, or outcome";
    std::getline(lines, text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t end = line.find('\t', line.find('\t') + 1);
        record[line.substr(0, end)] = line.substr(end + 1);
    }
    std::string written = heading + "\n";
    std::size_t compared = 0;
    for (const auto& [name, scene] : scenes())
        for (const RecordedQuestion& question : questions()) {
            if (!is_asked(question, name)) continue;
            const std::string key = name + "\t" + question.name;
            const std::string now = bounds_in_words(question.numbers, scene);
            const std::string then = record[key]; // empty where the record has no such line
            written += key + "\t" + now + "\n";
            ++compared;
            INFO(key << ": " << now << ", in the record " << then);
            CHECK(are_alike(now, then));
        }
    CHECK(compared == record.size());
    if (std::getenv("DENHARTOG_WRITE_BOUNDS") != nullptr) std::ofstream(file) << written;
}

TEST_CASE("a part of one bound, one bound or operation more and an answer that is none are differences to the record",
          "[reference][bounds]") {
    CHECK(are_alike("70\t5\t3\t0\t-220.710000", "70\t5\t3\t0\t-220.710001"));
    CHECK_FALSE(are_alike("70\t5\t3\t0\t-220.710000", "70\t5\t3\t0\t-220.710003"));
    CHECK_FALSE(are_alike("70\t5\t3\t0\t-220.710000", "70\t6\t3\t0\t-220.710000"));
    CHECK_FALSE(are_alike("70\t5\t3\t0\t-220.710000", "71\t5\t3\t0\t-220.710000"));
    CHECK_FALSE(are_alike("70\t5\t3\t0\t-220.710000", "70\t0\t0\t0\tno digits"));
    CHECK_FALSE(are_alike("0\t0\t0\t0\tno scene", "0\t0\t0\t0\tno digits"));
    CHECK_FALSE(are_alike("0\t0\t0\t0\t0.000000", "0\t0\t0\t0\tno digits"));
    CHECK_FALSE(are_alike("0\t0\t0\t0\t0.000000", ""));
}

} // namespace denhartog::tests
