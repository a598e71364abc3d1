// The steady motion, in any regime. `SearchFromStart::follow` follows the motion from its start and tries, ever more
// rarely, Newton's method from the state that it has reached. With mu = 1 and damping any orbit that was found is the answer, and
// `settle` bounds its errors. Otherwise `find_attractor` and `is_approached` decide whether the motion approaches it.
#include "denhartog/orbit/periodic_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "denhartog/number/why.hpp"

namespace denhartog {
namespace {

constexpr int half_periods_to_approach = 16; // in which a motion that is followed mostly comes near an orbit, or to rest
constexpr int half_periods_to_rest = 400;    // after which a rest whose place is known to 1e-3 is an answer
constexpr int half_periods_to_arrive = 4000; // at rest, or at an orbit that attracts nothing

// The states of a motion after its last half-periods, mirrored after each, and how nearly it repeats itself.
struct RecentStates {
    static constexpr int most_subharmonic = 8; // longest period looked for, in periods of the force
    std::vector<State> states;                 // the last comes last

    // Takes the next one.
    void take(const State& z) {
        if (states.size() > 2 * most_subharmonic) states.erase(states.begin());
        states.push_back(z);
    }
    // Distance of the last state from that h half-periods before; 0 if there is none.
    double recurrence(const OrbitMap& map, int h) const {
        const auto back = static_cast<std::size_t>(h) + 1;
        return back > states.size() ? 0.0 : map.norm(difference(states.back(), states[states.size() - back]));
    }
    // Numbers of half-periods after which the motion nearly repeats itself, each better than those before.
    std::vector<int> lengths(const OrbitMap& map) const {
        std::vector<int> found{1};
        double least = recurrence(map, 1);
        for (int h = 2; h < static_cast<int>(states.size()); ++h) {
            if (h % 2 != 0 && h > most_subharmonic) continue;
            const double now = recurrence(map, h);
            if (2 * now < least) {
                found.push_back(h);
                least = now;
            }
        }
        return found;
    }
};

// A state of a motion with which later ones are compared. The motion may repeat itself after more half-periods than are looked for.
struct MarkedState {
    State z{};
    int at = 0;     // half-periods before it
    int length = 0; // half-periods after which the motion came back to it; 0 if it did not yet

    // Takes the last state, after `done` half-periods; with time a later one is marked. True if the motion came back twice, after the
    // same time, to 1e-12 of its size, while it is 1e-6 from repeating itself sooner: it then comes to no orbit of fewer half-periods.
    bool take(const OrbitMap& map, const RecentStates& recent, int done) {
        const State& now = recent.states.back();
        const double size = map.norm(now);
        if (at > 0 && map.norm(difference(now, z)) <= 1e-12 * size) {
            if (length > 0 && done - at == 2 * length) return recent.recurrence(map, recent.lengths(map).back()) > 1e-6 * size;
            if (length == 0) length = done - at;
        }
        if (done - at >= std::max(64, at / 2)) *this = {now, done};
        return false;
    }
};

// A fixed point of h half-periods, with what is known of its neighbourhood, and a record of how a motion approaches it. A motion that
// only passes by comes nearer for some periods too.
struct OrbitCandidate {
    static constexpr int least = 16; // maps in which an approach is seen, and how much nearer the motion comes
    static constexpr int most = 512; // maps after which slow approach is enough

    State z{};                     // its state at tau = 0
    int h = 0;                     // half-periods; 0 if there is none
    Matrix<double> jacobian{};     // of the map over them
    double rounding = 0;           // norm of the map's rounding
    double error = 0;              // of the state, in the norm
    double reach = 0;              // nearer than this every motion is proved to tend to it; 0 if that is not known
    bool stable = false;           // whether it attracts its neighbours
    double largest_multiplier = 0; // over h half-periods
    int maps = -1;                 // that brought a motion nearer, one after the other; negative before its first state
    int half_periods = 0;
    bool moved = false; // since the last map
    bool has_arrived = false;
    Column apart{};
    double first = 0, distance = 0; // from the candidate

