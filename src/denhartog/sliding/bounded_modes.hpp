/// @file
/// @brief The modal basis in double with bounds of its errors, and the functions of its modes.
///
/// Two qualities. `with_errors` puts bounds on a basis found in double, from what the eigen-solvers are trusted with: an error of
/// each natural frequency of 8 N eps of itself on a chain, of its square of 8 N eps of the highest square else; of a mode shape
/// 8 N eps over the relative distance of its frequency from the next one. It costs no eigen-solve. `sharp_basis` solves the
/// eigenproblem in long double and rounds: where that type has more digits than double, what is left is the rounding of every
/// number by itself, which is known, and 3 N eps of long double in place of 8 N eps.
#pragma once

#include <memory>
#include <optional>

#include "denhartog/number/bounded.hpp"
#include "denhartog/sliding/mode_sums.hpp"

namespace denhartog {

/// @brief How far the numbers of a scene in double may be trusted.
enum class Inputs {
    exact,  ///< they are what is meant, to the last bit
    rounded ///< each is one unit in the last place uncertain, as a decimal fraction or a quotient is
};

/// @brief A number of the input. @param x a number @param inputs how far to trust it @return the number with its error
[[nodiscard]] Bounded as_input(double x, Inputs inputs = Inputs::rounded);

/// @brief A number of the input in long double, one unit in the last place of that uncertain.
/// @param x  the number
/// @return   its double, with what that lacks
[[nodiscard]] Bounded as_input(long double x);

/// @brief A modal basis found in double with bounds of its errors, inputs taken as rounded.
/// @param system  the system, damping given by ratios
/// @param basis   its basis in double
/// @return        the basis with errors
[[nodiscard]] ModalBasis<Bounded> with_errors(const System<double>& system, const ModalBasis<double>& basis);

/// @brief The modal basis solved in long double and rounded to double, with bounds of its errors: one eigen-solve.
/// @eq{14,15}
/// @param system  the system, damping given by ratios
/// @param inputs  how far to trust its numbers
/// @return        the basis with errors
/// @throws        as `modal_basis`
[[nodiscard]] ModalBasis<Bounded> sharp_basis(const System<double>& system, Inputs inputs);

/// @brief The same two with the shapes at a few masses alone, see `modal_basis_at`; inputs taken as rounded.
/// @param system  the system, damping given by ratios
/// @param masses  the masses wanted
/// @return        frequencies and damping ratios with errors; shapes with a row a mass wanted, solved in double
[[nodiscard]] ModalBasis<Bounded> basis_with_errors_at(const System<double>& system, const std::vector<Mass>& masses);

/// @brief The same of a system in long double, solved there: inputs are off by units of long double alone.
/// @param system  the system, damping given by ratios
/// @param masses  the masses wanted
/// @return        the basis with errors
[[nodiscard]] ModalBasis<Bounded> sharp_basis_at(const System<long double>& system, const std::vector<Mass>& masses);

/// @brief Modes and sums without their bounds. @param sums modes and sums with bounds @return their values
[[nodiscard]] ModeSums<double> values_of(const ModeSums<Bounded>& sums);

/// @brief The modes of a scene at its frequency ratio, each evaluated with its error when it is first needed.
class BoundedModes {
public:
    /// @param scene  the scene, with r, damping given by ratios; inputs taken as rounded
    /// @param basis  its modal basis
    BoundedModes(const Scene<double>& scene, const ModalBasis<double>& basis);
    /// @param basis  a modal basis with errors
    /// @param r      frequency ratio with its error
    BoundedModes(ModalBasis<Bounded> basis, const Bounded& r);
    /// @param basis  a modal basis with errors, shared with others
    /// @param r      frequency ratio with its error
    BoundedModes(std::shared_ptr<const ModalBasis<Bounded>> basis, const Bounded& r);

    /// @brief The modal basis. @return frequencies, shapes, damping ratios with their errors
    [[nodiscard]] const ModalBasis<Bounded>& basis() const { return *basis_; }
    /// @brief The frequency ratio. @return r with its error
    [[nodiscard]] const Bounded& r() const { return r_; }
    /// @brief A mode. @param i its index @return (23), (28), (29) @throws DomainError at a pole
    const evaluation::ModeFunctions<Bounded>& at(std::size_t i);
    /// @brief All modes. @return (23), (28), (29) of each @throws DomainError at a pole
    std::vector<evaluation::ModeFunctions<Bounded>> all();

private:
    std::shared_ptr<const ModalBasis<Bounded>> basis_;
    Bounded r_;
    std::vector<std::optional<evaluation::ModeFunctions<Bounded>>> known_;
};

} // namespace denhartog
