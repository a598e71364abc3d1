#include "denhartog/solve/solve_by_reference.hpp"

#include <algorithm>
#include <exception>

#include "denhartog/answer/reference.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/solve/orbit_guess.hpp"

namespace denhartog {
namespace {

constexpr std::size_t most_masses_unasked = 40; // of which the reference is asked where nobody asked for digits

// Double for the digits of every day; the reference for more, for a proof, and for what double leaves open. Where that does not
// tell either, what double has, or its error.
template <class ByReference, class Fast>
Solution in_turn(std::size_t N, std::optional<int> digits, bool proved, const ByReference& by_reference, const Fast& fast) {
    if (proved || digits > most_digits_in_double) return by_reference();
    AnswerInDouble found;
    std::exception_ptr failure;
    try {
        found = fast();
        if (found.is_settled()) return found.solution;
    } catch (const DomainError&) {
        failure = std::current_exception();
    } catch (const PrecisionError&) {
        failure = std::current_exception();
    }
    count_precision_step();
    if (has_reference() && (digits || N <= most_masses_unasked) && !QuestionEffort::exhausted()) {
        try {
            return by_reference();
        } catch (const PrecisionError& e) {
            found.solution.method.why += std::string("; ") + e.what();
        }
    }
    if (failure) std::rethrow_exception(failure);
    return found.solution;
}

void require_digits(std::optional<int> digits, const Solution& s) {
    if (digits && !s.digits_reached)
        throw PrecisionError("the " + in_words(aim_of(digits)) + " are not reached: only " +
                             std::to_string(digits_of(s.relative_error)) + " are certain (" + s.method.why + ")");
}

// Which motion is meant, where the friction ratio does not tell: with mu above 1, or at a pole, the one from rest, as double finds it.
std::optional<Solution> from_rest(const Scene<double>& scene, const Question& question, const InDouble& fast) {
    Question of_regime;
    of_regime.asked = Asked::amplitude;
    of_regime.mass = question.mass;
    if (scene.mu == 1) {
        try {
            Question of_limits;
            of_limits.asked = Asked::regime;
            if (fast(of_limits).solution.limits) return std::nullopt;
        } catch (const PrecisionError&) {
            return std::nullopt;
        }
    }
    return fast(of_regime).solution;
}

Solution answer_by_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question, const InDouble& fast) {
    if (question.all && question.proved)
        throw InputError("all", "must not be asked for with a proof: other motions are estimates", "true");
    const SceneSource source = source_at(p, at);
    const Scene<double>& scene = source->in_double();
    const std::optional<Solution> rest = from_rest(scene, question, fast);
    ReferenceQuestion asked{question.asked, question.digits.value_or(digits_by_default), question.mass};
    asked.briefly = !question.digits && !question.proved;
    if (rest) asked.met = rest->regime.regime;
    Solution s = solution_by_reference(source, asked, [&] { return guesses_at(p, source); });
    if (rest) {
        if (s.regime.regime == rest->regime.regime) s.regime = rest->regime;
        s.method.why = "the start from rest was followed without a proof; " + s.method.why;
    }
    const double mu = s.mu.value == 1 && s.mu.error > 0 ? 2 : scene.mu; // a text may be above 1 by less than double tells
    say_whether_unique(p.bounded ? *p.bounded : *modes_in_double(source).basis, mu, s);
    if (question.all) {
        Question others = question;
        others.digits.reset();
        s.motions = fast(others).solution.motions;
    }
    return s;
}

} // namespace

std::vector<OrbitGuess> guesses_at(const PreparedSystem& p, const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    const ModesInDouble modes = p.bounded ? ModesInDouble{p.bounded} : modes_in_double(source);
    const std::shared_ptr<const ContactSystem<double>> moving = p.moving ? p.moving : moving_in_double(source, modes);
    std::vector<OrbitGuess> all;
    ExactSolver<double> solver(*moving, {*scene.r, *scene.beta, scene.mu});
    OrbitSearch<double> how;
    how.with_stability = false;
    const PeriodicOrbit<double> orbit = periodic_orbit(solver, at_rest<double>(moving->basis.r_n.size()), how);
    if (orbit.status != OrbitStatus::periodic) return all;
    const auto add = [&](const OrbitGuess& guess) {
        if (guess.directions.empty()) return;
        const auto same = [&](const OrbitGuess& other) {
            return other.directions == guess.directions && other.mirrored == guess.mirrored && other.periods == guess.periods;
        };
        if (std::ranges::none_of(all, same)) all.push_back(guess);
    };
    for (const double shortest : {0.0, 1e-9, 1e-6}) add(guess_of(solver, orbit, shortest));
    for (const OrbitGuess& guess : std::vector<OrbitGuess>(all))
        for (const OrbitGuess& other : with_other_stops(guess)) add(other);
    return all;
}

Solution answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question, const InDouble& fast) {
    const auto by_reference = [&] { return answer_by_reference(p, at, question, fast); };
    Solution s = in_turn(number_of_masses(p.scene().system), question.digits, question.proved, by_reference,
                         [&] { return fast(question); });
    require_digits(question.digits, s);
    return s;
}

Solution sliding_answer(const SceneSource& source, const SlidingQuestion& question, bool proved) {
    const auto by_reference = [&] {
        ReferenceQuestion asked{question.asked, question.digits.value_or(digits_by_default), question.only};
        asked.closed_form_alone = true;
        asked.briefly = !question.digits && !proved;
        return solution_by_reference(source, asked, {});
    };
    (void)aim_of(question.digits);
    return in_turn(number_of_masses(source->in_double().system), question.digits, proved, by_reference, [&] {
        AnswerInDouble found{sliding_solution(source, question)};
        put_in_order_of_masses(source->in_double().system.coordinates, found.solution);
        return found;
    });
}

Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved) {
    Solution s = sliding_answer(source, SlidingQuestion{Asked::motion, digits}, proved);
    require_digits(digits, s);
    return s;
}

} // namespace denhartog