    // Takes the state w of a motion after one more half-period, over which the contact rested if it was held.
    void take(const OrbitMap& map, const State& w, bool held) {
        moved = moved || !held;
        if (maps >= 0 && ++half_periods % h != 0) return;
        Column now = difference(w, z);
        const double far = map.norm(now), gain = std::max(0.0, 1 - largest_multiplier) / 4;
        const bool as_told = maps >= 0 && moved && map.norm(Column(now - jacobian * apart)) <= gain * distance + 64 * rounding;
        maps = as_told ? maps + 1 : 0;
        if (maps == 0) {
            first = far;
            half_periods = 0;
        }
        apart = std::move(now);
        distance = far;
        moved = false;
        // The reach is proved but for the rounding of its proof.
        has_arrived = far <= 64 * rounding || far + error < reach * (1 - 1.0 / (1 << 20));
    }
    // Whether the motion was seen to come nearer for long enough.
    bool is_approached() const {
        return maps >= 0 && (has_arrived || (maps >= least && least * distance <= first) || (maps >= most && distance < first));
    }
};

// The search from one start.
class SearchFromStart {
public:
    SearchFromStart(ExactSolver& solver, const OrbitSearch& search)
        : search_(search), map_(solver), contact_(solver.system().stuck.contact), no_expansion_(solver.excitation().mu == 1),
          most_periods_(no_expansion_ ? search.most_periods : periods_to_follow(solver, search.most_periods)),
          damped_(every_motion_is_damped(solver.system().basis)) {}

    PeriodicOrbit from(const State& start) {
        const long before = map_.solver().effort().spent;
        follow(start);
        orbit_.periods_propagated = static_cast<int>((map_.half_periods_in_all() + 1) / 2);
        orbit_.newton_steps = map_.newton_steps();
        orbit_.effort_spent = map_.solver().effort().spent - before;
        return std::move(orbit_);
    }

private:
    void follow(State z) {
        const int most = 2 * most_periods_;
        recent_.take(z);
        if (search_.guess != nullptr && is_found_near(*search_.guess)) return;
        int done = 0, next = std::min(2, most);
        for (;;) {
            for (; done < next && !is_restless(); ++done) {
                if (!map_.apply(z, 1, false)) return give_up(done, true);
                const State before = std::exchange(z, map_.image());
                if (no_expansion_) { // a half-period changes less than the one before, but for rounding
                    const double before_it = std::exchange(change_, map_.norm(map_.difference()));
                    rises_ += before_it >= 0 && change_ > before_it * 1.001;
                }
                held_ = map_.held();
                if (held_ && rests_for_ever(before, done)) return;
                recent_.take(z);
                if (is_approached(z)) return;
                if (search_.converging_only && !no_expansion_ && search_.follow_start && marked_.take(map_, recent_, done + 1))
                    return give_up(done + 1, false);
            }
            if (no_expansion_ ? settle(z, done) : search_.follow_start ? find_attractor(z, done) : find_orbit(z)) return;
            if (done >= (neutral_ ? std::min(most, half_periods_to_arrive) : most) || is_restless()) return give_up(done, false);
            next = std::min(most, done + 2 * std::max(1, done / (no_expansion_ ? 2 : 4)));
        }
    }

    // Whether rounding keeps the motion from settling: Newton's method would have to end at it too.
    bool is_restless() { return no_expansion_ && damped_ && rises_ >= 16 && !only_rest_is_steady(); }

    // An orbit of one half-period near a state, if it does not matter whether the motion from the start tends to it.
    bool is_found_near(State z) {
        if (search_.follow_start && !(no_expansion_ && damped_)) return false;
        return map_.find_fixed_point(z, 1, BadSteps::none) && answer(orbit_of(map_, z, search_));
    }

    // No two motions move apart, so that an orbit that attracts its neighbours attracts all: any way to it will do.
    bool settle(const State& z, int done) {
        if (neutral_) {
            const bool arrived = candidate_.h > 0 && map_.norm(difference(z, candidate_.z)) <= 64 * candidate_.rounding;
            return arrived && answer_by_candidate();
        }
        if (done > 0 && only_rest_is_steady()) return tends_to_rest(z, done);
        if (best_step_ < 0 || (change_ >= 0 && change_ < best_step_)) best_ = z;
        if (held_ && steady_rest().exists())
            best_ = steady_rest().steady_state(contact_.of(z.x)); // ahead of the motion: what the others tend to
        const bool found = map_.find_fixed_point(best_, 1, BadSteps::all_and_go_on_from_image);
        best_step_ = map_.residual();
        if (!found) return false;
        if (damped_ || !search_.follow_start || are_inside(multipliers_next_to(map_)))
            return answer(orbit_of(map_, best_, search_));
        (void)take(best_, 1);
        neutral_ = true;
        return false;
    }

    // Whether the motion from the start, after one more half-period or where a candidate was found, comes to it: the answer.
    bool is_approached(const State& z) {
        if (no_expansion_ || !search_.follow_start || !candidate_.stable) return false;
        candidate_.take(map_, z, held_);
        if (!candidate_.is_approached()) return false;
        if (answer_by_candidate()) return true;
        candidate_.maps = -1;
        return false;
    }

