#include "denhartog/orbit/shooting.hpp"

#include "denhartog/model/linear_algebra.hpp"

namespace denhartog {

bool Shooting::fixed_point(State& z, int h, BadSteps bad_steps) {
    constexpr int most_runs = 40;
    residual_ = -1;
    double least = -1, part = 1; // residual where the last step started, negative where there is none; part of it that is taken
    int bad = 0;
    for (int n = 0; n < most_runs; ++n) {
        if (!map_->apply(z, h, true)) return false;
        const bool held = map_->held();
        if (held && least < 0) return false;
        const double residual = map_->norm(map_->difference());
        if (!(residual - residual == 0)) return false;
        const double rounding = map_->rounding_in_energy().norm(); // a bound, and some way above what is seen
        const bool falls = !held && (least < 0 || residual < least * (1 - part / 8));
        if (falls) residual_ = residual;
        if (!held && residual <= (falls ? rounding / 8 : 8 * rounding)) return true;
        bad += !falls;
        if (bad > static_cast<int>(bad_steps)) return false;
        part = !falls ? part / 2 : prepare_step(z) ? 1 : 0;
        if (falls) least = residual;
        if (8 * part >= 1) {
            take_step(part, z);
            continue;
        }
        if (bad_steps != BadSteps::all_and_go_on_from_image) return false;
        z = image_;
        least = -1;
        part = 1;
    }
    return false;
}

// The step from z, where the map was applied last; false where there is none.
bool Shooting::prepare_step(const State& z) {
    from_ = z;
    image_ = map_->image();
    rests_at_0_ = contact_->of(image_.x_prime) == 0 && map_->motion().phases.back().direction == 0;
    const LinearSystem<double> system(Matrix<double>(Matrix<double>::Identity(2 * map_->N, 2 * map_->N) - map_->jacobian()));
    if (!system.is_regular()) return false;
    step_ = system.solve(map_->difference());
    ++steps_;
    return true;
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
