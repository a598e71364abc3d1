#include "tests/speed_accuracy/adversarial_survey.hpp"

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <ctime>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <typeinfo>

#include "denhartog/denhartog.hpp"
#include "tests/speed_accuracy/answer_numbers.hpp"
#include "tests/support/invariant_points.hpp"

namespace denhartog::tests {
namespace {

struct Found {
    Found(Faults faults_) : faults(std::move(faults_)) {} // a question that compares nothing
    Faults faults;
    std::vector<Contradiction> compared{};
};

struct NamedQuestion {
    std::string name;
    std::function<Found(const Scene<double>&, Effort*)> ask; // spends of a budget, or of one of its own
    std::size_t one_scene_in = 1;                            // asked of every n-th scene
};

void need_finite(const std::vector<double>& numbers, const char* what, Faults& faults) {
    for (const double x : numbers)
        if (!std::isfinite(x)) faults.push_back(std::string(what) + " is not finite");
}

Faults faults_of_motion(const Scene<double>& scene, Effort* effort) {
    const SceneSource source = with_effort(scene_source(scene), effort);
    const Solution solution = solve(source, {});
    return faults_of_samples(solution, sampled_solution(source, solution, 16).states());
}

Faults faults_of_map(const Scene<double>& scene, const Effort* effort) {
    Faults faults;
    MapRequest request{{*scene.r / 2, *scene.r, *scene.r * 2}, {*scene.beta / 2, *scene.beta, *scene.beta * 2}, {}};
    std::erase_if(request.r, [](double r) { return !(r > 0) || !std::isfinite(r); });
    std::erase_if(request.beta, [](double beta) { return !std::isfinite(beta); });
    for (std::size_t k = 0; k < number_of_masses(scene.system); ++k) request.masses.push_back(Mass{k});
    if (effort != nullptr) request.effort = effort->allowed; // of each point
    const std::atomic<bool> stop{false};
    const RegimeMap map = regime_map(scene, request, stop);
    const std::size_t N = number_of_masses(scene.system);
    for (std::size_t n = 0; n < map.amplitudes.size(); ++n) {
        const PointStatus status = map.points[n / N].status;
        if (has_numbers(status) && !(map.amplitudes[n] >= 0 && std::isfinite(map.amplitudes[n])))
            faults.emplace_back("an amplitude of a map is negative or not finite");
    }
    return faults;
}

Faults faults_of_curves(const Scene<double>& scene, const Effort*) {
    Faults faults;
    for (const BoundaryPoint& at : boundary_curves(scene, {*scene.r})) {
        if (!has_numbers(at.status)) continue;
        for (const double x : {at.exact, at.paper, at.approximate, at.sticking.value_or(0)})
            if (!(x >= 0 && std::isfinite(x))) faults.emplace_back("a boundary of a curve is negative or not finite");
    }
    return faults;
}

Faults faults_of_invariant_points(const Scene<double>& scene, Effort* effort) {
    Faults faults;
    check(scene);
    for (const InvariantPointsOfMass<double>& of : invariant_points_of(scene.system, 0.1, 10.0, effort)) {
        for (const InvariantPoint<double>& point : of.points)
            if (!(point.r >= 0.1 && point.r <= 10) || !(point.amplitude >= 0) || !std::isfinite(point.amplitude))
                faults.emplace_back("an invariant point is outside its range, or its amplitude is not finite");
        for (const UndecidedStretch<double>& part : of.undecided)
            if (!(part.from >= 0.1 && part.to <= 10 && part.from <= part.to)) faults.emplace_back("an undecided stretch is none");
    }
    return faults;
}

// Numbers of answers with few digits beside those of an answer with many.
class AnswerComparer {
public:
    void reference(std::vector<NamedNumber> numbers) { many_ = std::move(numbers); }

    // Compares what a question answers; one that is refused contradicts nothing.
    void compare(const std::string& question, const std::function<std::vector<NamedNumber>()>& ask) {
        try {
            for (const ComparedNumber& c : compared(ask(), many_)) {
                // JSON has neither infinity nor what is no number.
                const auto finite = [](double x) { return std::isnan(x) ? 1e300 : std::min(x, 1e300); };
                const double ratio = c.difference == 0 ? 0 : c.difference / c.allowed;
                found.compared.push_back({c.name, question, finite(ratio), finite(c.difference)});
            }
        } catch (const InputError&) {
        } catch (const DomainError&) {
        } catch (const PrecisionError&) {
        }
    }

