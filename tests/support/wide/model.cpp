// Modes and linear algebra in 50 and 100 digits.
#include "tests/support/multiprecision.hpp" // first: what follows takes its functions

#include "denhartog/model/bidiagonal_singular_values.cpp"
#include "denhartog/model/contact_and_load.cpp"
#include "denhartog/model/coupled_motion.cpp"
#include "denhartog/model/linear_algebra.cpp"
#include "denhartog/model/modal_basis.cpp"
#include "denhartog/model/modal_damping.cpp"
#include "denhartog/model/natural_modes.cpp"
#include "denhartog/model/stuck_configuration.cpp"

namespace denhartog {

template SingularValues<Real50> bidiagonal_singular_values(std::vector<Real50>, std::vector<Real50>);
template SingularValues<Real100> bidiagonal_singular_values(std::vector<Real100>, std::vector<Real100>);
template Matrix<Real50> mass_matrix(const System<Real50>&);
template Matrix<Real100> mass_matrix(const System<Real100>&);
template Matrix<Real50> stiffness_matrix(const System<Real50>&);
template Matrix<Real100> stiffness_matrix(const System<Real100>&);
template HeldMatrices<Real50> held_matrices(const System<Real50>&, const Contact&, const Matrix<Real50>&);
template HeldMatrices<Real100> held_matrices(const System<Real100>&, const Contact&, const Matrix<Real100>&);
template class CoupledMotion<Real50>;
template class CoupledMotion<Real100>;
template SymmetricEigenproblem<Real50> symmetric_eigenproblem(const Matrix<Real50>&);
template SymmetricEigenproblem<Real100> symmetric_eigenproblem(const Matrix<Real100>&);
template Matrix<Real50> divide_out(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> divide_out(const Matrix<Real100>&, const Matrix<Real100>&);
template Matrix<Real50> divided_by_transpose(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> divided_by_transpose(const Matrix<Real100>&, const Matrix<Real100>&);
template Matrix<Real50> product(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> product(const Matrix<Real100>&, const Matrix<Real100>&);
template Column<Real50> product(const Matrix<Real50>&, const Column<Real50>&);
template Column<Real50> product_of_sizes(const Matrix<Real50>&, const Column<Real50>&);
template Matrix<Real50> transpose_times(const Matrix<Real50>&, const Matrix<Real50>&);
template Column<Real100> product(const Matrix<Real100>&, const Column<Real100>&);
template Column<Real100> product_of_sizes(const Matrix<Real100>&, const Column<Real100>&);
template Matrix<Real100> transpose_times(const Matrix<Real100>&, const Matrix<Real100>&);
template Matrix<Real50> in_coordinates(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> in_coordinates(const Matrix<Real100>&, const Matrix<Real100>&);
template class LinearSystem<Real50>;
template class LinearSystem<Real100>;
template ModalBasis<Real50> modal_basis(const System<Real50>&);
template ModalBasis<Real100> modal_basis(const System<Real100>&);
template bool every_motion_is_damped(const ModalBasis<Real50>&);
template NonDimensionalMatrices<Real50> non_dimensional_matrices(const System<Real50>&, const ModalBasis<Real50>&, const Real50&);
template NonDimensionalMatrices<Real100> non_dimensional_matrices(const System<Real100>&, const ModalBasis<Real100>&,
                                                                  const Real100&);
template Matrix<Real50> rounding_between_modes(const Matrix<Real50>&, const Matrix<Real50>&, const NaturalModes<Real50>&,
                                               FrequencyErrors);
template bool couples_a_pair(const Matrix<Real50>&, const Matrix<Real50>&);
template Real50 largest_coupling(const Matrix<Real50>&, const Real50&);
template Matrix<Real100> rounding_between_modes(const Matrix<Real100>&, const Matrix<Real100>&, const NaturalModes<Real100>&,
                                                FrequencyErrors);
template bool couples_a_pair(const Matrix<Real100>&, const Matrix<Real100>&);
template Real100 largest_coupling(const Matrix<Real100>&, const Real100&);
template void turn_coinciding_modes(const Matrix<Real50>&, const Real50&, const std::vector<Real50>&, Matrix<Real50>&);
template void turn_coinciding_modes(const Matrix<Real100>&, const Real100&, const std::vector<Real100>&, Matrix<Real100>&);
template void set_modal_damping(const Matrix<Real50>&, const Matrix<Real50>&, const Matrix<Real50>&, double, FrequencyErrors,
                                ModalBasis<Real50>&);
template void set_modal_damping(const Matrix<Real100>&, const Matrix<Real100>&, const Matrix<Real100>&, double, FrequencyErrors,
                                ModalBasis<Real100>&);
template NaturalModes<Real50> chain_modes(const std::vector<Real50>&, const std::vector<Real50>&);
template NaturalModes<Real100> chain_modes(const std::vector<Real100>&, const std::vector<Real100>&);
template NaturalModes<Real50> general_modes(const Matrix<Real50>&, const Matrix<Real50>&);
template NaturalModes<Real100> general_modes(const Matrix<Real100>&, const Matrix<Real100>&);
template void fix_signs(Matrix<Real50>&);
template void fix_signs(Matrix<Real100>&);
template StuckConfiguration<Real50> stuck_configuration(const System<Real50>&, const ModalBasis<Real50>&,
                                                        const RoundedModes<Real50>*);
template StuckConfiguration<Real100> stuck_configuration(const System<Real100>&, const ModalBasis<Real100>&,
                                                         const RoundedModes<Real100>*);

} // namespace denhartog
