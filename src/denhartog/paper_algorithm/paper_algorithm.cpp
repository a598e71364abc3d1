// The paper's numerical approach, Section 3.1 and Fig. 3: Runge-Kutta steps of one phase up to its event, where the contact stops
// or (74) lets it go, period after period. Read `Integration` from `run` on; `paper_algorithm` checks the settings.
#include "denhartog/paper_algorithm/paper_algorithm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "denhartog/formulas/stuck.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/paper_algorithm/last_period.hpp"
#include "denhartog/scene/limits.hpp"

namespace denhartog {
namespace {

constexpr int most_cycles = 1'000'000;
constexpr int most_phases_of_no_length = 16; // one after the other
constexpr int most_restarts = 12;            // of a phase with a shorter first step

bool finite(const std::vector<double>& y) {
    double sum = 0;
    for (const double x : y) sum += std::abs(x);
    return std::isfinite(sum);
}

/// One integration: the phases one after the other.
class Integration {
public:
    Integration(const ContactProblem& problem, const PaperSettings& settings)
        : s_(settings), equations_(problem), N_(equations_.N), contact_(equations_.contact),
          step_(N_, s_.absolute_tolerance, s_.relative_tolerance.value_or(s_.absolute_tolerance), longest_step), tau_(s_.tau_0),
          end_(s_.tau_0 + period * s_.cycles), last_period_(N_, s_.tau_0 + period * (s_.cycles - 1), s_.samples, contact_) {
        if (s_.start) {
            std::ranges::copy(s_.start->x, step_.y_0.begin());
            std::ranges::copy(s_.start->x_prime, step_.y_0.begin() + static_cast<std::ptrdiff_t>(N_));
        }
        if (s_.history) motion_.history.resize(static_cast<std::size_t>(s_.cycles));
        history_.resize(motion_.history.size());
    }

    PaperMotion run() {
        while (tau_ < end_ && motion_.status == IntegrationStatus::complete) {
            start_phase();
            const double start = tau_;
            count_phase();
            while (motion_.status == IntegrationStatus::complete && !one_step()) {
            }
            next_[direction_ == 0 ? 0 : 1] = step_.next;
            if (direction_ == 0) end_of_rest(start);
            phases_of_no_length_ = tau_ > start ? 0 : phases_of_no_length_ + 1;
        }
        motion_.right_hand_sides = equations_.evaluations;
        if (motion_.status == IntegrationStatus::complete)
            write();
        else
            motion_.history.clear();
        return std::move(motion_);
    }

private:
    static constexpr double period = 2 * std::numbers::pi;
    static constexpr double longest_step = std::numbers::pi / 4;
    static constexpr double epsilon = std::numeric_limits<double>::epsilon();
    static constexpr double first_step = longest_step / 16;

    [[nodiscard]] double contact_velocity() const { return contact_.of(&step_.y_0[N_]); }

    void fail(IntegrationStatus status, const std::string& reason) {
        motion_.status = status;
        motion_.reason = reason + " at tau = " + number_to_text(tau_);
    }

    // (74): where the contact rests and its load does not exceed static friction it sticks; a load that equals it to rounding
    // lets go where it grows. Without friction it never sticks.
    void start_phase() {
        load_grows_ = false;
        from_rest_ = contact_velocity() == 0 && equations_.beta > 0;
        if (!from_rest_) {
            direction_ = contact_velocity() < 0 ? -1 : 1;
        } else {
            equations_.set(0);
            equations_(step_.y_0, step_.f_0, tau_);
            const double load = equations_.load_on_contact(step_.y_0, tau_);
            const double rate = equations_.linear_load(step_.f_0) + equations_.harmonic_load_at(tau_).sine;
            // Rounding, that of the time included.
            const double error = equations_.load_error(step_.y_0) + 2 * epsilon * std::abs(tau_ * rate);
            const double margin = paper::sticking_margin(std::abs(load), equations_.mu, equations_.beta);
            load_grows_ = rate * load > 0 && std::abs(rate) > equations_.load_error(step_.f_0);
            const bool slides = margin < -error || (margin <= error && load_grows_);
            direction_ = !slides ? 0 : load > 0 ? 1 : -1;
            noise_ = error * (direction_ == 0 ? 1 : equations_.compliance);
        }
        equations_.set(direction_);
        if (direction_ != 0) equations_(step_.y_0, step_.f_0, tau_);
        step_.next = next_[direction_ == 0 ? 0 : 1];
        first_ = true;
        restarts_ = 0;
    }

