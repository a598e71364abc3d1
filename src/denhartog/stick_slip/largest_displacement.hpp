/// @file
/// @brief Displacements of the masses over a stretch, with the bounds that `global_maximum` asks for.
#pragma once

#include <map>
#include <memory_resource>
#include <vector>

#include "denhartog/search/largest_in_double.hpp"
#include "denhartog/stick_slip/linear_motion.hpp"

namespace denhartog {

/// @brief Displacements over a stretch, remembered: the masses share their instants.
template <class T>
class Displacements {
public:
    /// @param motion  the stretch, started
    /// @param phi     mode shapes, mass by coordinate
    /// @param effort  what the evaluations spend
    Displacements(LinearMotion<T>& motion, const Matrix<T>& phi, Effort& effort)
        : motion_(motion), phi_(phi), effort_(effort), sizes_(phi.cwiseAbs()), norms_(phi.cols()) {
        const Column<T> F = column(motion_.F);
        growth_ = motion_.coupled() ? Column<T>(phi_.rowwise().norm() * F.norm()) : Column<T>(sizes_ * F.cwiseAbs());
    }

    /// @brief Adds what masses that are no coordinates have of a resting contact. @param carried a part for each, the last rows
    /// @param x_j  where the contact rests
    void carry(const std::vector<T>& carried, const T& x_j) {
        if (carried.empty()) return;
        carried_ = Column<T>::Zero(phi_.rows());
        for (std::size_t n = 0; n < carried.size(); ++n)
            carried_(phi_.rows() - static_cast<Eigen::Index>(carried.size() - n)) = carried[n] * x_j;
    }

    /// @brief The displacement of a mass. @param row the mass @param t time from the start of the stretch @return displacement
    [[nodiscard]] T of(Eigen::Index row, const T& t) { return at(t)(row, 0); }

    /// @brief What rounding makes of a displacement. @param row the mass @param t an instant @return some units of its terms
    [[nodiscard]] T noise(Eigen::Index row, const T& t) {
        motion_.differentiate_at(t);
        return 4 * std::numeric_limits<T>::epsilon() * sizes_.row(row).dot(column(motion_.q[0]).cwiseAbs());
    }

    /// @brief The size of the displacement of a mass. @param row the mass @return the curve; refers to this object
    [[nodiscard]] Curve<T> size_of(Eigen::Index row) {
        using std::abs;
        Curve<T> curve;
        curve.cost = 0; // the effort is spent where an instant is new
        curve.sample = [this, row](const T& t) {
            const Known x = at(t);
            return Sample<T>{abs(x(row, 0)), x(row, 1), x(row, 2)};
        };
        // The third derivative by its energy norm, or by a Taylor polynomial and the energy norm of the fifth.
        curve.rate = [this, row](const T& a, const T& b) {
            const Known x = at(a);
            const T h = b - a, growth = growth_(row) * h;
            return std::min(T(x(row, 5) + growth), T(abs(x(row, 3)) + h * (abs(x(row, 4)) + h * (x(row, 6) + growth) / 2)));
        };
        return curve;
    }

private:
    static constexpr Eigen::Index columns = 7;
    using Known = Eigen::Map<const Matrix<T>>;

    // Derivatives 0 to 4 of every mass, then what bounds the third and the fifth ahead, but for the growth.
    Known at(const T& t) {
        const auto place = known_.lower_bound(t);
        if (place != known_.end() && place->first == t) return {place->second.data(), phi_.rows(), columns};
        effort_.spend(motion_.cost() + static_cast<long>(phi_.size() / 16));
        motion_.differentiate_at(t);
        std::pmr::vector<T> numbers(static_cast<std::size_t>(phi_.rows() * columns), &memory_);
        Eigen::Map<Matrix<T>> x(numbers.data(), phi_.rows(), columns);
        for (int m = 0; m < 5; ++m) x.col(m).noalias() = phi_.lazyProduct(column(motion_.q[m]));
        if (carried_.size() > 0) x.col(0) += carried_;
        for (const int m : {2, 4}) {
            if (motion_.coupled()) {
                x.col(4 + m / 2) = phi_.rowwise().norm() * motion_.energy_norm(m);
                continue;
            }
            for (Eigen::Index i = 0; i < norms_.size(); ++i) norms_(i) = motion_.energy_norm(m, static_cast<std::size_t>(i));
            x.col(4 + m / 2).noalias() = sizes_.lazyProduct(norms_);
        }
        return {known_.emplace_hint(place, t, std::move(numbers))->second.data(), phi_.rows(), columns};
    }

    LinearMotion<T>& motion_;
    const Matrix<T>& phi_;
    Effort& effort_;
    Matrix<T> sizes_;
    Column<T> growth_;
    Column<T> carried_; // empty where no displacement has a part of the contact's
    Column<T> norms_;
    std::pmr::monotonic_buffer_resource memory_; // of what is known: an instant costs no allocation of its own
    std::pmr::map<T, std::pmr::vector<T>> known_{&memory_};
};

} // namespace denhartog
