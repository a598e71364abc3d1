#include "denhartog/solve/certain_modes.hpp"

#include <algorithm>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/sliding_point.hpp"

namespace denhartog {
namespace {

// A mode shape has its digits beside its largest entry.
double relative_error(const ModalBasis<Bounded<double>>& basis) {
    double largest = 0;
    const auto take = [&](const Bounded<double>& x) { largest = std::max(largest, relative_error(x)); };
    for (const auto& shape : basis.phi.colwise()) {
        Bounded<double> of_shape(0);
        for (const Bounded<double>& entry : shape) of_shape = larger(of_shape, {size_of_number(entry.x), entry.e});
        take(of_shape);
    }
    std::ranges::for_each(basis.r_n, take);
    std::ranges::for_each(basis.zeta, take);
    return largest;
}

using ModeFunctionsInDouble = std::vector<evaluation::ModeFunctions<Bounded<double>>>;

double relative_error(const ModeFunctionsInDouble& functions) {
    double largest = 0;
    for (const auto& f : functions)
        largest = std::max({largest, relative_error(modulus(f.v)), relative_error(f.u), relative_error(f.g)});
    return largest;
}

// Double, then 50 digits, as `certify` has it, for an attempt that hands out what it found in double.
template <class Attempt>
void in_double_or_50_digits(const SceneSource& source, const Attempt& attempt) {
    const Aim aim = aim_of({});
    certify(
        aim, [&](auto type) { return Attempted{relative_error(attempt(type))}; },
        highest_precision(aim, number_of_masses(source->in_double().system), Precision::in_50_digits));
}

} // namespace

std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    auto modes = basis;
    in_double_or_50_digits(source, [&]<class T>(std::type_identity<T>) -> const ModalBasis<Bounded<double>>& {
        if constexpr (!std::same_as<T, double>) {
            auto wide = std::make_shared<ModalBasis<Bounded<double>>>(in_double(*scene_with_modes<T>(source).basis));
            if (!basis->coupled()) wide->D.resize(0, 0); // what was rounded off the damping matrix alone couples them
            modes = std::move(wide);
        }
        return *modes;
    });
    return modes;
}

ModeFunctionsInDouble certain_mode_functions(const SceneSource& source,
                                             const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    ModeFunctionsInDouble functions;
    in_double_or_50_digits(source, [&]<class T>(std::type_identity<T>) -> const ModeFunctionsInDouble& {
        if constexpr (std::same_as<T, double>)
            return functions = BoundedModes<double>(basis, as_input(*source->in_double().r)).all();
        const SceneIn<T> in = scene_with_modes<T>(source);
        functions.clear();
        for (const auto& f : BoundedModes<T>(in.basis, as_input(*in.scene.r)).all())
            functions.push_back({{in_double(f.v.re), in_double(f.v.im)}, in_double(f.u), in_double(f.g)});
        return functions;
    });
    return functions;
}

} // namespace denhartog