    void count_phase() {
        ++motion_.phases;
        const int cycle = static_cast<int>((tau_ - s_.tau_0) / period);
        phases_in_cycle_ = cycle == cycle_ ? phases_in_cycle_ + 1 : 1;
        cycle_ = cycle;
        if (phases_in_cycle_ > s_.most_phases_per_cycle)
            fail(IntegrationStatus::chattering, "a period has more than " + std::to_string(s_.most_phases_per_cycle) + " phases");
        else if (phases_of_no_length_ > most_phases_of_no_length)
            fail(IntegrationStatus::chattering, "phases of zero length follow each other");
    }

    // One step of the phase; true where the phase ends with it.
    bool one_step() {
        const bool final = tau_ + step_.next >= end_;
        if (final) step_.next = end_ - tau_;
        if (motion_.steps + motion_.rejected_steps >= s_.most_steps) {
            fail(IntegrationStatus::step_limit,
                 "reaching the final time takes more than " + std::to_string(s_.most_steps) + " steps");
            return true;
        }
        if (!(tau_ + step_.next > tau_)) {
            fail(IntegrationStatus::step_limit, "the steps are too short to advance the time");
            return true;
        }
        const double wanted = step_.next;
        if (!step_.attempt(equations_, tau_)) {
            ++motion_.rejected_steps;
            return false;
        }
        if (!finite(step_.y_1)) {
            fail(IntegrationStatus::overflow, "a displacement or velocity is beyond the range of a double");
            return true;
        }
        const std::optional<double> event = direction_ == 0 ? breakaway() : standstill();
        // A contact that its load sets in motion cannot turn at once: the step is too long to resolve how it leaves.
        if (event == 0.0 && first_ && direction_ != 0 && load_grows_ && restarts_ < most_restarts) {
            ++motion_.rejected_steps;
            ++restarts_;
            step_.next = wanted / 8;
            return false;
        }
        ++motion_.steps;
        const double to = event.value_or(1);
        last_period_.take(step_, tau_, to);
        if (s_.history) take_history(to);
        if (event) {
            const double at = tau_ + to * step_.h; // and the state is that of the rounded time
            step_.state((at - tau_) / step_.h, last_);
            step_.y_0.swap(last_);
            tau_ = at;
            contact_.hold(&step_.y_0[N_]);
            return true;
        }
        step_.advance();
        tau_ = final ? end_ : tau_ + step_.h;
        first_ = false;
        return final;
    }

    // The end of a sliding phase, x_j' = 0; without friction nothing happens there.
    std::optional<double> standstill() {
        if (equations_.beta == 0) return std::nullopt;
        const auto speed = [this](const DenseStep::Y& y) { return direction_ * contact_.of(&y[N_]); };
        return first_fall(step_.over_step(speed), first_ && from_rest_ ? noise_ * step_.h : 0);
    }

    // The end of a sticking phase, Sigma_j > mu beta by more than rounding.
    std::optional<double> breakaway() {
        StepFunction load = step_.over_step([this](const DenseStep::Y& y) { return equations_.linear_load(y); });
        const HarmonicLoad at = equations_.harmonic_load_at(tau_);
        load.cosine = at.cosine;
        load.sine = at.sine;
        load.h = step_.h;
        load.c[0] += equations_.static_load;
        const double limit = equations_.mu * equations_.beta + noise_, noise = first_ ? noise_ : 0;
        const std::optional<double> upwards = first_fall(limit - load, noise), downwards = first_fall(limit - (0 - load), noise);
        return upwards && downwards ? std::min(*upwards, *downwards) : upwards ? upwards : downwards;
    }

    void end_of_rest(double start) {
        if (!(tau_ > start)) return;
        last_period_.take_rest(start, tau_, contact_.of(step_.y_0), tau_ == end_);
        const auto cycle = static_cast<std::size_t>((tau_ - s_.tau_0) / period);
        if (cycle < motion_.history.size()) ++motion_.history[cycle].stops;
    }

