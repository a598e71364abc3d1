// JSON text read with nothing silently repaired: the parser's events are checked one by one for a key given twice, a number
// beyond a double and nesting deeper than a scene's. Read `read_json` and `Builder`.
#include "denhartog/scene/json_document.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog {
namespace {

using nlohmann::json;

/// A scene is an object of arrays of arrays of numbers.
constexpr std::size_t deepest = 3;

/// Complaint of the parser, without its own positions.
std::string complaint(std::string_view message) {
    const std::size_t reason = message.find(" - ");
    if (reason == message.npos) return std::string(message);
    std::string_view rest = message.substr(reason + 3);
    rest = rest.substr(0, rest.find("; last read"));
    const std::size_t expected = rest.find("; expected");
    return std::string(rest.substr(0, expected)) + (expected == rest.npos ? "" : "," + std::string(rest.substr(expected + 1)));
}

/// Line and column of a position, both from 1.
std::string place_of(std::string_view text, std::size_t position, std::size_t first_line) {
    const std::string_view before = text.substr(0, position);
    const auto line = first_line + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t start = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - start + 1);
}

/// Builds the value from the parser's events and refuses what the parser lets pass.
class Builder : public nlohmann::json_sax<json> {
public:
    Builder(std::string_view text, std::size_t line) : text_(text), line_(line) {}

    json result;

    bool null() override { return put(nullptr); }
    bool boolean(bool x) override { return put(x); }
    bool number_integer(json::number_integer_t x) override { return put(x); }
    bool number_unsigned(json::number_unsigned_t x) override { return put(x); }
    bool number_float(json::number_float_t x, const std::string& raw) override {
        const std::string_view mantissa = std::string_view(raw).substr(0, raw.find_first_of("eE"));
        if (x == 0 && mantissa.find_first_of("123456789") != mantissa.npos) refuse_number(raw);
        return put(x);
    }
    bool string(std::string& x) override { return put(std::move(x)); }
    bool binary(json::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool key(std::string& k) override {
        keys_.back() = k;
        if (open_.back()->contains(k)) throw InputError(k, "must be given once", "given twice", pointer());
        return true;
    }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t position, const std::string& token, const json::exception& fault) override {
        if (fault.id == 406) refuse_number(token);
        throw InputError("scene", "must be JSON (" + complaint(fault.what()) + ")",
                         token.empty() ? "nothing" : "'" + legible(token, most_of_a_value) + "'",
                         place_of(text_, position > 0 ? position - 1 : 0, line_));
    }

private:
    std::string pointer() const {
        json::json_pointer place;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            if (open_[i]->is_object())
                place.push_back(keys_[i]);
            else
                place /= open_[i]->size() - (i + 1 < open_.size() ? 1 : 0);
        }
        return place.to_string();
    }
    std::string quantity() const { return open_.empty() || !open_.front()->is_object() ? "scene" : keys_.front(); }
    [[noreturn]] void refuse_number(const std::string& raw) const {
        throw InputError(quantity(), "must be a number that a double holds (or be given as text in quotes)",
                         legible(raw, most_of_a_value), pointer());
    }
    json* place(json&& value) {
        if (open_.empty()) return &(result = std::move(value));
        if (open_.back()->is_object()) return &((*open_.back())[keys_.back()] = std::move(value));
        open_.back()->push_back(std::move(value));
        return &open_.back()->back();
    }
    template <class X>
    bool put(X&& x) {
        place(json(std::forward<X>(x)));
        return true;
    }
    bool open(json&& empty) {
        if (open_.size() == deepest)
            throw InputError(quantity(), "must not be nested deeper than rows of numbers", "an array or object within a row",
                             pointer());
        open_.push_back(place(std::move(empty)));
        keys_.emplace_back();
        return true;
    }
    bool close() {
        open_.pop_back();
        keys_.pop_back();
        return true;
    }

    std::string_view text_;
    std::size_t line_;
    std::vector<json*> open_;
    std::vector<std::string> keys_;
};

} // namespace

std::optional<double> number_in(const nlohmann::json& value) {
    if (value.is_number()) return value.get<double>();
    double number = 0;
    if (!value.is_string() || number_from_text(value.get_ref<const std::string&>(), number) != NumberFault::none)
        return std::nullopt;
    return number;
}

void refuse_zero_byte(const std::string& quantity, std::string_view text, std::size_t line) {
    const std::size_t zero = text.find('\0');
    if (zero != text.npos) throw InputError(quantity, "must be text", "a zero byte", place_of(text, zero, line));
}

bool nested_too_deeply(std::string_view text) {
    constexpr int most = 16;
    int depth = 0;
    bool in_text = false;
    for (std::size_t n = 0; n < text.size(); ++n) {
        const char c = text[n];
        if (in_text && c == '\\') ++n;
        if (c == '"') in_text = !in_text;
        if (in_text) continue;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > most) return true;
    }
    return false;
}

json json_or_nothing(std::string_view text) {
    if (text.find('\0') != text.npos || nested_too_deeply(text)) return json(json::value_t::discarded);
    return json::parse(text, nullptr, false);
}

bool is_json(std::string_view text) { return text.find('\0') == text.npos && json::accept(text); }

std::string pointer_step(std::string_view key) { return (json::json_pointer() / std::string(key)).to_string(); }

json read_json(std::string_view text, std::size_t line) {
    refuse_zero_byte("scene", text, line);
    Builder builder(text, line);
    json::sax_parse(text, &builder);
    return std::move(builder.result);
}

} // namespace denhartog
