#include "denhartog/sweep/study/study_items.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/other_documents.hpp"

namespace denhartog::sweep {
namespace {

using Words = std::span<const std::string_view>;

constexpr auto quantities = std::to_array<std::string_view>(
    {"r", "frequency_hz", "beta", "friction", "mu", "zeta", "mass", "stiffness", "contact", "load"});
constexpr auto methods = std::to_array<std::string_view>({"sobol", "latin_hypercube"});
constexpr auto distributions = std::to_array<std::string_view>({"uniform", "loguniform", "normal", "lognormal"});
constexpr auto statistics = std::to_array<std::string_view>({"share", "maximum", "minimum", "quantiles", "histogram"});
constexpr auto scales = std::to_array<std::string_view>({"linear", "logarithmic"});
constexpr auto ways = std::to_array<std::string_view>({"value", "factor"});

bool is_whole(VariedQuantity q) { return q == VariedQuantity::contact || q == VariedQuantity::load; }

std::string listed(Words words) {
    std::string text;
    for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

bool is_logarithmic(const Item& item) { return item.has("scale") && item["scale"].one_of(scales) == 1; }

// from, to and count, as an axis and bins have them.
Bins read_range(const Item& item, std::uint64_t least_count) {
    Bins range{item["from"].number(), item["to"].number(), 1, is_logarithmic(item)};
    range.count = item["count"].whole(least_count, most_values);
    if (range.logarithmic && !(range.from > 0)) item["from"].fail("must be positive where the scale is logarithmic");
    return range;
}

std::vector<double> read_values(const Item& item) {
    std::vector<double> values;
    if (item.has("values")) {
        for (const char* key : {"from", "to", "count", "scale"})
            if (item.has(key)) item[key].fail("must not be given together with values");
        for (const Item& each : item["values"].entries()) values.push_back(each.number());
        return values;
    }
    Bins range = read_range(item, 1);
    if (range.to < range.from) item["to"].fail("must not be below from");
    if (range.count == 1) {
        if (range.to != range.from) item["to"].fail("must be equal to from where count is 1");
        return {range.from};
    }
    --range.count; // so many parts have as many ends
    return range.edges();
}

Bins read_bins(const Item& item) {
    item.allow(std::to_array<std::string_view>({"from", "to", "count", "scale"}), "bins");
    const Bins bins = read_range(item, 1);
    if (!(bins.to > bins.from)) item["to"].fail("must be above from");
    return bins;
}

Marginal read_marginal(const Item& item) {
    std::optional<std::size_t> kind;
    for (std::size_t n = 0; n < distributions.size(); ++n) {
        if (!item.has(distributions[n].data())) continue;
        if (kind) item[distributions[n].data()].fail("must not be given together with " + std::string(distributions[*kind]));
        kind = n;
    }
    if (!kind) item.fail("must have a distribution: one of " + listed(distributions));
    const Item x = item[distributions[*kind].data()];
    Marginal marginal;
    marginal.distribution = static_cast<Distribution>(*kind);
    if (marginal.distribution == Distribution::uniform || marginal.distribution == Distribution::loguniform) {
        x.allow(std::to_array<std::string_view>({"from", "to"}), "a uniform distribution");
        marginal.first = marginal.distribution == Distribution::uniform ? x["from"].number() : x["from"].positive();
        marginal.second = x["to"].number();
        if (!(marginal.second > marginal.first)) x["to"].fail("must be above from");
        return marginal;
    }
    if (marginal.distribution == Distribution::normal) {
        x.allow(std::to_array<std::string_view>({"mean", "standard_deviation", "from", "to"}), "a normal distribution");
        marginal.first = x["mean"].number();
        marginal.second = x["standard_deviation"].positive();
    } else {
        x.allow(std::to_array<std::string_view>({"mean", "standard_deviation", "median", "log_standard_deviation", "from", "to"}),
                "a lognormal distribution");
        const char* const first = x.has("median") ? "median" : "mean";
        for (const char* other :
             {x.has("median") ? "mean" : "median", x.has("median") ? "standard_deviation" : "log_standard_deviation"})
            if (x.has(other)) x[other].fail(std::string("must not be given together with ") + first);
        if (x.has("median")) {
            marginal.first = x["median"].positive();
            marginal.second = x["log_standard_deviation"].positive();
        } else {
            marginal = lognormal_of_mean(x["mean"].positive(), x["standard_deviation"].positive());
        }
    }
    if (x.has("from"))
        marginal.from = marginal.distribution == Distribution::lognormal ? x["from"].positive() : x["from"].number();
    if (x.has("to")) marginal.to = x["to"].number();
    if (marginal.to &&
        !(*marginal.to > marginal.from.value_or(
                             marginal.distribution == Distribution::lognormal ? 0 : -std::numeric_limits<double>::infinity())))
        x["to"].fail("must be above from");
    return marginal;
}

} // namespace

std::string_view name_of(VariedQuantity q) { return quantities[static_cast<std::size_t>(q)]; }

Item::Item(const nlohmann::json& value, std::string key, std::string place)
    : value_(value), key_(std::move(key)), place_(std::move(place)) {}

void Item::fail(const std::string& rule) const {
    throw InputError(key_, rule, legible(value_.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace), most_of_a_value),
                     place_);
}

Item Item::operator[](const char* key) const {
    if (!value_.contains(key)) throw InputError(key, "must be given", "nothing", place_);
    return {value_.at(key), key, place_ + pointer_step(key)};
}

std::vector<Item> Item::entries() const {
    if (!value_.is_array() || value_.empty()) fail("must be an array with at least one entry");
    std::vector<Item> all;
    for (std::size_t n = 0; n < value_.size(); ++n) all.emplace_back(value_[n], key_, place_ + pointer_step(std::to_string(n)));
    return all;
}

void Item::allow(Words keys, const std::string& of) const {
    if (!value_.is_object()) fail("must be a JSON object");
    for (const auto& entry : value_.items())
        if (std::ranges::find(keys, entry.key()) == keys.end())
            throw InputError(entry.key(), rule_of_keys(of, entry.key(), keys), "", place_ + pointer_step(entry.key()));
}

std::size_t Item::one_of(Words words) const {
    const std::string word = value_.is_string() ? value_.get<std::string>() : "";
    const auto found = std::ranges::find(words, word);
    if (found == words.end()) fail("must be one of " + listed(words));
    return static_cast<std::size_t>(found - words.begin());
}

double Item::number() const {
    if (!value_.is_number()) fail("must be a number");
    return value_.get<double>();
}

double Item::positive() const {
    const double x = number();
    if (!(x > 0)) fail("must be positive");
    return x;
}

std::uint64_t Item::whole(std::uint64_t least, std::uint64_t most) const {
    const double x = value_.is_number() ? value_.get<double>() : -1;
    const bool fits = value_.is_number_unsigned() ? value_.get<std::uint64_t>() >= least && value_.get<std::uint64_t>() <= most
                                                  : x >= static_cast<double>(least) && x <= static_cast<double>(most);
    if (!fits || x != std::floor(x)) fail("must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return value_.is_number_unsigned() ? value_.get<std::uint64_t>() : static_cast<std::uint64_t>(x);
}

std::string Item::text() const {
    if (!value_.is_string()) fail("must be a text");
    return value_.get<std::string>();
}

Target read_target(const Item& item) {
    Target target;
    target.quantity = static_cast<VariedQuantity>(item["quantity"].one_of(quantities));
    const bool of_many = target.quantity == VariedQuantity::zeta || target.quantity == VariedQuantity::mass ||
                         target.quantity == VariedQuantity::stiffness;
    if (item.has("entry")) {
        if (!of_many) item["entry"].fail("must be given for zeta, mass and stiffness only");
        target.entry = item["entry"].whole(1, 1'000'000) - 1;
    }
    target.factor = item.has("as") && item["as"].one_of(ways) == 1;
    if (target.factor && is_whole(target.quantity)) item["as"].fail("must be value for contact and load");
    return target;
}

Axis read_axis(const Item& item) {
    item.allow(std::to_array<std::string_view>({"quantity", "entry", "as", "from", "to", "count", "scale", "values", "comment"}),
               "an axis");
    Axis axis{read_target(item), read_values(item)};
    for (const double each : axis.values)
        if (is_whole(axis.target.quantity) && !(each >= 1 && each == std::floor(each)))
            item.fail("must have whole numbers that count the masses from 1");
    return axis;
}

Samples read_samples(const Item& item) {
    item.allow(std::to_array<std::string_view>({"method", "count", "seed", "variables"}), "samples");
    Samples samples;
    samples.sampling = static_cast<Sampling>(item["method"].one_of(methods));
    samples.count = item["count"].whole(1, std::uint64_t(1) << 40);
    samples.seed = item["seed"].whole(0, std::uint64_t(1) << 53);
    for (const Item& each : item["variables"].entries()) {
        each.allow(std::to_array<std::string_view>(
                       {"quantity", "entry", "as", "uniform", "loguniform", "normal", "lognormal", "comment"}),
                   "a variable");
        samples.variables.push_back({read_target(each), read_marginal(each)});
        if (is_whole(samples.variables.back().target.quantity)) each["quantity"].fail("must be an axis, not a variable");
    }
    return samples;
}

Reduction read_reduction(const Item& item) {
    item.allow(std::to_array<std::string_view>({"name", "statistic", "of", "over", "probabilities", "bins"}), "a reduction");
    Reduction reduction;
    reduction.statistic = static_cast<Statistic>(item["statistic"].one_of(statistics));
    reduction.name = item["name"].text();
    const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    if (reduction.name.empty() || reduction.name.size() > 64 || reduction.name.find_first_not_of(letters) != std::string::npos)
        item["name"].fail("must have 1 to 64 letters, digits and underscores");
    for (const Item& each : item["over"].entries()) reduction.over.push_back(each.text());
    const bool quantiles = reduction.statistic == Statistic::quantiles, share = reduction.statistic == Statistic::share;
    const bool histogram = reduction.statistic == Statistic::histogram;
    if (share && item.has("of")) item["of"].fail("must not be given for the share of regimes");
    if (!share) reduction.of = item["of"].text();
    if (!quantiles && item.has("probabilities")) item["probabilities"].fail("must be given for quantiles only");
    if (quantiles)
        for (const Item& each : item["probabilities"].entries()) {
            reduction.probabilities.push_back(each.number());
            if (!(reduction.probabilities.back() >= 0 && reduction.probabilities.back() <= 1)) each.fail("must be from 0 to 1");
        }
    if (item.has("bins") && !quantiles && !histogram) item["bins"].fail("must be given for histograms and quantiles only");
    if (item.has("bins") || histogram) reduction.bins = read_bins(item["bins"]);
    return reduction;
}

} // namespace denhartog::sweep
