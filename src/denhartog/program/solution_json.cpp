#include "denhartog/program/solution_json.hpp"

#include "denhartog/program/answer_json.hpp"
#include "denhartog/program/table.hpp"

namespace denhartog::program {
namespace {

template <class T>
Json mass_json(std::size_t k, const SolvedMass<T>& m, const NumberWriter& write) {
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
    all["error_bound"] = write(m.error_bound);
    if (m.phase) all["phase_error_bound"] = write(m.phase_error);
    return all;
}

template <class T>
Json masses_json(const std::vector<SolvedMass<T>>& masses, const std::optional<Mass>& only, const NumberWriter& write) {
    Json all = Json::array();
    for (std::size_t k = 0; k < masses.size(); ++k) all.push_back(mass_json(only ? only->index : k, masses[k], write));
    return all;
}

template <class T>
Json stops_json(const std::vector<Stop<T>>& stops, const NumberWriter& write) {
    Json all = Json::array();
    for (const Stop<T>& stop : stops)
        all.push_back({{"start", write(stop.start)}, {"end", write(stop.end)}, {"x", write(stop.x)}});
    return all;
}

template <class T>
Json numbers_json(const std::vector<T>& numbers, const NumberWriter& write) {
    Json all = Json::array();
    for (const T& number : numbers) all.push_back(write(number));
    return all;
}

template <class T>
Json state_json(const State<T>& state, const NumberWriter& write) {
    return {{"x", numbers_json(state.x, write)}, {"x_prime", numbers_json(state.x_prime, write)}};
}

template <class T>
Json interval_json(const RestInterval<T>& interval, const NumberWriter& write) {
    Json all{{"from", write(interval.from)}, {"to", write(interval.to)}, {"error_bound", write(interval.error_bound)}};
    if (interval.rests_at) all["rests_at"] = write(*interval.rests_at);
    return all;
}

void add_stability(Json& all, const Stability& stability, const NumberWriter& write) {
    all["stable"] = stability.stable;
    all["multipliers"] = numbers_json(stability.multipliers, write);
}

Json motion_json(const OtherMotion& motion, const std::optional<Mass>& only, const NumberWriter& write) {
    Json all{{"regime", denhartog::name(motion.regime)}, {"found", motion.found}, {"from", state_json(motion.from, write)}};
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

template <class T>
Json contact_json(const Solved<T>& n, const NumberWriter& write) {
    Json all{{"mass", n.contact.index + 1}};
    if (n.masses.empty() || (n.only && n.only != n.contact)) return all;
    const SolvedMass<T>& m = n.only ? n.masses.front() : n.masses[n.contact.index];
    all["amplitude"] = write(m.amplitude);
    if (m.phase) all["phase"] = write(*m.phase);
    return all;
}

template <class T>
void add_numbers(Json& all, const Solution& s, const Solved<T>& n, const NumberWriter& write) {
    all["r"] = write(n.r);
    all["beta"] = write(n.beta);
    Json limits = n.boundary ? limits_json(*n.boundary, write) : Json::object();
    if (n.slides_below) limits["at_least"] = write(*n.slides_below);
    if (n.sticking_by_88) limits["sticking_by_88"] = write(*n.sticking_by_88);
    all["beta_lim"] = limits;
    all["method"] = method_json(s.method);
    all["unique"] = s.unique;
    all["unique_because"] = s.unique_because;
    all["contact"] = contact_json(n, write);
    if (n.masses.empty()) return;
    all["masses"] = masses_json(n.masses, n.only, write);
    if (n.rest_interval) {
        all["rest_interval"] = interval_json(*n.rest_interval, write);
    } else {
        all["stops_per_period"] = n.stops.size();
        if (!n.stops.empty()) all["stops"] = stops_json(n.stops, write);
    }
    all["periods"] = s.periods;
    all["symmetric"] = s.symmetric;
    if (s.stability) add_stability(all, *s.stability, write);
    if (n.start) all["start"] = state_json(*n.start, write);
}

std::string masses_table(const Json& masses) {
    const std::vector<const char*> keys{"mass", "amplitude", "phase", "error_bound", "phase_error_bound"};
    std::vector<std::vector<std::string>> rows{{"mass", "amplitude", "phase", "error bound", "of the phase"}};
    for (const Json& m : masses) {
        rows.emplace_back();
        for (const char* key : keys) rows.back().push_back(cell(m, key));
    }
    return aligned(rows);
}

std::string rest_of_motion(const Json& a) {
    std::string text;
    if (a.contains("stops_per_period")) text += "stops per period: " + cell(a, "stops_per_period") + "\n";
    if (a.contains("stops")) {
        std::vector<std::vector<std::string>> rows{{"stop from", "to", "at"}};
        for (const Json& stop : a.at("stops")) rows.push_back({cell(stop, "start"), cell(stop, "end"), cell(stop, "x")});
        if (rows.size() > 1) text += aligned(rows);
    }
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

Json solution_json(const Solution& s, const NumberWriter& write) {
    Json all{{"regime", denhartog::name(s.regime.regime)}};
    if (s.regime_by_56) all["regime_by_56"] = denhartog::name(*s.regime_by_56);
    for (const Regime other : s.regime.other) all["other_regimes"].push_back(denhartog::name(other));
    if (s.regime.on_boundary) all["on_boundary"] = true;
    all["reason"] = s.regime.reason;
    std::visit([&](const auto& numbers) { add_numbers(all, s, numbers, write); }, s.numbers);
    if (!s.motions.empty()) {
        all["motions"] = Json::array();
        const std::optional<Mass> only = std::visit([](const auto& numbers) { return numbers.only; }, s.numbers);
        for (const OtherMotion& motion : s.motions) all["motions"].push_back(motion_json(motion, only, write));
    }
    all["relative_error"] = write(s.relative_error);
    all["counters"] = {{"eigen_solves", s.work.eigen_solves},
                       {"mode_evaluations", s.work.mode_evaluations},
                       {"phases_propagated", s.work.phases_propagated}};
    return all;
}

std::string solution_table(const Json& a) {
    std::string text = "regime: " + a.at("regime").get<std::string>() + "\n" + a.at("reason").get<std::string>() + "\n";
    if (a.contains("regime_by_56")) text += "by (69) with (56) it is " + cell(a, "regime_by_56") + "\n";
    const Json& b = a.at("beta_lim");
    std::vector<std::vector<std::string>> rows{{"r", cell(a, "r")}, {"beta", cell(a, "beta")}};
    for (const auto& [key, name] : {std::pair{"exact", "beta_lim exact"},
                                    {"paper", "beta_lim paper (56)"},
                                    {"approximate", "beta_lim approximate (67)"},
                                    {"at_least", "beta_lim at least"},
                                    {"sticking", "permanent sticking from"},
                                    {"sticking_by_88", "permanent sticking by (88)"}})
        if (b.contains(key)) rows.push_back({name, cell(b, key)});
    text += aligned(rows);
    if (a.contains("masses"))
        text += masses_table(a.at("masses")) + "contact: mass " + cell(a.at("contact"), "mass") +
                "; displacements in units of P / k_1, phases in radians behind the force\n" + rest_of_motion(a);
    text +=
        std::string("unique: ") + (a.at("unique").get<bool>() ? "yes, " : "") + a.at("unique_because").get<std::string>() + "\n";
    const Json& m = a.at("method");
    text += "method: " + m.at("model").get<std::string>() + " in " + m.at("precision").get<std::string>() + "; " +
            m.at("why").get<std::string>() + "\n";
    if (a.contains("motions"))
        for (const Json& motion : a.at("motions"))
            text += "motion: " + motion.at("regime").get<std::string>() + ", from: " + motion.at("found").get<std::string>() +
                    "\n" + masses_table(motion.at("masses")) + rest_of_motion(motion);
    return text + "\n";
}

} // namespace denhartog::program