    // Compares what no number tells.
    void same(const std::string& what, const std::string& question, bool is_same) {
        found.compared.push_back({what, question, is_same ? 0 : 1e300, is_same ? 0.0 : 1.0});
    }

    Found found{Faults{}};

private:
    std::vector<NamedNumber> many_;
};

Found compared_solutions(const Scene<double>& scene) {
    AnswerComparer comparer;
    const Solution many = solve(scene, {Asked::motion, 30});
    comparer.reference(numbers_of(many));
    const auto ask = [&](const std::string& name, const Question& question) {
        comparer.compare(name, [&] {
            const Solution few = solve(scene, question);
            const bool sure = few.digits_reached && !few.regime.on_boundary && !many.regime.on_boundary;
            if (sure) comparer.same("regime", name, few.regime.regime == many.regime.regime);
            for (const std::string& each : contradictions_within(few)) comparer.found.faults.push_back(name + ": " + each);
            const bool whole = sure && question.asked == Asked::motion;
            if (whole) comparer.same("number of stops", name, few.stops.size() == many.stops.size());
            if (whole && few.stops.size() != many.stops.size()) return std::vector<NamedNumber>{};
            return numbers_of(few);
        });
    };
    for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(10), std::optional<int>(12)}) {
        const std::string words = digits ? ", " + std::to_string(*digits) + " digits" : "";
        ask("solve motion" + words, {Asked::motion, digits});
        ask("solve amplitude" + words, {Asked::amplitude, digits});
        ask("solve phase" + words, {Asked::phase, digits});
        ask("solve regime" + words, {Asked::regime, digits});
        Question one{Asked::phase, digits};
        one.mass = scene.system.contact;
        ask("solve the contact's phase" + words, one);
        one.asked = Asked::amplitude;
        one.mass = scene.system.load;
        ask("solve the loaded mass's amplitude" + words, one);
    }
    return comparer.found;
}

Found compared_boundaries(const Scene<double>& scene) {
    AnswerComparer comparer;
    comparer.reference(numbers_of(sliding_answer(scene_source(scene), Question{Asked::motion, 30})));
    for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(10), std::optional<int>(14)}) {
        const std::string words = digits ? ", " + std::to_string(*digits) + " digits" : "";
        comparer.compare("boundary" + words, [&] { return numbers_of(boundary(scene, digits)); });
        comparer.compare("sliding_solution" + words, [&] {
            return numbers_of(sliding_answer(scene_source(scene), Question{Asked::motion, digits}));
        });
    }
    return comparer.found;
}

Found compared_quantities(const Scene<double>& scene) {
    AnswerComparer comparer;
    const std::array<double, 3> tau{0, 1, 4};
    const auto ask = [&](int digits, PointNumbers asked) {
        return numbers_of(quantities(scene_source(scene), tau, digits, asked).numbers);
    };
    comparer.reference(ask(15, PointNumbers::sums));
    comparer.compare("functions, 6 digits", [&] { return ask(6, PointNumbers::sums); });
    comparer.compare("functions, 11 digits", [&] { return ask(11, PointNumbers::sums); });
    comparer.reference(ask(15, PointNumbers::all));
    comparer.compare("quantities, 6 digits", [&] { return ask(6, PointNumbers::all); });
    comparer.compare("motion, 10 digits", [&] { return ask(10, PointNumbers::motion); });
    return comparer.found;
}

