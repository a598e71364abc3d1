/// @file
/// @brief Samples that are drawn by their index: which worker asks, and in which order, does not matter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "denhartog/sweep/study/marginal.hpp"

namespace denhartog::sweep {

/// @brief How samples fill the unit cube.
enum class Sampling : std::uint8_t {
    sobol,          ///< Sobol's sequence, with Owen's nested scrambling by the seed
    latin_hypercube ///< every quantity has one sample in each of `count` equally likely parts
};

/// @brief Samples of the unit cube, each computed from its index alone.
///
/// Sobol: the direction numbers of Joe and Kuo, as Boost has them. A seed turns the nested halves of every axis by coins that
/// depend on the half, the axis and the seed, so that each block of 2^m samples from a multiple of 2^m keeps one sample in each
/// of 2^m parts. Latin hypercube: the part of sample n is a permutation of n, by a cipher of eight rounds over the smallest power
/// of four that is not below the number of samples, applied until it leads below that number.
class UnitSamples {
public:
    /// @param sampling    how the cube is filled
    /// @param count       number of samples, from 1 to 2^40
    /// @param seed        another seed gives other samples
    /// @param quantities  dimensions of the cube, at most 3667
    UnitSamples(Sampling sampling, std::uint64_t count, std::uint64_t seed, std::size_t quantities);

    /// @brief One coordinate of a sample. @param index the sample, from 0 @param quantity the coordinate, from 0
    /// @return a number in (0, 1), an odd multiple of 2^-53
    [[nodiscard]] double at(std::uint64_t index, std::size_t quantity) const;

private:
    Sampling sampling_;
    std::uint64_t count_, seed_;
    std::vector<std::vector<std::uint64_t>> directions_; // of Sobol's sequence: a list a quantity
};

} // namespace denhartog::sweep
