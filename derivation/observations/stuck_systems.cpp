#include "derivation/observations/stuck_systems.hpp"

#include <cmath>

#include "denhartog/number/errors.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {
namespace {

StuckSystem prepared(const std::string& name, bool of_the_paper, const System<double>& system) {
    ModalBasis<double> basis = modal_basis(system);
    StuckConfiguration stuck = stuck_configuration(system, basis);
    std::optional<StuckChain> chain = stuck_chain(system, stuck);
    return {name, of_the_paper, system, std::move(basis), std::move(stuck), std::move(chain)};
}

} // namespace

StuckSystem equal_chain(std::size_t N, std::size_t j, std::size_t l, double zeta) {
    std::string name =
        std::to_string(N) + "DOF j=" + std::to_string(j) + " l=" + std::to_string(l) + " zeta=" + std::to_string(zeta);
    name.erase(name.find_last_not_of('0') + 1);
    return prepared(name, false, denhartog::equal_chain<double>(N, j, l, std::vector<double>(N, zeta)));
}

const std::vector<StuckSystem>& stuck_systems() {
    static const std::vector<StuckSystem> all = [] {
        std::vector<StuckSystem> list;
        for (const NamedScene<double>& scene : paper_scenes<double>()) {
            const std::string name = scene.name.substr(0, scene.name.find(" r="));
            if (list.empty() || list.back().name != name) list.push_back(prepared(name, true, scene.scene.system));
        }
        struct Places {
            std::size_t N, j, l;
        };
        for (const Places& p : {Places{2, 2, 1}, {2, 1, 2}, {4, 3, 1}, {5, 1, 1}, {5, 3, 1}, {5, 3, 5}, {5, 5, 1}})
            for (const double zeta : {0.001, 0.01, 0.1}) list.push_back(equal_chain(p.N, p.j, p.l, zeta));
        return list;
    }();
    return all;
}

std::optional<StickingBoundary> sticking_at(const StuckSystem& s, double r) {
    try {
        return sticking_boundary(stuck_response(s.stuck, s.system.load, r), s.chain, 1.0);
    } catch (const DomainError&) {
        return std::nullopt;
    }
}

WorstOfSweep worst_over_r(const StuckSystem& s, const std::function<double(const StickingBoundary&)>& wrong) {
    WorstOfSweep worst;
    std::vector<double> sweep = s.stuck.r_n;
    for (int n = 1; n <= 600; ++n) sweep.push_back(n / 200.0);
    for (const double r : sweep) {
        const std::optional<StickingBoundary> b = sticking_at(s, r);
        if (!b) continue;
        const double ratio = wrong(*b) / b->exact;
        if (std::abs(ratio - 1) > worst.error) worst = {std::abs(ratio - 1), r, ratio};
    }
    return worst;
}

} // namespace denhartog::derivation
