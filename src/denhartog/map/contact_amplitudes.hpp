/// @file
/// @brief (38) over an array of friction ratios at one frequency ratio: a friction ratio costs a root.
#pragma once

#include <span>

#include "denhartog/formulas/complex.hpp"

namespace denhartog {

/// @brief `evaluation::displacement_transmissibility_of_contact` over an array of friction ratios, with the same digits.
/// @eq{38}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param G_j   second damping function of the mass in contact, Eq. (35)
/// @param beta  friction ratios, Eq. (11)
/// @param X_j   where the amplitudes go; as long as beta
void contact_amplitudes(const Complex<double>& V_dj, double U_dj, double G_j, std::span<const double> beta,
                        std::span<double> X_j);

} // namespace denhartog
