/// @file
/// @brief The response in double with bounds of its errors known beforehand: no second computation in more digits.
///
/// The formulas are evaluated on `Bounded` numbers, from errors of the modes that the eigen-solvers are trusted with: of each
/// natural frequency 8 N eps of itself on a chain, of its square 8 N eps of the highest square else; of a mode shape 8 N eps over
/// the relative distance of its frequency from the next one; and from an error of one unit in the last place of every input.
#pragma once

#include <optional>

#include "denhartog/bounded.hpp"
#include "denhartog/response/response.hpp"

namespace denhartog {

/// @brief A modal basis with bounds of its errors.
/// @param system  the system, damping given by ratios
/// @param basis   its basis in double
/// @return        the basis with errors
[[nodiscard]] ModalBasis<Bounded> with_errors(const System<double>& system, const ModalBasis<double>& basis);

/// @brief A number of the input, one unit in the last place uncertain. @param x a number @return the number with its error
[[nodiscard]] Bounded as_input(double x);

/// @brief The modes of a scene at its frequency ratio, each evaluated with its error when it is first needed.
class BoundedModes {
public:
    /// @param scene  the scene, with r, damping given by ratios
    /// @param basis  its modal basis
    BoundedModes(const Scene<double>& scene, const ModalBasis<double>& basis);

    /// @brief The modal basis. @return frequencies, shapes, damping ratios with their errors
    [[nodiscard]] const ModalBasis<Bounded>& basis() const { return basis_; }
    /// @brief The frequency ratio. @return r with its error
    [[nodiscard]] const Bounded& r() const { return r_; }
    /// @brief A mode. @param i its index @return (23), (28), (29) @throws DomainError at a pole
    const evaluation::ModeFunctions<Bounded>& at(std::size_t i);
    /// @brief All modes. @return (23), (28), (29) of each @throws DomainError at a pole
    std::vector<evaluation::ModeFunctions<Bounded>> all();

private:
    ModalBasis<Bounded> basis_;
    Bounded r_;
    std::vector<std::optional<evaluation::ModeFunctions<Bounded>>> known_;
};

/// @brief A response with bounds of its errors.
struct BoundedResponse {
    Response<double> response;       ///< the response; error bounds of the masses and the regime with its boundary's error set
    double relative = 0;             ///< largest error, relative to amplitudes and friction ratios, absolute for phases
    std::vector<double> phase_error; ///< absolute errors of the phases, N values; empty where nothing slides
};

/// @brief The response at the point of a scene with bounds of its errors.
/// @eq{38,39,44,45,47,52,53,69}
/// @param scene        the scene, with r and beta
/// @param modes        its modes
/// @param with_motion  whether the steady state is wanted too, or boundary and regime alone
/// @return             the response
/// @throws             DomainError at a pole of a mode without damping; PrecisionError where a maximum is not settled
[[nodiscard]] BoundedResponse bounded_response(const Scene<double>& scene, BoundedModes& modes, bool with_motion = true);

} // namespace denhartog
