#include <vector>

#include "denhartog/number/number_text.hpp"
#include "denhartog/solve/find.hpp"

namespace denhartog {
namespace {

constexpr const char* rule = "must read `amplitude of mass K = VALUE`, `amplitude of mass K is largest` or `is least`, with "
                             "`largest` or `least` in front and `over KEY A:B` behind mass K if a second number varies";

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : std::string(text) + " ") {
        if (c != ' ' && c != '=') {
            word += c;
            continue;
        }
        if (!word.empty()) words.push_back(std::move(word));
        word.clear();
        if (c == '=') words.emplace_back("=");
    }
    return words;
}

std::optional<AmplitudeIs> extreme_named(const std::string& word) {
    if (word == "largest") return AmplitudeIs::largest;
    if (word == "least") return AmplitudeIs::least;
    return std::nullopt;
}

} // namespace

std::optional<VariedNumber> interval_from(std::string_view key, std::string_view ends) {
    VariedNumber varied{std::string(key)};
    const std::size_t colon = ends.find(':');
    const auto reads = [](std::string_view part, double& x) {
        return number_from_text(std::string(part), x) == NumberFault::none;
    };
    if (colon == std::string_view::npos || !reads(ends.substr(0, colon), varied.from) ||
        !reads(ends.substr(colon + 1), varied.to))
        return std::nullopt;
    return varied;
}

Wanted wanted_from(std::string_view text) {
    const std::vector<std::string> words = words_of(text);
    const InputError fault("so-that", rule, std::string(text));
    std::size_t n = 0;
    const auto next = [&] { return n < words.size() ? words[n] : std::string(); };
    const auto take = [&](std::string_view word) {
        if (next() != word) throw fault;
        ++n;
    };
    const auto number = [&](double& x) {
        if (number_from_text(next(), x) != NumberFault::none) throw fault;
        ++n;
    };
    Wanted wanted;
    const std::optional<AmplitudeIs> first = extreme_named(next());
    if (first) ++n;
    for (const char* word : {"amplitude", "of", "mass"}) take(word);
    double mass = 0;
    number(mass);
    if (!(mass >= 1 && mass <= 1e6) || mass != static_cast<double>(static_cast<std::size_t>(mass)))
        throw InputError("so-that", "must count masses from 1", std::string(text));
    wanted.mass.index = static_cast<std::size_t>(mass) - 1;
    if (next() == "over") {
        if (!first || n + 2 >= words.size()) throw fault;
        wanted.of = *first;
        wanted.over = interval_from(words[n + 1], words[n + 2]);
        if (!wanted.over) throw fault;
        n += 3;
    } else if (first) {
        throw fault;
    }
    if (next() == "=") {
        ++n;
        number(wanted.value);
        if (!(wanted.value >= 0)) throw InputError("so-that", "must not ask for a negative amplitude", std::string(text));
    } else {
        take("is");
        const std::optional<AmplitudeIs> is = extreme_named(next());
        if (!is) throw fault;
        wanted.is = *is;
        ++n;
    }
    if (n != words.size()) throw fault;
    return wanted;
}

} // namespace denhartog
