/// @file
/// @brief The distributions of sampled quantities, by their inverses; the same double on every machine.
///
/// Logarithm, exponential and error function are those of MPFR, rounded once to double: the system's own differ from processor to
/// processor in their last digit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace denhartog::sweep {

/// @brief A kind of distribution.
enum class Distribution : std::uint8_t {
    uniform,    ///< equally likely between two bounds
    loguniform, ///< its logarithm is equally likely between those of two bounds
    normal,     ///< Gaussian
    lognormal   ///< its logarithm is Gaussian
};

/// @brief The distribution of one quantity.
struct Marginal {
    Distribution distribution = Distribution::uniform; ///< its kind
    double first = 0;                                  ///< lower bound; mean; median of a lognormal
    double second = 1;                                 ///< upper bound; standard deviation, of a lognormal that of its logarithm
    std::optional<double> from{};                      ///< where a normal or lognormal is cut off below
    std::optional<double> to{};                        ///< where it is cut off above
};

/// @brief A lognormal by its mean and standard deviation. @param mean its mean @param deviation its standard deviation
/// @return the same by its median and the standard deviation of its logarithm
[[nodiscard]] Marginal lognormal_of_mean(double mean, double deviation);

/// @brief The standard normal distribution. @param x a number @return \f$ \Phi(x) \f$, rounded once
[[nodiscard]] double normal_probability(double x);

/// @brief Its inverse. @param u a probability in (0, 1) @return x with \f$ \Phi(x) = u \f$, rounded once
[[nodiscard]] double normal_quantile(double u);

/// @brief A quantity from a number in (0, 1) that is equally likely anywhere there.
/// @param marginal  its distribution
/// @param u         the number
/// @return          the quantity below which the distribution has the probability u, after it was cut off
[[nodiscard]] double quantile(const Marginal& marginal, double u);

/// @brief Values equally spaced in their logarithms. @param from the first, positive @param to the last @param count how many
/// @return the values, both ends as they are given
[[nodiscard]] std::vector<double> logarithmic_values(double from, double to, std::size_t count);

} // namespace denhartog::sweep