    // The contact's extrema of every period that the step reaches into.
    void take_history(double to) {
        const double start = tau_ - s_.tau_0;
        const auto last = static_cast<std::size_t>((start + to * step_.h) / period);
        for (auto cycle = static_cast<std::size_t>(start / period); cycle <= last && cycle < history_.size(); ++cycle) {
            const double from = (static_cast<double>(cycle) * period - start) / step_.h;
            take_extrema(
                step_, [this](const double* x) { return contact_.of(x); }, tau_, std::clamp(from, 0.0, to),
                std::clamp(from + period / step_.h, 0.0, to), zeros_, history_[cycle]);
        }
    }

    void write() {
        const auto middle = step_.y_0.begin() + static_cast<std::ptrdiff_t>(N_);
        motion_.end = {{step_.y_0.begin(), middle}, {middle, step_.y_0.end()}};
        last_period_.write(motion_);
        for (std::size_t n = 0; n < history_.size(); ++n) motion_.history[n].amplitude = history_[n].amplitude;
    }

    const PaperSettings& s_;
    ContactEquations equations_;
    std::size_t N_;
    const Contact& contact_;
    DenseStep step_;
    double tau_, end_;
    LastPeriod last_period_;
    PaperMotion motion_;
    std::vector<DisplacementRange> history_;
    std::vector<double> last_ = std::vector<double>(2 * N_), zeros_;
    std::array<double, 2> next_ = {first_step, first_step}; // length to try first while the contact sticks, while it slides
    int direction_ = 1;                                     // of the phase
    bool from_rest_ = false;                                // the contact was at rest at the start of the phase
    bool load_grows_ = false;                               // its load grew there, by more than rounding
    bool first_ = true;                                     // the step is the first of the phase
    double noise_ = 0;                                      // rounding error of what the event function starts with
    int restarts_ = 0;
    int cycle_ = -1;
    long phases_in_cycle_ = 0;
    int phases_of_no_length_ = 0;
};

} // namespace

void check(const PaperSettings& s, std::size_t N) {
    const auto count = [](const char* name, long n, long least, long most) {
        if (n < least || n > most)
            throw InputError(name, "must be from " + std::to_string(least) + " to " + std::to_string(most), std::to_string(n));
    };
    const auto number = [](const char* name, double x, const char* rule, bool holds) {
        if (!holds || !std::isfinite(x)) throw InputError(name, rule, number_to_text(x));
    };
    count("cycles", s.cycles, 1, most_cycles);
    count("samples", s.samples, 0, static_cast<long>(most_samples));
    if (s.samples > 0) check_samples("samples", static_cast<std::size_t>(s.samples), N);
    count("most_steps", s.most_steps, 1, 1'000'000'000'000);
    count("most_phases_per_cycle", s.most_phases_per_cycle, 1, 1'000'000'000'000);
    number("absolute_tolerance", s.absolute_tolerance, "must be positive and below 1",
           s.absolute_tolerance > 0 && s.absolute_tolerance < 1);
    const double relative = s.relative_tolerance.value_or(0);
    number("relative_tolerance", relative, "must be zero or positive and below 1", relative >= 0 && relative < 1);
    number("tau_0", s.tau_0, "must be from -1e6 to 1e6", std::abs(s.tau_0) <= 1e6);
    if (!s.start) return;
    for (const std::vector<double>* each : {&s.start->x, &s.start->x_prime}) {
        if (each->size() != N)
            throw InputError("start", "must have " + std::to_string(N) + " displacements and velocities",
                             std::to_string(each->size()));
        for (const double x : *each) number("start", x, "must be finite", true);
    }
}

PaperMotion paper_algorithm(const ContactProblem& problem, const PaperSettings& settings) {
    check(settings, static_cast<std::size_t>(problem.matrices.M.rows()));
    return Integration(problem, settings).run();
}

PaperMotion paper_algorithm(const Scene<double>& scene, const PaperSettings& settings) {
    return paper_algorithm(contact_problem(scene), settings);
}

} // namespace denhartog
