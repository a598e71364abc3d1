#include "denhartog/solve/response.hpp"

#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"

namespace denhartog {
namespace {

template <class T>
ModeSums<T> sums_of(const Scene<T>& scene) {
    if (!scene.r) throw InputError("r", "must be given", "");
    return mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
}

} // namespace

template <class T>
Response<T> response(const Scene<T>& scene, std::optional<Mass> only) {
    check(scene);
    const ModeSums<T> sums = sums_of(scene);
    Response<T> all{*scene.r, scene.mu, scene.beta, scene.system.contact, boundary(sums, scene.mu), std::nullopt, std::nullopt};
    if (!scene.beta) return all;
    all.regime = regime_at(all.boundary, *scene.beta, rounding_of(all.boundary));
    if (all.regime->regime == Regime::continuous) all.steady_state = steady_state(sums, all.boundary, *scene.beta, only);
    return all;
}

template <class T>
Response<T> response_at(const Scene<T>& scene, const Response<T>& known, std::optional<Mass> only) {
    const ModeSums<T> sums = sums_of(scene);
    Response<T> all{*scene.r,
                    scene.mu,
                    scene.beta,
                    scene.system.contact,
                    boundary_at(sums, scene.mu, known.boundary.instant, known.boundary.instants),
                    std::nullopt,
                    std::nullopt};
    if (!scene.beta) return all;
    all.regime = regime_at(all.boundary, *scene.beta, rounding_of(all.boundary));
    if (all.regime->regime != Regime::continuous || !known.steady_state) return all;
    std::vector<T> instants;
    for (const MassResponse<T>& m : known.steady_state->masses) instants.push_back(m.instant);
    all.steady_state = steady_state_at(sums, *scene.beta, instants, only);
    return all;
}

template Response<double> response(const Scene<double>&, std::optional<Mass>);
template Response<long double> response(const Scene<long double>&, std::optional<Mass>);
template Response<Real50> response(const Scene<Real50>&, std::optional<Mass>);
template Response<Real100> response(const Scene<Real100>&, std::optional<Mass>);
template Response<double> response_at(const Scene<double>&, const Response<double>&, std::optional<Mass>);
template Response<long double> response_at(const Scene<long double>&, const Response<long double>&, std::optional<Mass>);
template Response<Real50> response_at(const Scene<Real50>&, const Response<Real50>&, std::optional<Mass>);
template Response<Real100> response_at(const Scene<Real100>&, const Response<Real100>&, std::optional<Mass>);

} // namespace denhartog
