#include "tests/benchmark/generator/pack.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "tests/conformance/generator/number_digits.hpp"
#include "tests/support/sha256.hpp"

namespace denhartog::benchmark {
namespace {

// 17 significant digits, zeros at their end left out. What is below the accuracy of both routes is zero.
std::string digits_17(const Real50& x) { return abs(x) < no_motion ? "0" : conformance::generator::text_of_digits(x, 17); }

std::string exact(double x) { return nlohmann::json(x).dump(); }

std::string in_figures(double x, const char* format) {
    char text[32];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

template <class Each, class Text>
std::string joined(const std::vector<Each>& all, const char* between, const Text& text) {
    std::string line;
    for (const Each& each : all) line += (line.empty() ? "" : between) + std::string(text(each));
    return line;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }
std::string list(const std::string& text) { return "[" + text + "]"; }

const char* word(const Event& e) {
    if (e.after == 0) return "stops";
    return e.before == 0 ? (e.after > 0 ? "breaks away up" : "breaks away down") : e.after > 0 ? "turns up" : "turns down";
}

// Instants are those of the paper over omega, velocities those of the paper times omega.
Real50 seconds(const CertifiedScene& s, const Real50& tau) { return tau / s.scene.omega; }

std::string of_mass(const CertifiedScene& s, std::size_t k, bool velocity, const char* between) {
    return joined(s.motion.samples, between, [&](const Sample& state) {
        return digits_17(velocity ? Real50(state.x_prime[k] * s.scene.omega) : state.x[k]);
    });
}

std::string phase_of(const std::optional<Real50>& phase, const char* none) { return phase ? digits_17(*phase) : none; }

int stops_of(const CertifiedScene& s) {
    int count = s.motion.rests ? 1 : 0;
    for (const Event& e : s.motion.events) count += e.after == 0 ? 1 : 0;
    return count;
}

std::string settles_of(const CertifiedScene& s, std::size_t n, const char* none) {
    return n < s.settles.size() && s.settles[n] > 0 ? std::to_string(s.settles[n]) : none;
}

std::string scenes_csv(const std::vector<CertifiedScene>& scenes) {
    std::string text = "scene,masses,m,k,c,c_ground,contact,load,P,omega,F,F_static,regime,stops,F_slides_below,F_rests_from,"
                       "amplitude,phase,settles_1e-3,settles_1e-6,settles_1e-9,settles_1e-12,difficulty,exposes,digits\n";
    for (const CertifiedScene& s : scenes) {
        const PackScene& d = s.scene;
        const auto numbers = [](const std::vector<double>& x) { return joined(x, " ", exact); };
        text += d.id + "," + std::to_string(d.m.size()) + "," + numbers(d.m) + "," + numbers(d.k) + "," + numbers(d.c) + "," +
                numbers(d.c_ground) + "," + std::to_string(d.contact) + "," + std::to_string(d.load) + ",1," + exact(d.omega) +
                "," + exact(d.F) + "," + exact(d.F_static) + "," + s.regime + "," + std::to_string(stops_of(s)) + "," +
                digits_17(s.onsets.sliding) + "," + digits_17(s.onsets.sticking) + "," +
                joined(s.motion.amplitude, " ", digits_17) + "," +
                joined(s.motion.phase, " ", [](const auto& phase) { return phase_of(phase, "none"); });
        for (std::size_t n = 0; n < s.settles.size(); ++n) text += "," + settles_of(s, n, "");
        text += "," + s.difficulty + "," + joined(s.exposes, "; ", [](const std::string& x) { return x; }) + "," +
                std::to_string(s.digits) + "\n";
    }
    return text;
}

std::string events_csv(const std::vector<CertifiedScene>& scenes) {
    std::string text = "scene,event,t,what,x\n";
    for (const CertifiedScene& s : scenes)
        for (std::size_t n = 0; n < s.motion.events.size(); ++n) {
            const Event& e = s.motion.events[n];
            text += s.scene.id + "," + std::to_string(n + 1) + "," + digits_17(seconds(s, e.tau)) + "," + word(e) + "," +
                    digits_17(e.x) + "\n";
        }
    return text;
}

std::string samples_csv(const std::vector<CertifiedScene>& scenes) {
    std::string text = "scene,mass,x,v\n";
    for (const CertifiedScene& s : scenes)
        for (std::size_t k = 0; k < s.scene.m.size(); ++k)
            text += s.scene.id + "," + std::to_string(k + 1) + "," + of_mass(s, k, false, " ") + "," + of_mass(s, k, true, " ") +
                    "\n";
    return text;
}

std::string manifest(const std::vector<CertifiedScene>& scenes, const std::map<std::string, std::string>& files) {
    nlohmann::ordered_json m{{"name", "forced oscillators with one dry-friction contact"},
                             {"licence", "CC0-1.0"},
                             {"format", format_version},
                             {"content", content_version},
                             {"scenes", scenes.size()},
                             {"instants", instants},
                             {"units", "SI: kg, N, m, s, rad; m_1 = 1 kg, k_1 = 1 N/m, P = 1 N"}};
    m["equations"] = {
        "m_i x_i'' + c_ground_i x_i' + c_i (x_i' - x_(i-1)') - c_(i+1) (x_(i+1)' - x_i') + k_i (x_i - x_(i-1)) - "
        "k_(i+1) (x_(i+1) - x_i) = p_i + f_i, where x_0 = 0 and k_(N+1) = c_(N+1) = 0",
        "p_i = P cos(omega t) where i is load, else 0",
        "f_i = -F sign(x_i') where i is contact and x_i' is not 0; while x_i' = 0, f_i is what keeps it at 0, of size at most "
        "F_static; else f_i = 0",
        "x_i = x_i' = 0 at t = 0; the motion given is the one that this start leads to; its t = 0 is a maximum of the force"};
    m["bound"] =
        "every number is correctly rounded to 17 significant digits: its error is at most half a unit of the last of them";
    m["rules"] = {
        {"creep", "the contact rests for more than a quarter of the period"},
        {"missed event",
         "a rest or a slide is shorter than 1/32 of the period, or there are more than four of them, or nothing moves in a rest"},
        {"trapped event", "F is within 1/1000 of the friction that parts two regimes"},
        {"transient", "from rest more than 50 periods to 1e-6 of the settled motion"},
        {"static friction", "F_static is above F"},
        {"hard", "F within 1/1000 of a boundary, or a rest or slide below 1/128 of the period, or more than 400 periods to 1e-6"},
        {"easy", "F not within 1/64 of a boundary, none below 1/32, at most 50 periods, F_static = F"},
        {"medium", "else"}};
    for (const char* of : {"difficulty", "regime"}) {
        std::map<std::string, int> counts;
        for (const CertifiedScene& s : scenes) ++counts[std::string(of) == "regime" ? s.regime : s.difficulty];
        m[of] = counts;
    }
    std::map<std::string, int> exposed;
    for (const CertifiedScene& s : scenes)
        for (const std::string& x : s.exposes) ++exposed[x];
    m["exposes"] = exposed;
    for (const auto& [name, bytes] : files)
        m["files"].push_back({{"name", name}, {"bytes", bytes.size()}, {"sha256", denhartog::tests::sha256(bytes)}});
    return m.dump(1) + "\n";
}

} // namespace

std::string json_of(const CertifiedScene& s) {
    const PackScene& d = s.scene;
    const auto numbers = [](const std::vector<double>& x) { return list(joined(x, ",", exact)); };
    std::string text = "{";
    const auto member = [&](const char* name, const std::string& value) {
        text += (text.size() > 1 ? ",\n  " : "") + quoted(name) + ": " + value;
    };
    member("scene", quoted(d.id));
    member("m", numbers(d.m));
    member("k", numbers(d.k));
    member("c", numbers(d.c));
    member("c_ground", numbers(d.c_ground));
    member("contact", std::to_string(d.contact));
    member("load", std::to_string(d.load));
    member("P", "1");
    member("omega", exact(d.omega));
    member("F", exact(d.F));
    member("F_static", exact(d.F_static));
    member("regime", quoted(s.regime));
    member("stops", std::to_string(stops_of(s)));
    member("F_slides_below", digits_17(s.onsets.sliding));
    member("F_rests_from", digits_17(s.onsets.sticking));
    member("amplitude", list(joined(s.motion.amplitude, ",", digits_17)));
    member("phase", list(joined(s.motion.phase, ",", [](const auto& phase) { return phase_of(phase, "null"); })));
    std::string settles;
    for (std::size_t n = 0; n < settling_tolerances().size(); ++n)
        settles += (n > 0 ? "," : "") + quoted(in_figures(settling_tolerances()[n], "%.0e")) + ":" + settles_of(s, n, "null");
    member("periods_to_settle", "{" + settles + "}");
    member("difficulty", quoted(s.difficulty));
    member("exposes", list(joined(s.exposes, ",", quoted)));
    member("digits_of_both_routes", std::to_string(s.digits));
    member("events", list(joined(s.motion.events, ",\n    ", [&](const Event& e) {
               return "{\"t\":" + digits_17(seconds(s, e.tau)) + ",\"what\":" + quoted(word(e)) + ",\"x\":" + digits_17(e.x) +
                      "}";
           })));
    for (const bool velocity : {false, true}) {
        std::string rows;
        for (std::size_t k = 0; k < d.m.size(); ++k) rows += (k > 0 ? ",\n    " : "") + list(of_mass(s, k, velocity, ","));
        member(velocity ? "v" : "x", list(rows));
    }
    return text + "}";
}

std::map<std::string, std::string> files_of(const std::vector<CertifiedScene>& scenes) {
    std::map<std::string, std::string> files;
    files["scenes.json"] = "[" + joined(scenes, ",\n", json_of) + "]\n";
    files["scenes.csv"] = scenes_csv(scenes);
    files["events.csv"] = events_csv(scenes);
    files["samples.csv"] = samples_csv(scenes);
    std::string last = manifest(scenes, files);
    files["manifest.json"] = std::move(last);
    return files;
}

} // namespace denhartog::benchmark
