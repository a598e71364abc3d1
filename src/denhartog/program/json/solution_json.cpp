// The answers of `response`, `boundary` and `solve` as JSON, and from that JSON as tables. Read `solution_json`; a member that
// means nothing in a regime, or was not asked for, is left out.
#include "denhartog/program/json/solution_json.hpp"

#include <algorithm>
#include <cmath>

namespace denhartog::program {
namespace {

std::string name(BindingCondition binding) {
    return binding == BindingCondition::velocity ? "54a" : binding == BindingCondition::static_friction ? "54b" : "54a and 54b";
}

// Of each friction ratio what `write` makes of it, by its key.
template <class Write>
Json limits_json(const Limits& b, const Write& write) {
    Json all{{"exact", write(b.exact)}, {"paper", write(b.paper)}, {"approximate", write(b.approximate)}};
    if (b.sticking) all["sticking"] = write(*b.sticking);
    return all;
}

Json limit_bounds_json(const Limits& b, const NumberWriter& write) {
    return limits_json(b, [&](const Certified& limit) { return write.bound_or_null(limit.error); });
}

Json method_json(const Method& m) {
    return {{"model", m.model}, {"precision", m.precision}, {"proved", m.proved}, {"why", in_words(m.why)}};
}

Json mass_json(std::size_t k, const SolvedMass& m, const NumberWriter& write) {
    Json all{{"mass", k + 1}};
    if (m.sliding) {
        all["x0"] = write(m.sliding->x0);
        all["v0"] = write(m.sliding->v0);
    }
    all["amplitude"] = write(m.amplitude);
    if (m.phase) all["phase"] = write(*m.phase);
    if (m.sliding) {
        all["amplitude_monoharmonic"] = write(m.sliding->amplitude_monoharmonic);
        if (m.phase) all["phase_monoharmonic"] = write(m.sliding->phase_monoharmonic);
    }
    all["error_bound"] = write.bound(error_of_displacements(m));
    if (m.phase) all["phase_error_bound"] = write.bound(m.phase->error);
    return all;
}

Json masses_json(const std::vector<SolvedMass>& masses, const std::optional<Mass>& only, const NumberWriter& write) {
    Json all = Json::array();
    for (std::size_t k = 0; k < masses.size(); ++k) all.push_back(mass_json(only ? only->index : k, masses[k], write));
    return all;
}

Json stops_json(const std::vector<SolvedStop>& stops, const NumberWriter& write) {
    Json all = Json::array();
    for (const SolvedStop& stop : stops)
        all.push_back({{"start", write(stop.start)},
                       {"end", write(stop.end)},
                       {"x", write(stop.x)},
                       {"start_error_bound", write.bound(stop.start.error)},
                       {"end_error_bound", write.bound(stop.end.error)},
                       {"error_bound", write.bound(stop.x.error)}});
    return all;
}

template <class T>
Json numbers_json(const std::vector<T>& numbers, const NumberWriter& write) {
    Json all = Json::array();
    for (const T& number : numbers) all.push_back(write(number));
    return all;
}

template <class State>
Json state_json(const State& state, const NumberWriter& write) {
    return {{"x", numbers_json(state.x, write)}, {"x_prime", numbers_json(state.x_prime, write)}};
}

Json interval_json(const RestInterval& interval, const NumberWriter& write) {
    Json all{{"from", write(interval.from)}, {"to", write(interval.to)}};
    all["error_bound"] = write.bound(std::max(interval.from.error, interval.to.error));
    if (interval.rests_at) all["rests_at"] = write(*interval.rests_at);
    return all;
}

void add_stability(Json& all, const Stability& stability, const NumberWriter& write) {
    all["stable"] = stability.stable;
    all["multipliers"] = numbers_json(stability.multipliers, write);
    Json bounds = Json::array();
    for (const Certified& each : stability.multipliers) bounds.push_back(write.bound_or_null(each.error));
    all["multiplier_error_bounds"] = std::move(bounds);
}

Json motion_json(const OtherMotion& motion, const std::optional<Mass>& only, const NumberWriter& write) {
    Json all{
        {"regime", denhartog::name(motion.regime)}, {"found", in_words(motion.found)}, {"from", state_json(motion.from, write)}};
    all["periods"] = motion.periods;
    all["symmetric"] = motion.symmetric;
    add_stability(all, motion.stability, write);
    all["masses"] = masses_json(motion.masses, only, write);
    if (motion.rest_interval) {
        all["rest_interval"] = interval_json(*motion.rest_interval, write);
        return all;
    }
    all["stops_per_period"] = motion.stops.size();
    all["stops"] = stops_json(motion.stops, write);
    all["start"] = state_json(motion.start, write);
    return all;
}

Json contact_json(const Solution& s, const NumberWriter& write) {
    Json all = contact_name(s);
    const bool known = contact_moves_apart(s) ? s.between.has_value() : !s.masses.empty() && (!s.only || s.only == s.contact);
    if (!known) return all;
    const SolvedMass& m = contact_moves_apart(s) ? *s.between : mass_of(s, s.contact);
    all["amplitude"] = write(m.amplitude);
    if (m.phase) all["phase"] = write(*m.phase);
    return all;
}

std::string masses_table(const Json& masses) {
    return aligned({"mass", "amplitude", "phase", "error bound", "of the phase"}, masses,
                   {"mass", "amplitude", "phase", "error_bound", "phase_error_bound"});
}

std::string rest_of_motion(const Json& a) {
    std::string text;
    if (a.contains("stops_per_period")) text += "stops per period: " + cell(a, "stops_per_period") + "\n";
    if (a.contains("stops") && !a.at("stops").empty())
        text += aligned({"stop from", "error bound", "to", "error bound", "at"}, a.at("stops"),
                        {"start", "start_error_bound", "end", "end_error_bound", "x"});
    if (a.contains("rest_interval")) {
        const Json& i = a.at("rest_interval");
        text += "the contact may rest from " + cell(i, "from") + " to " + cell(i, "to");
        text += (i.contains("rests_at") ? ", and rests at " + cell(i, "rests_at") : "") + "; amplitudes for rest at zero\n";
    }
    if (a.contains("stable"))
        text += std::string(a.at("stable").get<bool>() ? "stable" : "not certainly stable") + ", period " + cell(a, "periods") +
                (a.at("symmetric").get<bool>() ? ", symmetric\n" : ", not symmetric\n");
    return text;
}

} // namespace

Json response_json(const Solution& s, const NumberWriter& write) {
    Json all{{"regime", denhartog::name(s.regime.regime)}};
    for (const Regime other : s.regime.other) all["other_regimes"].push_back(denhartog::name(other));
    if (s.regime.on_boundary) all["on_boundary"] = true;
    if (s.regime.regime != Regime::continuous || !s.regime.other.empty() || s.regime.on_boundary)
        all["reason"] = in_words(s.regime.reason);
    all["r"] = write(s.r);
    all["beta"] = write(*s.beta);
    all["beta_lim"] = limits_json(*s.limits, write);
    all["beta_lim_error_bounds"] = limit_bounds_json(*s.limits, write);
    all["method"] = method_json(s.method);
    all["contact"] = contact_json(s, write);
    if (s.masses.empty()) return all;
    all["masses"] = masses_json(s.masses, s.only, write);
    all["stops_per_period"] = 0;
    return all;
}

Json boundary_json(const Solution& s, const NumberWriter& write) {
    Json all{{"r", write(s.r)},
             {"mu", write(s.mu)},
             {"beta_lim", limits_json(*s.limits, write)},
             {"beta_lim_error_bounds", limit_bounds_json(*s.limits, write)},
             {"binding_condition", name(s.limits->binding)},
             {"method", method_json(s.method)}};
    if (!s.limits->sticking)
        all["reason"] = "beta_lim.sticking is absent: the system resonates with the contact held, so that no friction holds it";
    return all;
}

Json solution_json(const Solution& s, const NumberWriter& write) {
    Json all{{"regime", denhartog::name(s.regime.regime)}};
    if (s.regime_by_56) all["regime_by_56"] = denhartog::name(*s.regime_by_56);
    for (const Regime other : s.regime.other) all["other_regimes"].push_back(denhartog::name(other));
    if (s.regime.on_boundary) all["on_boundary"] = true;
    all["reason"] = in_words(s.regime.reason);
    all["r"] = write(s.r);
    all["beta"] = write(*s.beta);
    Json limits = s.limits ? limits_json(*s.limits, write) : Json::object();
    if (s.slides_below) limits["at_least"] = write(*s.slides_below);
    Json bounds = s.limits ? limit_bounds_json(*s.limits, write) : Json::object();
    if (s.sticking_by_88) {
        limits["sticking_by_88"] = write(*s.sticking_by_88);
        bounds["sticking_by_88"] = write.bound_or_null(s.sticking_by_88->error);
    }
    all["beta_lim"] = limits;
    if (!bounds.empty()) all["beta_lim_error_bounds"] = bounds;
    all["method"] = method_json(s.method);
    all["unique"] = s.unique;
    all["unique_because"] = in_words(s.unique_because);
    if (!s.not_from_rest.empty()) {
        all["from_rest"] = "not known";
        all["from_rest_because"] = in_words(s.not_from_rest);
    }
    if (s.kept_mode)
        all["kept_mode"] = {{"mode", s.kept_mode->mode + 1},
                            {"contact_at_most", write(s.kept_mode->contact_at_most)},
                            {"error_bound", write.bound(s.kept_mode->contact_at_most.error)}};
    all["contact"] = contact_json(s, write);
    if (!s.masses.empty()) {
        all["masses"] = masses_json(s.masses, s.only, write);
        if (s.rest_interval) {
            all["rest_interval"] = interval_json(*s.rest_interval, write);
        } else {
            all["stops_per_period"] = s.stops.size();
            if (!s.stops.empty()) all["stops"] = stops_json(s.stops, write);
        }
        all["periods"] = s.periods;
        all["symmetric"] = s.symmetric;
        if (s.stability) add_stability(all, *s.stability, write);
        if (s.start) all["start"] = state_json(*s.start, write);
    }
    for (const OtherMotion& motion : s.motions) all["motions"].push_back(motion_json(motion, s.only, write));
    all["relative_error"] = write(s.relative_error);
    all["counters"] = {{"eigen_solves", s.work.eigen_solves},
                       {"mode_evaluations", s.work.mode_evaluations},
                       {"phases_propagated", s.work.phases_propagated}};
    return all;
}

std::string contact_in_words(const Json& contact) {
    if (contact.contains("mass")) return "contact: mass " + cell(contact, "mass");
    const bool between_two = contact.contains("between");
    const Json& w = contact.at(between_two ? "between" : "direction");
    std::string text = "contact: " + std::string(between_two ? "between masses " : "along the direction ");
    for (std::size_t k = 0; k < w.size(); ++k) text += (k == 0 ? "" : between_two ? " and " : ", ") + in_table(w[k]);
    if (contact.contains("amplitude"))
        text += (between_two ? ", which slide on each other by " : ", which slides by ") + cell(contact, "amplitude");
    return text + (contact.contains("phase") ? ", phase " + cell(contact, "phase") : "");
}

std::string method_in_words(const Json& m) {
    const bool proved = m.at("proved").get<bool>();
    return "method: " + m.at("model").get<std::string>() + (proved ? " by the " : " in ") + m.at("precision").get<std::string>() +
           (proved ? ", proved; " : "; ") + m.at("why").get<std::string>() + "\n";
}

std::string solution_table(const Json& a) {
    std::string text = "regime: " + a.at("regime").get<std::string>() + "\n" + a.at("reason").get<std::string>() + "\n";
    if (a.contains("regime_by_56")) text += "by (69) with (56) it is " + cell(a, "regime_by_56") + "\n";
    const Json& b = a.at("beta_lim");
    Rows rows{{"r", cell(a, "r")}, {"beta", cell(a, "beta")}};
    for (const auto& [key, name] : {std::pair{"exact", "beta_lim exact"},
                                    {"paper", "beta_lim paper (56)"},
                                    {"approximate", "beta_lim approximate (67)"},
                                    {"at_least", "beta_lim at least"},
                                    {"sticking", "permanent sticking from"},
                                    {"sticking_by_88", "permanent sticking by (88)"}})
        if (b.contains(key)) rows.push_back({name, cell(b, key)});
    text += aligned(rows);
    if (a.contains("masses"))
        text += masses_table(a.at("masses")) + contact_in_words(a.at("contact")) + units_in_words(a) + rest_of_motion(a);
    text +=
        std::string("unique: ") + (a.at("unique").get<bool>() ? "yes, " : "") + a.at("unique_because").get<std::string>() + "\n";
    if (a.contains("from_rest")) text += "from rest: not known, " + a.at("from_rest_because").get<std::string>() + "\n";
    text += method_in_words(a.at("method"));
    if (a.contains("motions"))
        for (const Json& motion : a.at("motions"))
            text += "motion: " + motion.at("regime").get<std::string>() + ", from: " + motion.at("found").get<std::string>() +
                    "\n" + masses_table(motion.at("masses")) + rest_of_motion(motion);
    return text + "\n";
}

} // namespace denhartog::program
