/// @file
/// @brief The error of a response, measured against the same response in a wider number type.
#pragma once

#include "denhartog/solve/response.hpp"

namespace denhartog {

/// @brief What a comparison found.
template <class T>
struct MeasuredError {
    bool comparable = true;      ///< both responses are in the same regime
    T relative = T(0);           ///< largest error of what must have its digits: see `answer`
    BoundaryError<T> boundary{}; ///< absolute errors of the boundary
    std::vector<T> masses;       ///< absolute error of the displacements, N values; empty where nothing slides
};

/// @brief Compares a response with the same response in a wider number type, or in the same type from inputs that differ.
/// @param response  the response
/// @param wider     the other one
/// @param only      the one mass that counts; none for all
/// @return          twice the differences plus one unit in the last place of T; the whole amplitude where only one of them slides
template <class T, class Wide>
[[nodiscard]] MeasuredError<T> measured_error(const Response<T>& response, const Response<Wide>& wider,
                                              std::optional<Mass> only = std::nullopt);

/// @brief A response with its instants in a wider number type, for `response_at`; everything else is left out.
/// @param response  the response
/// @return          the instants
template <class Wide, class T>
[[nodiscard]] Response<Wide> instants_in(const Response<T>& response);

/// @brief Writes measured errors into a response: error bounds of the masses, and whether beta lies on a boundary.
/// @param response  the response
/// @param error     its errors
template <class T>
void set_error(Response<T>& response, const MeasuredError<T>& error);

} // namespace denhartog
