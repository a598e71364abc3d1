#include "denhartog/sweep/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "denhartog/number/errors.hpp"

namespace denhartog::sweep {
namespace {

constexpr std::size_t classes = 4; // three regimes, and none

bool is_extreme(const Reduction& r) { return r.statistic == Statistic::maximum || r.statistic == Statistic::minimum; }

bool is_exact_quantiles(const Reduction& r) { return r.statistic == Statistic::quantiles && !r.bins; }

std::size_t values_of_a_cell(const Reduction& r) {
    if (is_exact_quantiles(r)) return r.probabilities.size();
    return is_extreme(r) ? 1 : 0;
}

std::size_t counts_of_a_cell(const Reduction& r) {
    if (r.statistic == Statistic::share) return classes;
    if (r.bins) return r.bins->count + 2; // and what is below, and above
    return is_extreme(r) ? 1 : 0;
}

bool is_better(const Reduction& r, double x, double than) { return r.statistic == Statistic::maximum ? x > than : x < than; }

// How far a step along each axis of a field leads among the cells that are left, and among the places over the reduced axes.
struct Steps {
    std::vector<std::size_t> count, cell, place;
    std::size_t cells = 1, first_place = 0;
};

bool is_over(const Plan& plan, const Reduction& r, std::size_t d) {
    return std::ranges::find(r.over, plan.dimensions[d].name) != r.over.end();
}

Steps steps_of(const Plan& plan, const Reduction& r, const Box& box, const std::vector<std::size_t>& dimensions) {
    Steps s;
    const std::size_t n = dimensions.size();
    s.count.resize(n);
    s.cell.assign(n, 0);
    s.place.assign(n, 0);
    std::size_t places = 1;
    for (std::size_t m = n; m-- > 0;) {
        const std::size_t d = dimensions[m];
        s.count[m] = box.count[d];
        if (is_over(plan, r, d)) {
            s.place[m] = places;
            s.first_place += places * box.start[d];
            places *= plan.dimensions[d].size;
        } else {
            s.cell[m] = s.cells;
            s.cells *= box.count[d];
        }
    }
    return s;
}

// Tells each value of a field with its cell and its place.
template <class Take>
void walk(const Field& field, const Steps& s, const Take& take) {
    std::vector<std::size_t> at(s.count.size(), 0);
    std::size_t cell = 0, place = s.first_place;
    for (const double x : field.values) {
        take(x, cell, place);
        for (std::size_t m = at.size(); m-- > 0;) {
            cell += s.cell[m];
            place += s.place[m];
            if (++at[m] < s.count[m]) break;
            cell -= s.cell[m] * s.count[m];
            place -= s.place[m] * s.count[m];
            at[m] = 0;
        }
    }
}

double quantile_of_sorted(const std::vector<double>& sorted, double probability) {
    if (sorted.empty()) return std::nan("");
    const double position = probability * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

// From counts below, in each bin, and above; not a number where it lies outside of the bins.
double quantile_of_counts(const std::vector<double>& edges, const std::int64_t* counts, double probability) {
    std::int64_t all = 0;
    for (std::size_t n = 0; n <= edges.size(); ++n) all += counts[n];
    if (all == 0) return std::nan("");
    const double wanted = probability * static_cast<double>(all);
    double before = static_cast<double>(counts[0]);
    if (wanted < before) return std::nan("");
    for (std::size_t n = 0; n + 1 < edges.size(); ++n) {
        const auto here = static_cast<double>(counts[n + 1]);
        if (here > 0 && wanted <= before + here) return edges[n] + (wanted - before) / here * (edges[n + 1] - edges[n]);
        before += here;
    }
    return std::nan("");
}

} // namespace

Partial reduced(const Plan& plan, const Reduction& r, const Box& box, const Field& field) {
    const Steps s = steps_of(plan, r, box, field.dimensions);
    Partial part;
    for (const std::size_t d : field.dimensions)
        if (!is_over(plan, r, d)) part.dimensions.push_back(d);
    part.cells = s.cells;
    part.values.assign(s.cells * values_of_a_cell(r), std::nan(""));
    part.counts.assign(s.cells * counts_of_a_cell(r), is_extreme(r) ? -1 : 0);
    if (is_extreme(r)) {
        walk(field, s, [&](double x, std::size_t cell, std::size_t place) {
            if (std::isnan(x) || (part.counts[cell] >= 0 && !is_better(r, x, part.values[cell]))) return;
            part.values[cell] = x;
            part.counts[cell] = static_cast<std::int64_t>(place);
        });
    } else if (r.statistic == Statistic::share) {
        walk(field, s, [&](double x, std::size_t cell, std::size_t) {
            ++part.counts[cell * classes + (std::isnan(x) ? classes - 1 : static_cast<std::size_t>(x))];
        });
    } else if (r.bins) {
        const std::vector<double> edges = r.bins->edges();
        walk(field, s, [&](double x, std::size_t cell, std::size_t) {
            if (std::isnan(x)) return;
            const bool last = x == edges.back(); // the last bin holds its upper end
            const auto bin = last ? edges.end() - 1 : std::ranges::upper_bound(edges, x);
            ++part.counts[cell * counts_of_a_cell(r) + static_cast<std::size_t>(bin - edges.begin())];
        });
    } else {
        std::vector<std::vector<double>> of_cell(s.cells);
        walk(field, s, [&](double x, std::size_t cell, std::size_t) {
            if (!std::isnan(x)) of_cell[cell].push_back(x);
        });
        for (std::size_t cell = 0; cell < s.cells; ++cell) {
            std::ranges::sort(of_cell[cell]);
            for (std::size_t n = 0; n < r.probabilities.size(); ++n)
                part.values[cell * r.probabilities.size() + n] = quantile_of_sorted(of_cell[cell], r.probabilities[n]);
        }
    }
    return part;
}

void put_together(const Reduction& r, Partial& all, const Partial& part) {
    if (!is_extreme(r)) {
        for (std::size_t n = 0; n < all.counts.size(); ++n) all.counts[n] += part.counts[n];
        return;
    }
    for (std::size_t cell = 0; cell < all.cells; ++cell) {
        const bool there = part.counts[cell] >= 0, none_yet = all.counts[cell] < 0;
        const bool earlier = part.values[cell] == all.values[cell] && part.counts[cell] < all.counts[cell];
        if (!there || !(none_yet || earlier || is_better(r, part.values[cell], all.values[cell]))) continue;
        all.values[cell] = part.values[cell];
        all.counts[cell] = part.counts[cell];
    }
}

std::string to_bytes(const Partial& part) {
    std::string bytes(8 * (part.values.size() + part.counts.size()), '\0');
    std::memcpy(bytes.data(), part.values.data(), 8 * part.values.size());
    std::memcpy(bytes.data() + 8 * part.values.size(), part.counts.data(), 8 * part.counts.size());
    return bytes;
}

Partial from_bytes(const Plan& plan, const Reduction& r, const Box& box, const std::string& bytes) {
    Partial part;
    part.dimensions = plan.dimensions_of(r.name);
    for (const std::size_t d : part.dimensions) part.cells *= box.count[d];
    part.values.resize(part.cells * values_of_a_cell(r));
    part.counts.resize(part.cells * counts_of_a_cell(r));
    if (bytes.size() != 8 * (part.values.size() + part.counts.size()))
        throw InputError(r.name, "must have as many bytes in each part as its plan says", std::to_string(bytes.size()));
    std::memcpy(part.values.data(), bytes.data(), 8 * part.values.size());
    std::memcpy(part.counts.data(), bytes.data() + 8 * part.values.size(), 8 * part.counts.size());
    return part;
}

std::vector<Reduced> finished(const Plan& plan, const Reduction& r, const Partial& part) {
    std::vector<Reduced> all{{r.name, false, {}, {}}};
    if (r.statistic == Statistic::share) {
        for (std::size_t cell = 0; cell < part.cells; ++cell) {
            std::int64_t points = 0;
            for (std::size_t n = 0; n < classes; ++n) points += part.counts[cell * classes + n];
            for (std::size_t n = 0; n < classes; ++n)
                all[0].values.push_back(static_cast<double>(part.counts[cell * classes + n]) / static_cast<double>(points));
        }
    } else if (r.statistic == Statistic::histogram) {
        all[0].whole_numbers = true;
        all[0].counts = part.counts;
    } else if (r.bins) {
        const std::vector<double> edges = r.bins->edges();
        for (std::size_t cell = 0; cell < part.cells; ++cell)
            for (const double each : r.probabilities)
                all[0].values.push_back(quantile_of_counts(edges, &part.counts[cell * counts_of_a_cell(r)], each));
    } else {
        all[0].values = part.values;
    }
    if (!is_extreme(r)) return all;
    // Of the place the value along each reduced axis; they count with the last axis of the grid running fastest.
    std::vector<std::int64_t> rest = part.counts;
    const std::vector<std::size_t> before = plan.dimensions_of(r.of);
    for (std::size_t m = before.size(); m-- > 0;) {
        const Dimension& d = plan.dimensions[before[m]];
        if (!is_over(plan, r, before[m])) continue;
        Reduced at{r.name + "_" + d.name, false, {}, {}};
        for (std::int64_t& place : rest) {
            at.values.push_back(place < 0 ? std::nan("") : d.value(static_cast<std::size_t>(place) % d.size));
            if (place >= 0) place /= static_cast<std::int64_t>(d.size);
        }
        all.push_back(std::move(at));
    }
    return all;
}

} // namespace denhartog::sweep
