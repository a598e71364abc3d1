#include "denhartog/solve/certain_modes.hpp"

#include <algorithm>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/sliding_point.hpp"

namespace denhartog {
namespace {

bool is_certain(const Bounded<double>& x) { return x.e <= tolerance_of(digits_by_default) * size_of_number(x.x); }

bool is_certain(const Complex<Bounded<double>>& z) { return is_certain(modulus(z)); }

// A mode shape has its digits beside its largest entry.
bool is_certain(const ModalBasis<Bounded<double>>& basis) {
    for (const auto& shape : basis.phi.colwise()) {
        Bounded<double> largest(0);
        for (const Bounded<double>& entry : shape) largest = larger(largest, {size_of_number(entry.x), entry.e});
        if (!is_certain(largest)) return false;
    }
    const auto each = [](const Bounded<double>& x) { return is_certain(x); };
    return std::ranges::all_of(basis.r_n, each) && std::ranges::all_of(basis.zeta, each);
}

bool more_digits_may_tell(const SceneSource& source) {
    return highest_precision(aim_of({}), number_of_masses(source->in_double().system)) != Precision::in_double;
}

} // namespace

std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    if (is_certain(*basis) || !more_digits_may_tell(source)) return basis;
    auto modes = std::make_shared<ModalBasis<Bounded<double>>>(in_double(*scene_with_modes<Real50>(source).basis));
    if (!basis->coupled()) modes->D.resize(0, 0); // what was rounded off the damping matrix alone couples them
    return modes;
}

std::vector<evaluation::ModeFunctions<Bounded<double>>>
certain_mode_functions(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    std::vector<evaluation::ModeFunctions<Bounded<double>>> functions =
        BoundedModes<double>(basis, as_input(*source->in_double().r)).all();
    const auto each = [](const auto& f) { return is_certain(f.v) && is_certain(f.u) && is_certain(f.g); };
    if (std::ranges::all_of(functions, each) || !more_digits_may_tell(source)) return functions;
    const SceneIn<Real50> in = scene_with_modes<Real50>(source);
    functions.clear();
    for (const auto& f : BoundedModes<Real50>(in.basis, as_input(*in.scene.r)).all())
        functions.push_back({{in_double(f.v.re), in_double(f.v.im)}, in_double(f.u), in_double(f.g)});
    return functions;
}

} // namespace denhartog
