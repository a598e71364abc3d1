// One step of the Runge-Kutta method of Dormand and Prince with its dense output.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <functional>
#include <utility>
#include <vector>

#include "denhartog/paper_algorithm/contact_equations.hpp"
#include "denhartog/paper_algorithm/detail/step_function.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {

// Steps of variable length; keeps both ends of the last one. Times are theta in [0, 1] of the step.
class DenseStep {
public:
    using Y = std::vector<double>; // a state, x and x', 2N values

    DenseStep(std::size_t N, double absolute_tolerance, double relative_tolerance, double longest)
        : stepper_(Checker(absolute_tolerance, relative_tolerance, 1, 0), Adjuster(longest)), y_0(2 * N), f_0(2 * N), y_1(2 * N),
          f_1(2 * N), third_(2 * N), two_thirds_(2 * N) {}

    // Tries one step of length `next` from y_0 at tau; where its error is too large `next` is shortened. True where the step is
    // taken: y_1, f_1 and h are then those of its end. The length is rounded so that its end is a double: else rounding of the
    // time adds up over the steps.
    bool attempt(ContactEquations& equations, double tau) {
        const double end = tau + next;
        h = next = end - tau;
        inner_known_ = false;
        return stepper_.try_step(std::ref(equations), y_0, f_0, tau, y_1, f_1, next) == boost::numeric::odeint::success;
    }

    // The end of the step becomes the start of the next.
    void advance() {
        y_0.swap(y_1);
        f_0.swap(f_1);
    }

    // The state within the step.
    void state(double theta, Y& y) { stepper_.stepper().calc_state(theta * h, y, y_0, f_0, 0.0, y_1, f_1, h); }

    // A linear function of the state, or of its derivative, over the step.
    template <class Linear>
    [[nodiscard]] StepFunction over_step(const Linear& f) {
        if (!inner_known_) {
            state(1.0 / 3, third_);
            state(2.0 / 3, two_thirds_);
            inner_known_ = true;
        }
        return quintic({f(y_0), h * f(f_0), f(y_1), h * f(f_1), f(third_), f(two_thirds_)});
    }

private:
    using Stepper = boost::numeric::odeint::runge_kutta_dopri5<Y>;
    using Checker = boost::numeric::odeint::default_error_checker<double, Stepper::algebra_type, Stepper::operations_type>;
    // The rule of odeint's own, by powers that are the same on every machine. It limits a step where its length is chosen; the
    // length tried may be longer by the rounding of its end.
    struct Adjuster : boost::numeric::odeint::default_step_adjuster<double, double> {
        using default_step_adjuster::default_step_adjuster;
        [[nodiscard]] double decrease_step(double step, double error, int order) const {
            return std::min(step * std::max(0.9 * root_of_inverse(error, order - 1), 0.2), m_max_dt);
        }
        [[nodiscard]] double increase_step(double step, double error, int order) const {
            return error < 0.5 ? std::min(step * std::min(0.9 * root_of_inverse(error, order), 4.5), m_max_dt) : step;
        }
        [[nodiscard]] static bool check_step_size_limit(double) { return true; }
        [[nodiscard]] static double root_of_inverse(double x, int order) { return elementary::exp(-elementary::log(x) / order); }
    };
    boost::numeric::odeint::controlled_runge_kutta<Stepper, Checker, Adjuster> stepper_;

public:
    Y y_0;           // state at the start
    Y f_0;           // its derivative
    Y y_1;           // state at the end
    Y f_1;           // its derivative
    double h = 0;    // length of the step taken
    double next = 0; // length of the step to try

private:
    Y third_, two_thirds_;
    bool inner_known_ = false;
};

} // namespace denhartog
