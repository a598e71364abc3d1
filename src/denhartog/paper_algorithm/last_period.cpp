// Amplitudes, phases and samples of the last period of an integration, from the polynomials of its steps: an extremum is at an
// end of a step or at a zero of the velocity. Read `take_extrema`.
#include "denhartog/paper_algorithm/last_period.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/sliding/steady_state.hpp"

namespace denhartog {

void DisplacementRange::take(double x, double tau) {
    amplitude = std::max(amplitude, std::abs(x));
    if (empty || x > largest) {
        largest = x;
        instant = tau;
    }
    if (empty || x < smallest) smallest = x;
    empty = false;
}

void take_extrema(DenseStep& step, const DisplacementOf& of, double tau, double from, double to, std::vector<double>& zeros,
                  DisplacementRange& range) {
    const std::size_t N = step.y_0.size() / 2;
    const StepFunction x = step.over_step([&of](const DenseStep::Y& y) { return of(y.data()); });
    const auto take = [&](double theta) { range.take(x(theta).f[0], tau + theta * step.h); };
    take(from);
    take(to);
    sign_changes(step.over_step([&of, N](const DenseStep::Y& y) { return of(y.data() + N); }), zeros);
    for (const double theta : zeros)
        if (theta > from && theta < to) take(theta);
}

LastPeriod::LastPeriod(std::size_t N, double start, int samples, const Contact& contact)
    : start_(start), contact_(&contact), ranges_(contact.has_own_row() ? N + 1 : N), y_(2 * N) {
    for (int n = 0; n < samples; ++n) sample_times_.push_back(2 * pi<double>() * n / samples);
}

void LastPeriod::take(DenseStep& step, double tau, double to) {
    if (!(tau + to * step.h > start_)) return;
    const std::size_t N = y_.size() / 2;
    const double from = std::clamp((start_ - tau) / step.h, 0.0, to);
    for (std::size_t k = 0; k < ranges_.size(); ++k) {
        const auto of = [this, k, N](const double* x) { return k < N ? x[k] : contact_->of(x); };
        take_extrema(step, of, tau, from, to, zeros_, ranges_[k]);
    }
    while (samples_.size() < sample_times_.size()) {
        const double theta = (start_ + sample_times_[samples_.size()] - tau) / step.h;
        if (theta > to) break;
        step.state(std::max(theta, from), y_);
        const auto middle = y_.begin() + static_cast<std::ptrdiff_t>(N);
        samples_.push_back({{y_.begin(), middle}, {middle, y_.end()}});
    }
}

void LastPeriod::take_rest(double from, double to, double x, bool last) {
    if (!(to > start_ && to > from)) return;
    slides_throughout_ = false;
    const double period = 2 * pi<double>();
    if (last) {
        if (!(from <= start_)) return; // its end is not known; the one a period earlier has been counted
        rests_ = true;
        stops_ = {{0, period, x}};
        return;
    }
    const double shift = from < start_ ? period : 0;
    stops_.push_back({from - start_ + shift, to - start_ + shift, x});
}

void LastPeriod::write(PaperMotion& motion) const {
    motion.stops = stops_;
    std::ranges::sort(motion.stops, {}, &Stop::start);
    motion.rests = rests_;
    motion.slides = slides_throughout_;
    for (const DisplacementRange& range : ranges_) {
        motion.masses.push_back({range.amplitude, std::nullopt});
        if (slides_throughout_ && range.largest > range.smallest) motion.masses.back().phase = wrapped(range.instant);
    }
    if (contact_->has_own_row()) {
        motion.between = motion.masses.back();
        motion.masses.pop_back();
    }
    motion.sample_times = sample_times_;
    motion.samples = samples_;
}

} // namespace denhartog
