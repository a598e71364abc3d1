#include "conformance/session/session.hpp"

#include <string_view>

#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog::conformance {
namespace {

constexpr int samples = 8;

// Two masses that differ in everything; the contact slides throughout, but for the quantities of a contact that stops or rests.
ProtocolQuestion question_about(const Quantity& asked) {
    ProtocolQuestion q;
    q.id = "smoke-" + std::string(asked.name);
    for (char& c : q.id)
        if (c == '_') c = '-';
    q.quantity = asked.name;
    q.mass_ratios = {1, 2.5};
    q.stiffness_ratios = {1, 0.625};
    q.damping_ratios = {0.0625, 0.125};
    q.contact = 2;
    q.load = asked.name == "beta_lim_high_frequency" ? 2 : 1;
    q.mu = 1.25;
    q.r = 0.75;
    q.beta = asked.name == "rest_interval"                                         ? 8
             : asked.shape == Shape::durations || asked.name == "stops_per_period" ? 0.5
                                                                                   : 0.0625;
    q.mass = asked.of_mass ? 1 : 0;
    q.tau = asked.name == "displacement" ? 0.5 : 0;
    q.samples = asked.shape == Shape::samples ? samples : 0;
    return q;
}

std::string fault_of(const Quantity& asked, const ProtocolQuestion& q, const Value& value) {
    if (asked.shape == Shape::word) return value.word.empty() ? "must be the name of a regime" : "";
    if (!value.word.empty()) return "must be numbers, but is " + value.word;
    const std::size_t count = asked.shape == Shape::modes     ? q.mass_ratios.size()
                              : asked.shape == Shape::complex ? 2
                              : asked.shape == Shape::samples ? static_cast<std::size_t>(q.samples)
                                                              : 1;
    if (asked.shape == Shape::durations || value.numbers.size() == count) return "";
    return "must be as many numbers as the protocol has, " + std::to_string(count) + ", but is " +
           std::to_string(value.numbers.size());
}

SmokeCheck check_of(const Quantity& asked, const ProtocolQuestion& q, const Answer& answer) {
    const std::string what(asked.name);
    if (const auto* skipped = std::get_if<Skipped>(&answer)) return {what, "skipped: " + legible(skipped->reason), true};
    if (const auto* rejected = std::get_if<Rejected>(&answer))
        return {what, "rejected, but the question keeps all rules: " + legible(rejected->reason), false};
    if (const auto* unusable = std::get_if<Unusable>(&answer)) return {what, legible(unusable->reason), false};
    const auto& value = std::get<Value>(answer);
    const std::string fault = fault_of(asked, q, value);
    if (!fault.empty()) return {what, fault, false};
    std::string shown = value.word;
    for (const double x : value.numbers) shown += (shown.empty() ? "" : " ") + number_to_text(x);
    return {what, legible(shown), true};
}

// A question about a quantity that there is not: one that is known, with its name replaced in the line.
std::string line_about_nothing(const Partner& partner, const ProtocolQuestion& known) {
    std::string line = line_for(partner, known);
    const std::string quoted = partner.plain ? " H_j " : "\"H_j\"";
    const std::string other = partner.plain ? " no_such_quantity " : "\"no_such_quantity\"";
    return line.replace(line.find(quoted), quoted.size(), other);
}

class Smoking {
public:
    explicit Smoking(const RunSettings& run_settings) : settings(run_settings), partner(shake_hands(run_settings)) {
        found.name = partner.name;
        found.dialect = partner.plain ? "plain" : "json";
        found.checks.push_back({"handshake", found.dialect + ", " + found.name, true});
    }

    Smoke all() {
        for (const Quantity& asked : quantities())
            if (!look(asked)) return found;
        if (look_at_nothing() && look_at_negative_mass()) look_at_end();
        return found;
    }

private:
    const RunSettings& settings;
    Partner partner;
    Smoke found;

    std::optional<Answer> answer_to(const std::string& what, const std::string& line, const std::string& id) {
        const Reply reply = partner.process->ask(line, settings.seconds);
        if (reply.heard == Heard::line) return answer_in(partner, reply.line, id);
        found.broken = true;
        found.checks.push_back({what, reply.told, false});
        return std::nullopt;
    }

    bool look(const Quantity& asked) {
        const ProtocolQuestion q = question_about(asked);
        const std::optional<Answer> answer = answer_to(q.quantity, line_for(partner, q), q.id);
        if (answer) found.checks.push_back(check_of(asked, q, *answer));
        return answer.has_value();
    }

    bool look_at_nothing() {
        ProtocolQuestion q = question_about(quantity("H_j"));
        q.id = "smoke-unknown";
        const std::optional<Answer> answer = answer_to("unknown quantity", line_about_nothing(partner, q), q.id);
        if (!answer) return false;
        const bool skipped = std::holds_alternative<Skipped>(*answer);
        found.checks.push_back({"unknown quantity", skipped ? "skipped" : "must be skipped", skipped});
        return true;
    }

    bool look_at_negative_mass() {
        ProtocolQuestion q = question_about(quantity("H_j"));
        q.id = "smoke-rejected";
        q.mass_ratios.back() = -1;
        const std::optional<Answer> answer = answer_to("negative mass", line_for(partner, q), q.id);
        if (!answer) return false;
        const bool good = std::holds_alternative<Rejected>(*answer) || std::holds_alternative<Skipped>(*answer);
        found.checks.push_back({"negative mass", good ? "rejected or skipped" : "must be rejected", good});
        return true;
    }

    void look_at_end() {
        const std::string end = partner.process->finish(settings.seconds);
        found.checks.push_back({"end", end.empty() ? "status 0 when its standard input was closed" : end, end.empty()});
        const Unasked& unasked = partner.process->unasked();
        if (unasked.lines == 0) return;
        found.checks.push_back(
            {"nothing unasked", std::to_string(unasked.lines) + " lines, the first " + legible(unasked.first), false});
    }
};

} // namespace

Smoke smoke(const RunSettings& settings) {
    const WithoutBrokenPipeSignal guard;
    return Smoking(settings).all();
}

} // namespace denhartog::conformance