// Numbers that are handed out without their bounds, to 6 digits: of a map and of the curves of the boundary. A mass that does not
// move by double, to 1024 roundings of the largest amplitude as `solve` has it, is none; a boundary that 50 digits do not tell
// from zero is zero.
Found compared_map(const Scene<double>& scene) {
    AnswerComparer comparer;
    const auto in_double = [](double x) { return Certified{x, x == 0 ? 0x1p-140 : 1e-6 * std::abs(x), {}}; };
    const auto amplitude = [&](const RegimeMap& map, std::size_t k) {
        const double largest = *std::ranges::max_element(map.amplitudes);
        return Certified{map.amplitudes[k], 1e-6 * map.amplitudes[k] + 0x1p-42 * (map.amplitudes[k] == 0 ? largest : 0), {}};
    };
    const Solution many = solve(scene, {Asked::motion, 15});
    comparer.reference(numbers_of(many));
    comparer.compare("map", [&] {
        MapRequest request{{*scene.r}, {*scene.beta}, {}};
        for (std::size_t k = 0; k < number_of_masses(scene.system); ++k) request.masses.push_back(Mass{k});
        const std::atomic<bool> stop{false};
        const RegimeMap map = regime_map(scene, request, stop);
        std::vector<NamedNumber> numbers;
        if (map.points[0].status == PointStatus::answered) {
            comparer.same("regime of a map", "map", map.points[0].regime == many.regime.regime);
            for (std::size_t k = 0; k < map.amplitudes.size(); ++k) numbers.push_back({"amplitude", k + 1, amplitude(map, k)});
        }
        return numbers;
    });
    comparer.compare("boundary curves", [&] {
        const BoundaryPoint at = boundary_curves(scene, {*scene.r}).front();
        if (at.status != PointStatus::answered) return std::vector<NamedNumber>{};
        return numbers_of(Limits{in_double(at.exact), in_double(at.paper), in_double(at.approximate), {}, {}});
    });
    for (Contradiction& each : comparer.found.compared) each.quantity = each.between + ": " + each.quantity;
    return comparer.found;
}

std::vector<NamedQuestion> comparing_questions() {
    const auto with_own_effort = [](Found (*compare)(const Scene<double>&)) {
        return [compare](const Scene<double>& scene, Effort*) { return compare(scene); };
    };
    return {{"compare solutions", with_own_effort(compared_solutions)},
            {"compare boundaries", with_own_effort(compared_boundaries)},
            {"compare quantities", with_own_effort(compared_quantities)},
            {"compare map", with_own_effort(compared_map)}};
}

std::vector<NamedQuestion> all_questions(const AdversarialRun& run) {
    std::vector<NamedQuestion> all;
    if (run.contradictions)
        for (NamedQuestion& each : comparing_questions()) all.push_back(std::move(each));
    if (!run.questions) return all;
    const auto solve_for = [&all](const std::string& name, Asked asked, std::optional<int> digits, bool contact) {
        all.push_back({name, [=](const Scene<double>& scene, Effort* effort) {
                           Question question{asked, digits};
                           if (contact) question.mass = scene.system.contact;
                           return faults_of(solve(with_effort(scene_source(scene), effort), question));
                       }});
    };
    const std::array<std::pair<const char*, std::optional<int>>, 3> digits{{{"", {}}, {", 12 digits", 12}, {", 30 digits", 30}}};
    for (const auto& each : digits) {
        const char* const words = each.first;
        const std::optional<int> wanted = each.second;
        solve_for(std::string("solve motion") + words, Asked::motion, wanted, false);
        solve_for(std::string("solve amplitude") + words, Asked::amplitude, wanted, false);
        solve_for(std::string("solve phase") + words, Asked::phase, wanted, false);
        solve_for(std::string("solve regime") + words, Asked::regime, wanted, false);
        solve_for(std::string("solve the contact's phase") + words, Asked::phase, wanted, true);
        all.push_back({std::string("boundary") + words, [wanted](const Scene<double>& scene, Effort* effort) {
                           const SceneSource source = without_friction_ratio(with_effort(scene_source(scene), effort));
                           return faults_of(numbers_of(*sliding_answer(source, wanted, false).limits));
                       }});
        all.push_back({std::string("sliding_solution") + words, [wanted](const Scene<double>& scene, Effort* effort) {
                           const SceneSource source = with_effort(scene_source(scene), effort);
                           return faults_of(sliding_answer(source, Question{Asked::motion, wanted}));
                       }});
    }
    for (const int wanted : {6, 12, 15})
        all.push_back({"quantities, " + std::to_string(wanted) + " digits", [wanted](const Scene<double>& scene, Effort* effort) {
                           const std::array<double, 4> tau{0, 1, pi<double>(), 1000};
                           const SceneSource source = with_effort(scene_source(scene), effort);
                           return faults_of(numbers_of(quantities(source, tau, wanted).numbers));
                       }});
    all.push_back({"functions", [](const Scene<double>& scene, Effort* effort) {
                       const SceneSource source = with_effort(scene_source(scene), effort);
                       return faults_of(numbers_of(quantities(source, {}, 6, PointNumbers::sums).numbers));
                   }});
    all.push_back({"motion", faults_of_motion});
    all.push_back({"map", faults_of_map});
    all.push_back({"boundary curves", faults_of_curves});
    all.push_back({"invariant points", faults_of_invariant_points});
    all.push_back({"the program's text of the scene", [](const Scene<double>& scene, Effort*) {
                       const Scene<double> again = denhartog::scene(json_of(scene));
                       return again.r == scene.r && again.beta == scene.beta ? Faults{} : Faults{"another scene is read"};
                   }});
    if (run.all_motions)
        all.push_back({"solve, all motions",
                       [](const Scene<double>& scene, Effort* effort) {
                           return faults_of(solve(with_effort(scene_source(scene), effort), {Asked::motion, {}, true}));
                       },
                       8});
    return all;
}

