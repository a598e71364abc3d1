// A conversation with a program under test: several processes answer the questions side by side, and one that breaks is started
// again a few times. Read `converse` first, then `Talk::work`.
#include "conformance/session/session.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>

#include "conformance/verdict.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/parallel.hpp"

namespace denhartog::conformance {
namespace {

constexpr const char* greeting = "denhartog-conform 1";

std::string in_quotes(const std::string& text) { return "'" + legible(text) + "'"; }

// A conversation in the making, by several processes. What is neither const nor atomic is touched under the lock alone; the
// verdict on an answer belongs to one of them.
class Talk {
public:
    Talk(const RunSettings& run_settings, std::span<const Vector* const> asked, const std::function<void(std::size_t)>& tell)
        : settings(run_settings), vectors(asked), progress(tell) {
        for (const Vector* v : vectors) conversation.judged.push_back(grade(*v, Skipped{}));
    }

    // Takes questions until there are none, or the program has broken too often in a row.
    void work(Partner partner) {
        int broken = 0;
        while (broken <= most_restarts && !interruption() && !is_late()) {
            const std::size_t n = next++;
            if (n >= vectors.size()) break;
            conversation.judged[n] = judge(*vectors[n], partner, reply_of(partner, *vectors[n]));
            broken = is_broken(conversation.judged[n].verdict) ? broken + 1 : 0;
            const std::lock_guard<std::mutex> hold(lock);
            progress(++done);
        }
        const std::string end = partner.process ? partner.process->finish(settings.seconds) : "";
        if (partner.process) count_unasked(partner);
        const std::lock_guard<std::mutex> hold(lock);
        if (!end.empty()) ends.insert(end);
        if (broken > most_restarts) ++given_up;
    }

    // Results of the run, when `jobs` processes have worked.
    Conversation all(std::size_t jobs) {
        const bool all_given_up = given_up == jobs;
        conversation.broken =
            all_given_up || std::ranges::all_of(conversation.judged, [](const Judged& one) { return is_broken(one.verdict); });
        const std::string reason = interruption() ? "the runner was interrupted"
                                   : all_given_up ? "the program broke " + std::to_string(most_restarts + 1) + " times in a row"
                                                  : "the total time was over";
        if (!all_given_up && next < vectors.size())
            conversation.cut_short =
                reason + " after " + std::to_string(done) + " of " + std::to_string(vectors.size()) + " questions";
        for (std::size_t n = next; n < vectors.size(); ++n) conversation.judged[n] = grade(*vectors[n], Skipped{reason});
        if (unasked > 0)
            conversation.notes.push_back((unasked == 1 ? "1 line" : std::to_string(unasked) + " lines") +
                                         " written without being asked, the first " + in_quotes(first_unasked));
        for (const std::string& end : ends) conversation.notes.push_back("when there was nothing more to ask, " + end);
        return std::move(conversation);
    }

private:
    const RunSettings& settings;
    const std::span<const Vector* const> vectors;
    const std::function<void(std::size_t)>& progress;
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    std::mutex lock;
    Conversation conversation;
    std::atomic<std::size_t> next{0};
    std::size_t done = 0, unasked = 0, given_up = 0;
    std::string first_unasked;
    std::set<std::string> ends;

    [[nodiscard]] bool is_late() const {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        return settings.total_seconds > 0 && passed.count() >= settings.total_seconds;
    }

    // Starts the program again if it broke before.
    Reply reply_of(Partner& partner, const Vector& v) {
        try {
            if (!partner.process) partner = shake_hands(settings);
        } catch (const BrokenProgram& e) {
            return {"", Verdict::crash, std::string("it could not be started again: ") + e.what()};
        }
        Reply reply = partner.process->ask(line_for(partner, v.question), settings.seconds);
        if (reply.trouble) {
            count_unasked(partner);
            partner.process.reset();
        }
        return reply;
    }

