#include "denhartog/solve/error_bound.hpp"

#include <algorithm>
#include <concepts>
#include <limits>

#include "denhartog/number/multiprecision.hpp"

namespace denhartog {
namespace {

template <class T>
T absolute(const T& x) {
    return x < 0 ? T(-x) : x;
}

// Twice the difference plus a unit in the last place of T, in the wider type.
template <class T, class Wide>
Wide error_of(const T& x, const Wide& wider, const Wide& scale) {
    const Wide unit = Wide(std::numeric_limits<T>::epsilon()) * absolute(scale);
    return 2 * absolute(Wide(Wide(x) - wider)) + unit;
}

template <class T, class Wide>
Wide relative_error(const T& x, const Wide& wider) {
    if (wider == 0) return x == 0 ? Wide(0) : Wide(1);
    return error_of(x, wider, wider) / absolute(wider);
}

template <class T, class Wide>
Wide boundary_error(const Boundary<T>& b, const Boundary<Wide>& wider) {
    Wide largest = std::max({relative_error(b.exact, wider.exact), relative_error(b.paper, wider.paper),
                             relative_error(b.approximate, wider.approximate)});
    if (b.sticking && wider.sticking) largest = std::max(largest, relative_error(*b.sticking, *wider.sticking));
    return b.sticking.has_value() == wider.sticking.has_value() ? largest : std::max(largest, Wide(1));
}

template <class T, class Wide>
Wide displacement_error(const MassResponse<T>& m, const MassResponse<Wide>& wider) {
    const Wide scale = wider.amplitude;
    return std::max({error_of(m.x0, wider.x0, scale), error_of(m.v0, wider.v0, scale),
                     error_of(m.amplitude, wider.amplitude, scale),
                     error_of(m.amplitude_monoharmonic, wider.amplitude_monoharmonic, scale)});
}

// A limit that comes out the same to all the digits of the wider type is exact, as 1 / mu with mu = 1.
template <class T, class Wide>
T limit_error(const T& x, const Wide& wider) {
    return Wide(x) == wider ? T(0) : static_cast<T>(error_of(x, wider, wider));
}

template <class T, class Wide>
Wide phase_error(const T& phase, const Wide& wider) {
    return 2 * absolute(wrapped(Wide(Wide(phase) - wider))) + Wide(4 * std::numeric_limits<T>::epsilon());
}

} // namespace

template <class T, class Wide>
MeasuredError<T> measured_error(const Response<T>& response, const Response<Wide>& wider, std::optional<Mass> only) {
    MeasuredError<T> error;
    Wide relative = boundary_error(response.boundary, wider.boundary);
    error.boundary.exact = limit_error(response.boundary.exact, wider.boundary.exact);
    if (response.boundary.sticking && wider.boundary.sticking)
        error.boundary.sticking = limit_error(*response.boundary.sticking, *wider.boundary.sticking);
    if (response.regime) error.comparable = wider.regime && response.regime->regime == wider.regime->regime;
    if (error.comparable && response.steady_state) {
        const auto& masses = response.steady_state->masses;
        const auto& wide_masses = wider.steady_state->masses;
        Wide largest_amplitude(0);
        for (const MassResponse<Wide>& m : wide_masses) largest_amplitude = std::max(largest_amplitude, m.amplitude);
        for (std::size_t k = 0; k < masses.size(); ++k) {
            const Wide e = displacement_error(masses[k], wide_masses[k]);
            error.masses.push_back(static_cast<T>(e));
            if (only && k != only->index) continue;
            // A mass that does not move; of the one that is asked about double cannot tell.
            if ((!only || !std::same_as<T, double>)&&Wide(masses[k].amplitude) <= e &&
                e <= largest_amplitude * Wide(std::numeric_limits<T>::epsilon()) * 1024)
                continue;
            if (wide_masses[k].amplitude > 0) relative = std::max(relative, Wide(e / wide_masses[k].amplitude));
            relative = std::max({relative, phase_error(masses[k].phase, wide_masses[k].phase),
                                 phase_error(masses[k].phase_monoharmonic, wide_masses[k].phase_monoharmonic)});
        }
    }
    if (!error.comparable) {
        relative = 1;
        if (response.steady_state)
            for (const MassResponse<T>& m : response.steady_state->masses) error.masses.push_back(m.amplitude);
    }
    error.relative = static_cast<T>(relative);
    return error;
}

template <class Wide, class T>
Response<Wide> instants_in(const Response<T>& response) {
    Response<Wide> wide{};
    wide.boundary.instant = Wide(response.boundary.instant);
    for (const T& instant : response.boundary.instants) wide.boundary.instants.push_back(Wide(instant));
    if (!response.steady_state) return wide;
    wide.steady_state.emplace();
    for (const MassResponse<T>& m : response.steady_state->masses) {
        MassResponse<Wide> known{};
        known.instant = Wide(m.instant);
        wide.steady_state->masses.push_back(known);
    }
    return wide;
}

template <class T>
void set_error(Response<T>& response, const MeasuredError<T>& error) {
    if (response.beta) response.regime = regime_at(response.boundary, *response.beta, error.boundary);
    if (!response.steady_state) return;
    for (std::size_t k = 0; k < error.masses.size(); ++k) response.steady_state->masses[k].error_bound = error.masses[k];
}

template MeasuredError<double> measured_error(const Response<double>&, const Response<long double>&, std::optional<Mass>);
template MeasuredError<double> measured_error(const Response<double>&, const Response<Real50>&, std::optional<Mass>);
template MeasuredError<Real50> measured_error(const Response<Real50>&, const Response<Real100>&, std::optional<Mass>);
template MeasuredError<Real100> measured_error(const Response<Real100>&, const Response<Real100>&, std::optional<Mass>);
template Response<long double> instants_in(const Response<double>&);
template Response<Real50> instants_in(const Response<double>&);
template Response<Real100> instants_in(const Response<Real50>&);
template void set_error(Response<double>&, const MeasuredError<double>&);
template void set_error(Response<Real50>&, const MeasuredError<Real50>&);
template void set_error(Response<Real100>&, const MeasuredError<Real100>&);

} // namespace denhartog