// The scene as the program reads it, or why there is no such text.
std::string text_or_reason(const Scene<double>& scene) {
    try {
        return json_of(scene);
    } catch (const InputError& e) {
        return e.what();
    }
}

// One question, whatever comes of it.
AskedQuestion asked(const NamedQuestion& question, const Scene<double>& scene, std::optional<long> effort) {
    AskedQuestion result;
    result.question = question.name;
    std::optional<QuestionEffort> allowed;
    if (effort) allowed.emplace(number_of_masses(scene.system), effort);
    const Work before{eigen_solves(), mode_evaluations(), phases_propagated()};
    const std::clock_t start = std::clock();
    const auto refused = [&](const char* type, const std::exception& e) {
        result.outcome = type;
        result.text = e.what();
    };
    try {
        Found found = question.ask(scene, allowed ? &*allowed : nullptr);
        result.faults = std::move(found.faults);
        result.compared = std::move(found.compared);
        result.outcome = "answered";
    } catch (const InputError& e) {
        refused("InputError", e);
    } catch (const DomainError& e) {
        refused("DomainError", e);
    } catch (const PrecisionError& e) {
        refused("PrecisionError", e);
    } catch (const std::exception& e) {
        refused(typeid(e).name(), e);
        result.faults = {std::string("an exception of another kind: ") + typeid(e).name()};
    }
    result.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (allowed) result.spent = allowed->spent;
    result.eigen_solves = eigen_solves() - before.eigen_solves;
    result.mode_evaluations = mode_evaluations() - before.mode_evaluations;
    result.phases = phases_propagated() - before.phases_propagated;
    return result;
}

// Where a run is: in memory that parent and child share.
struct RunPlace {
    std::size_t scene;
    std::size_t question; // 0: the scene is being placed; question n is the n-th from 1
};

nlohmann::json to_json(const AskedQuestion& a) {
    nlohmann::json all = nlohmann::json::array();
    for (const Contradiction& c : a.compared) all.push_back({c.quantity, c.between, c.ratio, c.difference});
    return {all,      a.scene,   a.question, a.seconds, a.spent, a.eigen_solves, a.mode_evaluations,
            a.phases, a.outcome, a.text,     a.faults,  a.json};
}

AskedQuestion from_json(const nlohmann::json& j) {
    AskedQuestion a{j[1], j[2], j[3], j[4], j[5], j[6], j[7], j[8], j[9], j[10], {}, j[11]};
    for (const nlohmann::json& c : j[0]) a.compared.push_back({c[0], c[1], c[2], c[3]});
    return a;
}

// Asks from a place on; says where it is before each question and what came of it after.
void ask_from(RunPlace& place, const AdversarialRun& run, const std::function<void(AskedQuestion&&)>& tell,
              const std::function<void()>& begin_question) {
    const std::vector<NamedQuestion> questions = all_questions(run);
    AdversarialScenes random(run.seed, run.range);
    for (std::size_t n = 0; n < run.scenes; ++n) {
        const AdversarialScene drawn = random.next();
        if (n < place.scene) continue;
        const std::size_t first = n == place.scene ? place.question : 0;
        Scene<double> scene = drawn.scene;
        const auto one = [&](const NamedQuestion& question, std::size_t number) {
            place.scene = n;
            place.question = number;
            begin_question();
            AskedQuestion result = asked(question, scene, run.effort);
            result.scene = n;
            result.json = text_or_reason(scene);
            tell(std::move(result));
        };
        const auto place_it = [&](const Scene<double>&, Effort*) {
            const Scene<double> at = placed(drawn);
            check(at);
            scene = at;
            return Faults{};
        };
        one({"placing", place_it}, 0);
        if (!scene.beta) scene.beta = 0.25; // where the boundary is out of reach the scene stays as it was drawn
        for (std::size_t q = std::max<std::size_t>(first, 1); q <= questions.size(); ++q)
            if (n % questions[q - 1].one_scene_in == 0) one(questions[q - 1], q);
    }
}

