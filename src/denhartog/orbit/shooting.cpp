#include "denhartog/orbit/shooting.hpp"

#include <algorithm>

#include "denhartog/model/linear_algebra.hpp"

namespace denhartog {

bool Shooting::fixed_point(State& z, int h, AfterBadStep after_bad_step) {
    residual_ = -1;
    double least = -1, part = 1; // residual where the last step started, negative where there is none; part of it that is taken
    int bad_steps = 0;
    for (int n = 0; n < most_runs; ++n) {
        if (!map_->apply(z, h, true)) return false;
        const bool held = map_->held();
        if (held && least < 0) return false;
        const double residual = map_->norm(map_->difference());
        if (!(residual - residual == 0)) return false;
        const double rounding = map_->rounding_in_energy().norm();
        const bool falls = !held && (least < 0 || residual < least * (1 - part / 8));
        if (falls) residual_ = residual;
        if (!held && (residual <= enough(z, rounding) || (!falls && residual <= 8 * rounding))) return true;
        bad_steps += !falls;
        if (bad_steps > most_bad_steps(after_bad_step)) return false;
        part = falls ? prepare_step(z) : part / 2;
        if (falls) least = residual;
        if (8 * part >= 1) {
            take_step(part, z);
            continue;
        }
        if (after_bad_step != AfterBadStep::go_on_from_image_at_last) return false;
        z = image_;
        least = -1;
        part = 1;
    }
    return false;
}

double Shooting::enough(const State& z, double rounding) const {
    const double at_rounding = rounding / 8; // which is a bound, and some way above what is seen
    return tolerance_ > 0 ? std::max(at_rounding, tolerance_ * map_->norm(z)) : at_rounding;
}

double Shooting::prepare_step(const State& z) {
    from_ = z;
    image_ = map_->image();
    rests_at_0_ = contact_->of(image_.x_prime) == 0 && map_->motion().phases.back().direction == 0;
    const LinearSystem<double> system(map_->newton_matrix());
    if (!system.is_regular()) return 0;
    step_ = system.solve(map_->difference());
    ++steps_;
    return 1;
}

void Shooting::take_step(double part, State& z) const {
    for (Eigen::Index k = 0; k < map_->N; ++k) {
        const auto n = static_cast<std::size_t>(k);
        z.x[n] = from_.x[n] + part * step_(k);
        z.x_prime[n] = from_.x_prime[n] + part * step_(map_->N + k);
    }
    if (rests_at_0_ && part == 1) contact_->hold(z.x_prime.data());
}

} // namespace denhartog
