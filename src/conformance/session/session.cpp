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

// A conversation in the making, by several processes. What is not const is touched under the lock alone; the exchange of a
// question belongs to one of them.
class Talk {
public:
    Talk(const RunSettings& run_settings, std::span<const ProtocolQuestion* const> asked,
         const std::function<void(std::size_t)>& tell)
        : settings(run_settings), questions(asked), progress(tell) {
        conversation.exchanges.resize(questions.size());
    }

    // Takes questions until there are none, or the program has broken too often in a row.
    void work(Partner partner) {
        int broken = 0;
        while (broken <= most_restarts && !interruption() && !is_late()) {
            const std::size_t n = take();
            if (n >= questions.size()) break;
            Exchange& exchange = conversation.exchanges[n];
            ask(partner, *questions[n], exchange);
            broken = exchange.trouble ? broken + 1 : 0;
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
        conversation.broken = all_given_up || std::ranges::all_of(conversation.exchanges, [](const Exchange& exchange) {
                                  return exchange.trouble.has_value();
                              });
        const std::string reason = interruption() ? "the runner was interrupted"
                                   : all_given_up ? "the program broke " + std::to_string(most_restarts + 1) + " times in a row"
                                                  : "the total time was over";
        if (!all_given_up && next < questions.size())
            conversation.cut_short = reason + " after " + std::to_string(std::min(done, questions.size())) + " of " +
                                     std::to_string(questions.size()) + " questions";
        for (std::size_t n = next; n < questions.size(); ++n) conversation.exchanges[n].answer = Skipped{reason};
        if (unasked > 0)
            conversation.notes.push_back((unasked == 1 ? "1 line" : std::to_string(unasked) + " lines") +
                                         " written without being asked, the first " + in_quotes(first_unasked));
        for (const std::string& end : ends) conversation.notes.push_back("when there was nothing more to ask, " + end);
        return std::move(conversation);
    }

private:
    const RunSettings& settings;
    const std::span<const ProtocolQuestion* const> questions;
    const std::function<void(std::size_t)>& progress;
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    std::mutex lock;
    Conversation conversation;
    std::size_t next = 0, done = 0, unasked = 0, given_up = 0;
    std::string first_unasked;
    std::set<std::string> ends;

    [[nodiscard]] bool is_late() const {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        return settings.total_seconds > 0 && passed.count() >= settings.total_seconds;
    }

    std::size_t take() {
        const std::lock_guard<std::mutex> hold(lock);
        return next++;
    }

    void ask(Partner& partner, const ProtocolQuestion& q, Exchange& exchange) {
        try {
            if (!partner.process) partner = shake_hands(settings);
        } catch (const BrokenProgram& e) {
            exchange.trouble = Verdict::crash;
            exchange.told = std::string("it could not be started again: ") + e.what();
            return;
        }
        const Reply reply = partner.process->ask(line_for(partner, q), settings.seconds);
        if (!reply.trouble) {
            exchange.answer = answer_in(partner, reply.line, q.id);
            return;
        }
        if (reply.trouble == Verdict::skipped) {
            exchange.answer = Skipped{reply.told};
        } else {
            exchange.trouble = reply.trouble;
            exchange.told = reply.told;
        }
        count_unasked(partner);
        partner.process.reset();
    }

    void count_unasked(const Partner& partner) {
        const Unasked& of_one = partner.process->unasked();
        const std::lock_guard<std::mutex> hold(lock);
        if (unasked == 0) first_unasked = of_one.first;
        unasked += of_one.lines;
    }
};

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

Conversation converse(const RunSettings& settings, std::span<const ProtocolQuestion* const> questions,
                      const std::function<void(std::size_t)>& progress) {
    const WithoutBrokenPipeSignal guard;
    Partner first = shake_hands(settings);
    const std::string name = first.name, dialect = first.dialect;
    Talk talk(settings, questions, progress);
    const std::size_t jobs = std::clamp<std::size_t>(settings.jobs, 1, std::max<std::size_t>(questions.size(), 1));
    parallel_for(jobs, static_cast<unsigned>(jobs), [&](std::size_t n) {
        talk.work(n == 0 ? std::move(first) : Partner{});
        return true;
    });
    Conversation conversation = talk.all(jobs);
    conversation.name = name;
    conversation.dialect = dialect;
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
