#include "conformance/session/session.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <system_error>

#include "conformance/grade.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/parallel.hpp"

namespace denhartog::conformance {
namespace {

constexpr const char* greeting = "denhartog-conform 1";

std::string in_quotes(const std::string& text) { return "'" + legible(text) + "'"; }

Verdict trouble_of(Heard heard) {
    if (heard == Heard::timeout) return Verdict::timeout;
    return heard == Heard::stall ? Verdict::stall : Verdict::crash;
}

// What the processes of a conversation share; every member is touched under the lock alone.
struct Shared {
    std::mutex lock;
    std::size_t next = 0, done = 0, unasked = 0;
    std::string first_unasked;
    std::set<std::string> ends;
    std::size_t given_up = 0;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

class Worker {
public:
    Worker(const RunSettings& run_settings, std::span<const ProtocolQuestion* const> asked, Conversation& whole,
           Shared& among_all, const std::function<void(std::size_t)>& tell)
        : settings(run_settings), questions(asked), conversation(whole), shared(among_all), progress(tell) {}

    // Takes questions until there are none, or the program has broken too often in a row.
    void work(Partner first) {
        partner = std::move(first);
        int broken = 0;
        while (broken <= most_restarts && !interruption() && !is_late()) {
            const std::size_t n = take();
            if (n >= questions.size()) break;
            Exchange& exchange = conversation.exchanges[n];
            ask(*questions[n], exchange);
            broken = exchange.trouble ? broken + 1 : 0;
            const std::lock_guard<std::mutex> hold(shared.lock);
            progress(++shared.done);
        }
        if (partner.process) end();
        const std::lock_guard<std::mutex> hold(shared.lock);
        if (broken > most_restarts) ++shared.given_up;
    }

private:
    const RunSettings& settings;
    std::span<const ProtocolQuestion* const> questions;
    Conversation& conversation;
    Shared& shared;
    const std::function<void(std::size_t)>& progress;
    Partner partner;

    [[nodiscard]] bool is_late() const {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - shared.start;
        return settings.total_seconds > 0 && passed.count() >= settings.total_seconds;
    }

    std::size_t take() {
        const std::lock_guard<std::mutex> hold(shared.lock);
        return shared.next++;
    }

    void ask(const ProtocolQuestion& q, Exchange& exchange) {
        if (!partner.process) {
            try {
                partner = shake_hands(settings);
            } catch (const BrokenProgram& e) {
                exchange.trouble = Verdict::crash;
                exchange.told = std::string("it could not be started again: ") + e.what();
                return;
            }
        }
        const Reply reply = partner.process->ask(line_for(partner, q), settings.seconds);
        if (reply.heard == Heard::line) {
            exchange.answer = answer_in(partner, reply.line, q.id);
            return;
        }
        if (reply.heard == Heard::interrupted) {
            exchange.answer = Skipped{reply.told};
        } else {
            exchange.trouble = trouble_of(reply.heard);
            exchange.told = reply.told;
        }
        count_unasked();
        partner.process.reset();
    }

    void count_unasked() {
        const Unasked& unasked = partner.process->unasked();
        const std::lock_guard<std::mutex> hold(shared.lock);
        if (shared.unasked == 0) shared.first_unasked = unasked.first;
        shared.unasked += unasked.lines;
    }

    void end() {
        const std::string end = partner.process->finish(settings.seconds);
        count_unasked();
        const std::lock_guard<std::mutex> hold(shared.lock);
        if (!end.empty()) shared.ends.insert(end);
    }
};

void note_breaches(Conversation& conversation, const Shared& shared) {
    if (shared.unasked > 0)
        conversation.notes.push_back((shared.unasked == 1 ? "1 line" : std::to_string(shared.unasked) + " lines") +
                                     " written without being asked, the first " + in_quotes(shared.first_unasked));
    for (const std::string& end : shared.ends) conversation.notes.push_back("when there was nothing more to ask, " + end);
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
    if (reply.heard != Heard::line)
        throw BrokenProgram("the program did not answer the handshake: " + std::string(name(trouble_of(reply.heard))) + ", " +
                            reply.told);
    std::istringstream words(reply.line);
    std::string protocol, version, dialect;
    words >> protocol >> version >> dialect;
    std::getline(words >> std::ws, partner.name);
    while (!partner.name.empty() && partner.name.back() == '\r') partner.name.pop_back();
    partner.name = legible(partner.name);
    partner.plain = dialect == "plain";
    const std::string expected = "must answer the handshake with a line like '" + std::string(greeting) + " json NAME'";
    if (protocol != "denhartog-conform") throw BrokenProgram("the program " + expected + ", but wrote " + in_quotes(reply.line));
    if (version != "1")
        throw BrokenProgram("the program must speak version 1 of the protocol, but wrote " + in_quotes(reply.line));
    if (!partner.plain && dialect != "json")
        throw BrokenProgram("the program must name the dialect json or plain, but wrote " + in_quotes(reply.line));
    return partner;
}

std::string line_for(const Partner& partner, const ProtocolQuestion& q) {
    return partner.plain ? question_plain(q) : question_json(q).dump();
}

Answer answer_in(const Partner& partner, std::string_view line, std::string_view id) {
    return partner.plain ? answer_from_plain(line, id) : answer_from_json(line, id);
}

Conversation converse(const RunSettings& settings, std::span<const ProtocolQuestion* const> questions,
                      const std::function<void(std::size_t)>& progress) {
    const WithoutBrokenPipeSignal guard;
    Conversation conversation;
    conversation.exchanges.resize(questions.size());
    Partner first = shake_hands(settings);
    conversation.name = first.name;
    conversation.dialect = first.plain ? "plain" : "json";
    Shared shared;
    const std::size_t jobs = std::clamp<std::size_t>(settings.jobs, 1, std::max<std::size_t>(questions.size(), 1));
    parallel_for(jobs, static_cast<unsigned>(jobs), [&](std::size_t n) {
        Worker(settings, questions, conversation, shared, progress).work(n == 0 ? std::move(first) : Partner{});
        return true;
    });
    const auto has_trouble = [](const Exchange& exchange) { return exchange.trouble.has_value(); };
    conversation.broken =
        shared.given_up == jobs || std::all_of(conversation.exchanges.begin(), conversation.exchanges.end(), has_trouble);
    const std::size_t asked = std::min(shared.done, questions.size());
    const bool given_up = shared.given_up == jobs;
    const std::string reason = interruption() ? "the runner was interrupted"
                               : given_up     ? "the program broke " + std::to_string(most_restarts + 1) + " times in a row"
                                              : "the total time was over";
    if (!given_up && shared.next < questions.size())
        conversation.cut_short =
            reason + " after " + std::to_string(asked) + " of " + std::to_string(questions.size()) + " questions";
    for (std::size_t n = shared.next; n < questions.size(); ++n) conversation.exchanges[n].answer = Skipped{reason};
    note_breaches(conversation, shared);
    return conversation;
}

Judged judge(const Vector& v, const Exchange& exchange) {
    if (!exchange.trouble) return grade(v, exchange.answer);
    Judged judged;
    judged.vector = &v;
    judged.verdict = *exchange.trouble;
    judged.reason = exchange.told;
    return judged;
}

} // namespace denhartog::conformance
