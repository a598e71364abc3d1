#include "derivation/observations/refutation_scene.hpp"

#include <cmath>
#include <stdexcept>

#include "denhartog/model/modal_basis.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace denhartog::derivation {

using nlohmann::json;

namespace {

std::string regime_of(const Boundary<double>& limit, double beta) {
    if (beta < limit.exact) return "continuous";
    return limit.sticking && beta >= *limit.sticking ? "permanent_sticking" : "stick_slip";
}

/// The reason why no scene shows a slip of the scan: the meaning is beyond doubt, and everybody codes that.
const std::string slip_of_the_scan =
    "the slip is that of the scan, and the sentences around it correct it; the printed paper is not at fault, and no reader "
    "would code it";

} // namespace

json solved(const RefutationScene& s) {
    ModalBasis<double> basis = modal_basis(s.system);
    ModeSums<double> sums = mode_sums(basis, s.system.contact, s.system.load, s.r);
    Boundary<double> limit = boundary(sums, s.mu);
    const std::string regime = regime_of(limit, s.beta);
    if ((regime == "continuous") != s.slides)
        throw std::logic_error("the scene for (" + s.equation + ") is in the regime " + regime + "; its limit is " +
                               std::to_string(limit.exact));
    SteadyState<double> state;
    if (s.slides) state = steady_state(sums, limit, s.beta);
    const SlidingScene at{s.where, false, s.mu, s.system, std::move(basis), std::move(sums), std::move(limit), std::move(state)};
    const Compared c = s.compared(at);
    const nlohmann::ordered_json written = write_scene(Scene<double>{s.system, s.mu, s.r, s.beta, {}, {}});
    return {{"where", s.where},
            {"scene", written.dump()},
            {"regime", regime},
            {"quantity", c.quantity},
            {"printed", c.printed},
            {"holds", c.holds},
            {"loss", std::abs(c.printed - c.holds) / c.size}};
}

json scenes_of_refutations() {
    json all = json::object();
    for (const auto& list : {scenes_of_motions(), scenes_of_boundaries()})
        for (const RefutationScene& scene : list) all[scene.equation] = solved(scene);
    for (const char* equation : {"2", "4", "5", "16", "A.12"}) all[equation] = {{"none", slip_of_the_scan}};
    return all;
}

} // namespace denhartog::derivation