    // Any orbit near the motion.
    bool find_orbit(const State& z) {
        for (const int h : recent_.lengths(map_)) {
            if (!find_candidate(z, h)) continue;
            if (answer(orbit_of(map_, candidate_.z, search_))) return true;
            judge_candidate();
        }
        return false;
    }

    // An orbit that attracts, which the motion from the start may come to. While one is known, another is looked for only where
    // the motion had time to come to that one and does not.
    bool find_attractor(const State& z, int done) {
        if (search_.guess != nullptr) {
            State w = *std::exchange(search_.guess, nullptr);
            if (map_.find_fixed_point(w, 1, BadSteps::none)) (void)take(w, 1);
        }
        const int next = candidate_.stable ? 2 * std::max(half_periods_to_approach, looked_for_at_) : half_periods_to_approach;
        if (done < next || candidate_.maps >= OrbitCandidate::least) return false;
        looked_for_at_ = done;
        const std::vector<int> nearly = recent_.lengths(map_);
        for (auto h = nearly.rbegin(); h != nearly.rend(); ++h) {
            if (!find_candidate(z, *h)) continue;
            if (is_approached(z)) return true; // the motion may be there already
            if (candidate_.stable) return false;
        }
        return false;
    }

    bool find_candidate(State z, int h) { return map_.find_fixed_point(z, h, BadSteps::some) && take(z, h); }

    // A fixed point that was just found, of no more half-periods than it needs. The map was applied to it last.
    bool take(State& z, int h) {
        bool applied = true;
        for (int part = 1; part < h; ++part) {
            if (h % part != 0) continue;
            applied = false;
            if (!map_.apply(z, part, false)) continue;
            const double apart = map_.norm(map_.difference());
            State w = z;
            if (apart * apart < double_epsilon * map_.norm(z) * map_.norm(z) && map_.find_fixed_point(w, part, BadSteps::some)) {
                z = w;
                h = part;
                applied = true;
            }
        }
        if (!applied && !map_.apply(z, h, true)) return false;
        const std::optional<ErrorsOfOrbit> errors = errors_of(map_);
        if (!errors || !(100 * errors->settled < map_.norm(z))) return false;
        const double error = errors->settled / map_.displacement_of_energy();
        candidate_ = {.z = z, .h = h, .jacobian = map_.jacobian(), .rounding = map_.rounding_in_energy().norm(), .error = error};
        if (search_.follow_start) judge_candidate();
        return true;
    }

    // Whether motions next to the candidate tend to it. The map was applied to it last.
    void judge_candidate() {
        const std::vector<Multiplier> multipliers = multipliers_next_to(map_);
        candidate_.largest_multiplier = multipliers.empty() ? 1 : size_of(multipliers.front().value);
        candidate_.stable = are_inside(multipliers) || (damped_ && map_.slides_throughout());
        const std::vector<Phase>& phases = map_.motion().phases;
        if (damped_ && candidate_.h == 1 && phases.size() == 2 && phases[0].direction * phases[1].direction < 0)
            candidate_.reach = map_.solver().sliding_reach(1);
    }

    // The contact rested over the half-period from z, the one after `done` of them, and will for ever.
    bool rests_for_ever(const State& z, int done) {
        using Verdict = LastingRest::Verdict;
        const Verdict verdict = steady_rest().verdict(z);
        return verdict != Verdict::open &&
               rest_at(contact_.of(z.x), done, 0.0, verdict == Verdict::lasts ? Why::stays_at_rest : Why::rests_on_boundary);
    }

    // With mu = 1 and every mode damped all steady velocities are the same: those of rest, where the contact can rest for ever.
    bool only_rest_is_steady() { return damped_ && !map_.slides_throughout() && steady_rest().reach() > 0; }

