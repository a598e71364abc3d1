#include <optional>

#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "denhartog/sums/bounded_modes.hpp"
#include "denhartog/sums/coupled_sums.hpp"
#include "tests/conformance/generator/route.hpp"

namespace denhartog::conformance::generator {
namespace {

template <class T>
class ClosedForm : public Route<T> {
public:
    ClosedForm(const ProtocolQuestion& q, Regime regime, ClosedForm* near)
        : scene_(in_own_coordinates(wide_scene_of<T>(q))), regime_(regime), near_(near), basis_(modal_basis(scene_.system)) {}

    std::vector<T> numbers(const ProtocolQuestion& q) override {
        const std::string& name = q.quantity;
        const std::size_t k = row_of(q, scene_.system);
        if (name == "natural_frequency_ratios") return basis_.r_n;
        if (name == "modal_frequency_ratios") return frequency_ratios();
        if (name == "mode_shape_products") return products(k);
        if (name == "beta_lim_high_frequency") return {paper::friction_ratio_limit_at_high_frequency(scene_.mu)};
        if (name == "complex_response") return {sums().V[k].re, sums().V[k].im};
        if (name == "first_damping_function") return {sums().U[k]};
        if (name == "second_damping_function") return {sums().G[k]};
        if (name == "H_j") return {sums().H_j};
        if (name == "S_j") return {limits().S_exact};
        if (name == "beta_lim_exact") return {limits().exact};
        if (name == "beta_lim_paper") return {limits().paper};
        if (name == "beta_lim_approximate") return {limits().approximate};
        if (name == "beta_lim_sticking") return limits().sticking ? std::vector<T>{*limits().sticking} : std::vector<T>{};
        if (regime_ == Regime::permanent_sticking) return held(q, k);
        if (regime_ == Regime::continuous) return sliding(q, k);
        return {};
    }

private:
    Scene<T> scene_;
    Regime regime_;
    ClosedForm* near_;
    ModalBasis<T> basis_;
    std::optional<ModeSums<T>> sums_;
    std::optional<Boundary<T>> boundary_;
    std::optional<SteadyState<T>> state_;

    std::vector<T> frequency_ratios() const {
        std::vector<T> R;
        for (const T& r_n : basis_.r_n) R.push_back(*scene_.r / r_n);
        return R;
    }

    std::vector<T> products(std::size_t k) const {
        std::vector<T> all;
        for (Eigen::Index i = 0; i < basis_.phi.cols(); ++i)
            all.push_back(basis_.phi(static_cast<Eigen::Index>(k), i) *
                          basis_.phi(static_cast<Eigen::Index>(scene_.system.contact.index), i) / (*scene_.r * *scene_.r));
        return all;
    }

    const ModeSums<T>& sums() {
        if (sums_) return *sums_;
        if (basis_.coupled())
            sums_ = values_of(coupled_sums(scene_.system, Bounded<T>(*scene_.r)));
        else
            sums_ = mode_sums(basis_, scene_.system.contact, scene_.system.load, *scene_.r);
        return *sums_;
    }

    // Next to another scene its instants serve: what that leaves out of a maximum is of second order.
    const Boundary<T>& limits() {
        if (!boundary_)
            boundary_ = near_ ? boundary_at(sums(), scene_.mu, near_->limits().instant, near_->limits().instants)
                              : boundary(sums(), scene_.mu);
        return *boundary_;
    }

    const SteadyState<T>& state() {
        if (state_) return *state_;
        if (near_) {
            std::vector<T> instants;
            for (const MassResponse<T>& m : near_->state().masses) instants.push_back(m.instant);
            state_ = with_maxima(sums(), steady_state_without_maxima(sums(), *scene_.beta), instants);
        } else {
            state_ = steady_state(sums(), limits(), *scene_.beta);
        }
        return *state_;
    }

    std::vector<T> sliding(const ProtocolQuestion& q, std::size_t k) {
        const MassResponse<T>& m = state().masses[k];
        if (q.quantity == "amplitude") return {m.amplitude};
        if (q.quantity == "phase") return {m.phase};
        if (q.quantity == "amplitude_monoharmonic") return {m.amplitude_monoharmonic};
        if (q.quantity == "phase_monoharmonic") return {m.phase_monoharmonic};
        if (q.quantity == "initial_displacement") return {m.x0};
        if (q.quantity == "initial_velocity") return {m.v0};
        if (q.quantity == "displacement") return {motion(sums(), state(), T(q.tau)).x[k]};
        if (q.quantity != "motion_under_force") return {};
        std::vector<T> x;
        for (int n = 0; n < q.samples; ++n)
            x.push_back(motion(sums(), state(), T(2 * n * pi<T>() / q.samples - state().phi_j)).x[k]);
        return x;
    }

    // The motion of a mass that is no coordinate.
    Complex<T> held_beside(const StuckResponse<T>& response, std::size_t k) const {
        const Matrix<T>& displacements = scene_.system.coordinates.displacements;
        Complex<T> X{T(0), T(0)};
        for (std::size_t n = 0; n < response.masses.size(); ++n)
            X = X + displacements(static_cast<Eigen::Index>(k - response.masses.size()), static_cast<Eigen::Index>(n)) *
                        response.masses[n].X;
        return X;
    }

    std::vector<T> held(const ProtocolQuestion& q, std::size_t k) {
        const StuckConfiguration<T> stuck = stuck_configuration(scene_.system, basis_);
        const StuckResponse<T> response = stuck_response(stuck, scene_.system.contact, scene_.system.load, *scene_.r);
        if (q.quantity == "rest_interval") {
            const std::optional<T> reach = rest_interval(stuck, response, scene_.mu, *scene_.beta);
            return reach ? std::vector<T>{*reach} : std::vector<T>{};
        }
        const StuckMass<T> m = k < response.masses.size() ? response.masses[k] : motion_of(held_beside(response, k));
        if (q.quantity == "amplitude") return {m.amplitude};
        if (q.quantity == "phase") return m.phase ? std::vector<T>{*m.phase} : std::vector<T>{};
        if (q.quantity != "motion_under_force") return {};
        std::vector<T> x;
        for (int n = 0; n < q.samples; ++n) {
            const T tau = 2 * n * pi<T>() / q.samples;
            x.push_back(m.X.re * cos(tau) - m.X.im * sin(tau));
        }
        return x;
    }
};

} // namespace

template <class T>
std::unique_ptr<Route<T>> closed_form(const ProtocolQuestion& scene, Regime regime, Route<T>* near) {
    return std::make_unique<ClosedForm<T>>(scene, regime, static_cast<ClosedForm<T>*>(near));
}

template std::unique_ptr<Route<Real50>> closed_form(const ProtocolQuestion&, Regime, Route<Real50>*);
template std::unique_ptr<Route<Real100>> closed_form(const ProtocolQuestion&, Regime, Route<Real100>*);

} // namespace denhartog::conformance::generator