std::string without_numbers(const std::string& text) {
    static const std::regex number(R"(-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?)");
    return std::regex_replace(text, number, "#");
}

constexpr std::size_t most_listed = 50;

Table dear_table(const AdversarialSurvey& survey) {
    Table table{"The most expensive questions",
                {"seconds", "question", "operations", "eigen-solves", "modes", "phases", "outcome", "scene"},
                {},
                ""};
    for (const AskedQuestion& a : survey.dearest)
        table.rows.push_back({digits(a.seconds), a.question, std::to_string(a.spent), std::to_string(a.eigen_solves),
                              std::to_string(a.mode_evaluations), std::to_string(a.phases), a.outcome, a.json});
    return table;
}

// Runs one child from a place; returns how it ended.
int run_child(RunPlace* place, const AdversarialRun& run, AdversarialSurvey& survey) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        close(ends[0]);
        FILE* out = fdopen(ends[1], "w");
        const auto begin = [&run] {
            const auto whole = static_cast<time_t>(run.seconds_a_question);
            const itimerval limit{{0, 0},
                                  {whole, static_cast<suseconds_t>((run.seconds_a_question - static_cast<double>(whole)) * 1e6)}};
            setitimer(ITIMER_PROF, &limit, nullptr);
        };
        ask_from(
            *place, run,
            [&](AskedQuestion&& a) {
                std::fprintf(out, "%s\n", to_json(a).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
                std::fflush(out);
            },
            begin);
        std::fclose(out);
        _exit(0);
    }
    close(ends[1]);
    FILE* in = fdopen(ends[0], "r");
    char* line = nullptr;
    std::size_t room = 0;
    while (getline(&line, &room, in) > 0) survey.add(from_json(nlohmann::json::parse(line)));
    std::free(line);
    std::fclose(in);
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

} // namespace

Faults faults_of_samples(const Solution& solution, const std::vector<State>& states) {
    Faults faults;
    const std::size_t instants = states.size();
    for (std::size_t n = 0; n < instants; ++n) {
        need_finite(states[n].x, "a displacement", faults);
        need_finite(states[n].x_prime, "a velocity", faults);
        if (states[n].x.size() != solution.masses.size()) faults.emplace_back("a sample lacks masses");
        for (std::size_t k = 0; k < states[n].x.size(); ++k) {
            const Certified& amplitude = solution.masses[k].amplitude;
            const double allowed = amplitude.error + 1e-6 * amplitude.value;
            if (std::abs(states[n].x[k]) > amplitude.value + allowed) faults.emplace_back("a sample is beyond its amplitude");
            const std::vector<double>& mirrored = states[(n + instants / 2) % instants].x;
            if (solution.symmetric && k < mirrored.size() && std::abs(states[n].x[k] + mirrored[k]) > allowed)
                faults.emplace_back("samples of a symmetric motion do not mirror themselves");
        }
    }
    return faults;
}

void AdversarialSurvey::add(AskedQuestion a) {
    scenes = std::max(scenes, a.scene + 1);
    ++questions;
    seconds += a.seconds;
    ++outcomes[a.question][a.outcome];
    const auto note = [&a](std::map<std::string, std::pair<long, AskedQuestion>>& all, const std::string& key) {
        auto [at, fresh] = all.try_emplace(key, 0, a);
        ++at->second.first;
        if (!fresh && a.json.size() < at->second.second.json.size()) at->second.second = a; // the shortest scene
    };
    if (!a.text.empty()) note(refusals, a.outcome + ": " + without_numbers(a.text));
    std::vector<std::string> kinds = a.faults;
    std::ranges::sort(kinds);
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    for (const std::string& fault : kinds) note(faults, a.question + ": " + fault);
    for (const Contradiction& c : a.compared) {
        ContradictedQuantity& of = quantities[c.ratio > 1 ? c.quantity + " | " + c.between : c.quantity];
        ++of.count;
        if (c.ratio > of.worst.ratio) {
            of.worst = c;
            of.json = a.json;
        }
        if (!(c.ratio > 1)) continue;
        ++of.violations;
        if (of.shortest.empty() || a.json.size() < of.shortest.size()) of.shortest = a.json;
    }
    a.compared.clear();
    if (std::pair<long, std::string>& most = most_phases[a.question]; a.phases > most.first) most = {a.phases, a.json};
    if (a.spent > 0)
        if (std::pair<long, std::string>& most = most_spent[a.question]; a.spent > most.first) most = {a.spent, a.json};
    most_eigen_solves = std::max(most_eigen_solves, a.eigen_solves);
    most_mode_evaluations = std::max(most_mode_evaluations, a.mode_evaluations);
    if (dearest.size() == most_listed && a.seconds <= dearest.back().seconds) return;
    dearest.push_back(std::move(a));
    std::ranges::sort(dearest, std::greater<>{}, &AskedQuestion::seconds);
    if (dearest.size() > most_listed) dearest.pop_back();
}