    void count_unasked(const Partner& partner) {
        const Unasked& of_one = partner.process->unasked();
        const std::lock_guard<std::mutex> hold(lock);
        if (unasked == 0) first_unasked = of_one.first;
        unasked += of_one.lines;
    }
};

constexpr int samples = 8;

// Two masses that differ in everything; the contact slides throughout, but for the quantities of a contact that stops or rests.
ProtocolQuestion question_about(const Quantity& asked) {
    const bool stops = asked.shape == Shape::durations || asked.name == "stops_per_period";
    ProtocolQuestion q{.id = "smoke-" + std::string(asked.name),
                       .quantity = std::string(asked.name),
                       .mass_ratios = {1, 2.5},
                       .stiffness_ratios = {1, 0.625},
                       .damping_ratios = {0.0625, 0.125},
                       .contact = 2,
                       .mu = 1.25,
                       .r = 0.75};
    std::ranges::replace(q.id, '_', '-');
    q.load = asked.name == "beta_lim_high_frequency" ? 2 : 1;
    q.beta = asked.name == "rest_interval" ? 8 : stops ? 0.5 : 0.0625;
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
    if (const std::string fault = fault_of(asked, q, value); !fault.empty()) return {what, fault, false};
    return {what, legible(value.word.empty() ? joined(value.numbers) : value.word), true};
}

// A question about a quantity that there is not: one that is known, with its name replaced in the line.
std::string line_about_nothing(const Partner& partner, const ProtocolQuestion& known) {
    const std::string line = line_for(partner, known), name = known.quantity;
    const std::size_t place = line.find(partner.dialect == "plain" ? " " + name + " " : "\"" + name + "\"") + 1;
    return std::string(line).replace(place, name.size(), "no_such_quantity");
}

} // namespace

Partner shake_hands(const RunSettings& settings) {
    Partner partner;
    try {
        partner.process = std::make_unique<Process>(settings.command);
    } catch (const std::system_error& e) {
        throw BrokenProgram("the program cannot be started: " + legible(settings.command.front()) + " (" + e.code().message() +
                            ")");
    }
    const Reply reply = partner.process->ask(greeting, patience_at_start * settings.seconds);
    if (reply.trouble)
        throw BrokenProgram("the program did not answer the handshake: " +
                            std::string(name(reply.trouble == Verdict::skipped ? Verdict::crash : *reply.trouble)) + ", " +
                            reply.told);
    std::istringstream words(reply.line);
    std::string protocol, version;
    words >> protocol >> version >> partner.dialect;
    std::getline(words >> std::ws, partner.name);
    while (!partner.name.empty() && partner.name.back() == '\r') partner.name.pop_back();
    partner.name = legible(partner.name);
    const std::string expected = "must answer the handshake with a line like '" + std::string(greeting) + " json NAME'";
    if (protocol != "denhartog-conform") throw BrokenProgram("the program " + expected + ", but wrote " + in_quotes(reply.line));
    if (version != "1")
        throw BrokenProgram("the program must speak version 1 of the protocol, but wrote " + in_quotes(reply.line));
    if (partner.dialect != "plain" && partner.dialect != "json")
        throw BrokenProgram("the program must name the dialect json or plain, but wrote " + in_quotes(reply.line));
    return partner;
}

std::string line_for(const Partner& partner, const ProtocolQuestion& q) {
    return partner.dialect == "plain" ? question_plain(q) : question_json(q).dump();
}

Answer answer_in(const Partner& partner, std::string_view line, std::string_view id) {
    return partner.dialect == "plain" ? answer_from_plain(line, id) : answer_from_json(line, id);
}

Conversation converse(const RunSettings& settings, std::span<const Vector* const> vectors,
                      const std::function<void(std::size_t)>& progress) {
    const WithoutBrokenPipeSignal guard;
    Partner first = shake_hands(settings);
    const std::string name = first.name, dialect = first.dialect;
    Talk talk(settings, vectors, progress);
    const std::size_t jobs =
        std::clamp<std::size_t>(static_cast<unsigned>(settings.jobs), 1, std::max<std::size_t>(vectors.size(), 1));
    parallel_for(jobs, static_cast<unsigned>(jobs), [&](std::size_t n) {
        talk.work(n == 0 ? std::move(first) : Partner{});
        return true;
    });
    Conversation conversation = talk.all(jobs);
    conversation.name = name;
    conversation.dialect = dialect;
    return conversation;
}

Judged judge(const Vector& v, const Partner& partner, const Reply& reply) {
    if (!reply.trouble) return grade(v, answer_in(partner, reply.line, v.question.id));
    Judged judged = grade(v, Skipped{});
    judged.verdict = *reply.trouble;
    judged.reason = reply.told;
    return judged;
}

Smoke smoke(const RunSettings& settings) {
    const WithoutBrokenPipeSignal guard;
    const Partner partner = shake_hands(settings);
    Smoke found{{{"handshake", partner.dialect + ", " + partner.name, true}}};
    const auto look = [&](const std::string& what, const std::string& line, const std::string& id, const auto& check) {
        if (found.broken) return;
        const Reply reply = partner.process->ask(line, settings.seconds);
        found.broken = reply.trouble.has_value();
        found.checks.push_back(found.broken ? SmokeCheck{what, reply.told, false} : check(answer_in(partner, reply.line, id)));
    };
    for (const Quantity& asked : quantities()) {
        if (asked.absolute) continue; // of systems beyond the paper
        const ProtocolQuestion q = question_about(asked);
        look(q.quantity, line_for(partner, q), q.id, [&](const Answer& answer) { return check_of(asked, q, answer); });
    }
    ProtocolQuestion q = question_about(quantity("H_j"));
    q.id = "smoke-unknown";
    look("unknown quantity", line_about_nothing(partner, q), q.id, [](const Answer& answer) {
        const bool good = std::holds_alternative<Skipped>(answer);
        return SmokeCheck{"unknown quantity", good ? "skipped" : "must be skipped", good};
    });
    q.id = "smoke-rejected";
    q.mass_ratios.back() = -1;
    look("negative mass", line_for(partner, q), q.id, [](const Answer& answer) {
        const bool good = std::holds_alternative<Rejected>(answer) || std::holds_alternative<Skipped>(answer);
        return SmokeCheck{"negative mass", good ? "rejected or skipped" : "must be rejected", good,
                          std::holds_alternative<Value>(answer)};
    });
    if (found.broken) return found;
    const std::string end = partner.process->finish(settings.seconds);
    found.checks.push_back({"end", end.empty() ? "status 0 when its standard input was closed" : end, end.empty()});
    const Unasked& unasked = partner.process->unasked();
    if (unasked.lines > 0)
        found.checks.push_back(
            {"nothing unasked", std::to_string(unasked.lines) + " lines, the first " + legible(unasked.first), false});
    return found;
}

} // namespace denhartog::conformance