    // No two motions move apart, so that the motion stays as near to any steady rest as it is.
    bool tends_to_rest(const State& z, int done) {
        const double reach = steady_rest().reach();
        const double x_j = std::clamp(contact_.of(z.x), -reach, reach);
        const State rest = steady_rest().steady_state(x_j);
        const double apart = map_.displacement_of_energy() * map_.norm(difference(z, rest));
        double largest = 0;
        for (std::size_t k = 0; k < rest.x.size(); ++k) largest = std::max(largest, steady_rest().motion(k, x_j).amplitude);
        const bool near = apart <= largest / (done < half_periods_to_rest ? 1'000'000'000 : 1000);
        if (!near && done < 2 * search_.most_periods) return false;
        return rest_at(x_j, done, apart, Why::tends_to_rest);
    }

    // The answer that the contact rests at x_j, as it is seen after `done` half-periods, no mass more than `apart` from where it is
    // then.
    bool rest_at(double x_j, int done, double apart, Why reason) {
        if (!answer(rest_of(map_, steady_rest(), done % 2 != 0 ? -x_j : x_j, search_))) return false;
        orbit_.reason = reason;
        orbit_.error_bound += apart + done * map_.rounding().maxCoeff();
        return true;
    }

    bool answer(std::optional<PeriodicOrbit> found) {
        if (found) orbit_ = std::move(*found);
        return found.has_value();
    }

    bool answer_by_candidate() {
        return map_.apply(candidate_.z, candidate_.h, true) && answer(orbit_of(map_, candidate_.z, search_));
    }

    LastingRest& steady_rest() {
        if (!rest_) rest_.emplace(map_.solver().system(), map_.solver().excitation());
        return *rest_;
    }

    void give_up(int done, bool failed) {
        const Effort& effort = map_.solver().effort();
        const MotionStatus status = failed ? map_.motion().status : MotionStatus::complete;
        const double size = std::max(map_.norm(recent_.states.back()), 1e-300);
        const auto norm = [&](const State& z) { return map_.norm(z); };
        orbit_.more_digits_may_tell = is_restless() || status != MotionStatus::complete;
        orbit_.start = recent_.states.back();
        Reasons why;
        if (is_restless()) why += Why::restless;
        if (effort.exhausted())
            why += effort.ending() + Why::namely;
        else if (status == MotionStatus::open)
            why += Reasons(Why::too_fast) + Why::namely;
        why += status == MotionStatus::chattering ? Why::chattering : Why::not_periodic;
        if (done >= 2) why += {Why::within_periods, done / 2};
        const int h = recent_.states.size() > 1 ? recent_.lengths(map_).back() : 0;
        if (h > 0 && std::ranges::is_sorted(recent_.states, std::ranges::less_equal{}, norm))
            why += {Why::still_grows, size};
        else if (h > 0)
            why += {Why::comes_nearest, h, recent_.recurrence(map_, h) / size};
        if (candidate_.h > 0)
            why += {Why::another_orbit, candidate_.h, candidate_.stable, candidate_.largest_multiplier,
                    map_.norm(difference(recent_.states.back(), candidate_.z)) / size};
        orbit_.reason = why;
        if (search_.converging_only || candidate_.h == 0 || effort.exhausted() || !answer_by_candidate()) return;
        orbit_.status = OrbitStatus::not_from_start; // which is certain, though not known to be that of the start
        orbit_.reason = std::move(why);
    }

    OrbitSearch search_;
    OrbitMap map_;
    const Contact& contact_;
    bool no_expansion_;    // mu = 1: no two motions move apart
    int most_periods_;     // of propagation
    bool damped_;          // every motion
    bool held_ = false;    // over the last half-period
    bool neutral_ = false; // an orbit was found that nothing tends to
    PeriodicOrbit orbit_;
    std::optional<LastingRest> rest_;
    RecentStates recent_;
    MarkedState marked_;
    double change_ = -1; // of the last half-period; negative before the first
    int rises_ = 0;      // half-periods that changed more than the one before
    State best_;         // nearest to a fixed point so far, if there is one only
    double best_step_ = -1;
    OrbitCandidate candidate_;
    int looked_for_at_ = 0; // half-periods before Newton's method looked for an orbit last
};

} // namespace

int periods_to_follow(const ExactSolver& solver, int most) {
    const ModalBasis<double>& basis = solver.system().basis;
    if (basis.coupled()) return most; // a motion may decay more slowly than the diagonal of the damping tells
    double slowest = std::numeric_limits<double>::infinity(); // decay rate, a period of the force
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const double zeta = basis.zeta[i];
        const double rate = zeta < 1 ? zeta : 1 / (zeta + sqrt((zeta - 1) * (zeta + 1)));
        slowest = std::min(slowest, 2 * pi<double>() * rate * basis.r_n[i] / solver.excitation().r);
    }
    if (!(slowest > 0)) return most; // 30 over a damping ratio of -0 is no number of periods
    const double periods = 500 + 30 / slowest;
    return periods < most ? static_cast<int>(periods) : most;
}

PeriodicOrbit periodic_orbit(ExactSolver& solver, const State& start, const OrbitSearch& search) {
    const auto is_finite = [](double each) { return std::isfinite(each); };
    if (!std::ranges::all_of(start.x, is_finite) || !std::ranges::all_of(start.x_prime, is_finite))
        throw InputError("start", "must be finite", "");
    SearchEffort own(default_effort(solver.system().basis.r_n.size()), search.effort);
    Effort* const before = solver.allow(&own);
    PeriodicOrbit orbit = SearchFromStart(solver, search).from(start);
    (void)solver.allow(before);
    return orbit;
}

} // namespace denhartog