AdversarialSurvey survey_in_process(const AdversarialRun& run) {
    AdversarialSurvey survey;
    RunPlace place{0, 0};
    ask_from(
        place, run, [&survey](AskedQuestion&& a) { survey.add(std::move(a)); }, [] {});
    return survey;
}

AdversarialSurvey survey_in_children(const AdversarialRun& run) {
    AdversarialSurvey survey;
    void* shared = mmap(nullptr, sizeof(RunPlace), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("no memory to share");
    auto* place = new (shared) RunPlace{0, 0};
    for (int status = run_child(place, run, survey); status != 0; status = run_child(place, run, survey)) {
        AskedQuestion ended;
        ended.scene = place->scene;
        const bool placing = place->question == 0;
        ended.question = placing ? "placing" : all_questions(run)[place->question - 1].name;
        ended.seconds = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF ? run.seconds_a_question : 0;
        ended.outcome = WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "ended";
        ended.faults = {ended.seconds > 0 ? "no end" : "the process ended: " + ended.outcome};
        AdversarialScenes random(run.seed, run.range);
        AdversarialScene drawn;
        for (std::size_t n = 0; n <= place->scene; ++n) drawn = random.next();
        ended.json = text_or_reason(drawn.scene) +
                     (drawn.mode ? " r times frequency of mode " + std::to_string(*drawn.mode + 1) : "") +
                     (drawn.of_limit ? " beta/beta_lim " + digits(*drawn.of_limit, "%.17g") : "");
        survey.add(std::move(ended));
        if (placing)
            *place = {place->scene + 1, 0};
        else
            ++place->question;
    }
    munmap(shared, sizeof(RunPlace));
    return survey;
}

long contradictions_of(const AdversarialSurvey& survey) {
    long all = 0;
    for (const auto& [name, of] : survey.quantities) all += of.violations;
    return all;
}

std::vector<Table> tables_of(const AdversarialSurvey& survey) {
    Table outcomes{"What came of " + std::to_string(survey.questions) + " questions to " + std::to_string(survey.scenes) +
                       " scenes, " + digits(survey.seconds) + " s of processor time",
                   {"question", "outcome", "times"},
                   {},
                   ""};
    for (const auto& [question, by_outcome] : survey.outcomes)
        for (const auto& [outcome, times] : by_outcome) outcomes.rows.push_back({question, outcome, std::to_string(times)});
    const auto listed = [](const std::string& title, const std::map<std::string, std::pair<long, AskedQuestion>>& all) {
        Table table{title, {"times", "what", "question", "text", "scene"}, {}, ""};
        for (const auto& [key, of] : all)
            table.rows.push_back({std::to_string(of.first), key, of.second.question, of.second.text, of.second.json});
        return table;
    };
    outcomes.note = "Of one question at most " + std::to_string(survey.most_eigen_solves) + " eigen-solves and " +
                    std::to_string(survey.most_mode_evaluations) + " evaluations of modes.";
    for (const auto& [question, most] : survey.most_phases)
        outcomes.note += " " + question + ": at most " + std::to_string(most.first) + " phases.";
    Table compared{"Numbers of two answers to the same question",
                   {"number", "compared", "violations", "worst ratio", "difference", "scene", "shortest with a violation"},
                   {},
                   ""};
    for (const auto& [name, of] : survey.quantities)
        compared.rows.push_back({name, std::to_string(of.count), std::to_string(of.violations), digits(of.worst.ratio),
                                 digits(of.worst.difference), of.json, of.shortest});
    Table spent{"The most operations that a question spent", {"question", "operations", "scene"}, {}, ""};
    for (const auto& [question, most] : survey.most_spent)
        spent.rows.push_back({question, std::to_string(most.first), most.second});
    return {compared, outcomes, listed("Refusals", survey.refusals), listed("Faults", survey.faults), spent, dear_table(survey)};
}

} // namespace denhartog::tests
