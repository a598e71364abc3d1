#include "denhartog/program/answer_json.hpp"

namespace denhartog::program {
namespace {

// A mass that does not move has no phase.
template <class T>
bool moves(const MassResponse<T>& m) {
    return m.amplitude > m.error_bound;
}

template <class T>
Json mass(std::size_t k, const MassResponse<T>& m, const NumberWriter& write) {
    Json all{{"mass", k + 1}, {"x0", write(m.x0)}, {"v0", write(m.v0)}, {"amplitude", write(m.amplitude)}};
    if (moves(m)) all["phase"] = write(m.phase);
    all["amplitude_monoharmonic"] = write(m.amplitude_monoharmonic);
    if (moves(m)) all["phase_monoharmonic"] = write(m.phase_monoharmonic);
    all["error_bound"] = write(m.error_bound);
    return all;
}

template <class T>
Json contact(const Response<T>& r, const NumberWriter& write) {
    Json all{{"mass", r.contact.index + 1}};
    if (!r.steady_state) return all;
    const MassResponse<T>& m = r.steady_state->masses[r.contact.index];
    all["amplitude"] = write(m.amplitude);
    if (moves(m)) all["phase"] = write(m.phase);
    return all;
}

std::string name(BindingCondition binding) {
    switch (binding) {
    case BindingCondition::velocity: return "54a";
    case BindingCondition::static_friction: return "54b";
    case BindingCondition::both: return "54a and 54b";
    }
    return {};
}

} // namespace

Json method_json(const Method& m) { return {{"model", m.model}, {"precision", m.precision}, {"why", m.why}}; }

Json response_json(const Answer& answer, const NumberWriter& write) {
    return std::visit(
        [&](const auto& r) {
            const RegimeAtPoint& point = *r.regime;
            Json all{{"regime", denhartog::name(point.regime)}};
            for (const Regime other : point.other) all["other_regimes"].push_back(denhartog::name(other));
            if (point.on_boundary) all["on_boundary"] = true;
            if (point.regime != Regime::continuous || !point.other.empty() || point.on_boundary) all["reason"] = point.reason;
            all["r"] = write(r.r);
            all["beta"] = write(*r.beta);
            all["beta_lim"] = limits_json(r.boundary, write);
            all["method"] = method_json(answer.method);
            all["contact"] = contact(r, write);
            if (!r.steady_state) return all;
            all["masses"] = Json::array();
            for (std::size_t k = 0; k < r.steady_state->masses.size(); ++k)
                all["masses"].push_back(mass(k, r.steady_state->masses[k], write));
            all["stops_per_period"] = 0;
            return all;
        },
        answer.response);
}

Json boundary_json(const Answer& answer, const NumberWriter& write) {
    return std::visit(
        [&](const auto& r) {
            Json all{{"r", write(r.r)},
                     {"mu", write(r.mu)},
                     {"beta_lim", limits_json(r.boundary, write)},
                     {"binding_condition", name(r.boundary.binding)},
                     {"method", method_json(answer.method)}};
            if (!r.boundary.sticking)
                all["reason"] =
                    "beta_lim.sticking is absent: the system resonates with the contact held, so that no friction holds it";
            return all;
        },
        answer.response);
}

} // namespace denhartog::program
