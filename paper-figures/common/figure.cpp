#include "figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <unistd.h>

namespace denhartog::figures {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

void write_whole(const fs::path& file, const std::string& content) {
    const fs::path part = file.string() + ".part";
    {
        std::ofstream out(part, std::ios::binary);
        out << content << std::flush;
        if (!out) throw std::runtime_error("cannot write " + file.string());
    }
    fs::rename(part, file);
}

json to_json(const Record& record) {
    json agreements = json::array(), statements = json::array();
    for (const Agreement& a : record.agreements)
        agreements.push_back(
            {{"what", a.what}, {"points", a.points}, {"median", a.median}, {"worst", a.worst}, {"where", a.where}});
    for (const Statement& s : record.statements)
        statements.push_back({{"text", s.text}, {"found", s.found}, {"borne_out", s.borne_out}, {"measure", s.measure}});
    return {{"title", record.title},    {"equations", record.equations}, {"given", record.given},    {"chosen", record.chosen},
            {"agreements", agreements}, {"statements", statements},      {"remarks", record.remarks}};
}

} // namespace

Figure::Figure(fs::path folder, std::string name) : folder_(std::move(folder)), name_(std::move(name)) {}

void Figure::add(const Table& table) {
    if (std::find(tables_.begin(), tables_.end(), table.name) != tables_.end())
        throw std::invalid_argument("two tables are named " + table.name);
    tables_.push_back(table.name);
    data_ += "# " + table.name + ";\n#";
    for (const std::string& column : table.columns) data_ += " " + column;
    data_ += "\n";
    if (!table.words.empty() && table.words.size() != table.rows.size())
        throw std::invalid_argument("a row of " + table.name + " has no words");
    for (std::size_t at = 0; at < table.rows.size(); ++at) {
        const std::vector<double>& row = table.rows[at];
        if (row.size() != table.columns.size()) throw std::invalid_argument("a row of " + table.name + " has the wrong length");
        for (std::size_t n = 0; n < row.size(); ++n)
            data_ += (n == 0 ? "" : " ") + (std::isnan(row[n]) ? "NaN" : text(row[n], "%.10g"));
        if (!table.words.empty())
            for (const std::string& words : table.words[at]) data_ += " \"" + words + "\"";
        data_ += "\n";
    }
    data_ += "\n\n";
}

void Figure::progress(std::size_t done, std::size_t all) const {
    if (::isatty(STDERR_FILENO) != 0)
        std::fprintf(stderr, "\r\033[K%s %zu/%zu%s", name_.c_str(), done, all, done == all ? "\r\033[K" : "");
}

void Figure::write(const Record& record, double seconds) const {
    fs::create_directories(folder_);
    json entry = to_json(record);
    entry["name"] = name_;
    entry["seconds"] = seconds;
    const fs::path data = folder_ / (name_ + ".dat");
    std::ifstream before(data, std::ios::binary);
    if (!before || std::string(std::istreambuf_iterator<char>(before), {}) != data_) write_whole(data, data_);
    write_whole(folder_ / (name_ + ".json"), entry.dump(1) + "\n");
}

namespace {

std::map<std::string, Make>& figures() {
    static std::map<std::string, Make> all;
    return all;
}

} // namespace

Listed::Listed(const std::string& name, Make make) { figures().emplace(name, make); }

const std::map<std::string, Make>& listed_figures() { return figures(); }

std::string text(double x, const char* format) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, x);
    return buffer;
}

std::vector<double> spaced(double a, double b, std::size_t n) {
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = a + (b - a) * static_cast<double>(i) / static_cast<double>(n - 1);
    return x;
}

std::vector<double> spaced_in_octaves(double a, double b, std::size_t n) {
    std::vector<double> x = spaced(std::log(a), std::log(b), n);
    for (double& each : x) each = std::exp(each);
    return x;
}

Agreement agreement(const std::string& what, const std::vector<std::pair<double, std::string>>& differences) {
    if (differences.empty()) throw std::invalid_argument("nothing to compare: " + what);
    std::vector<double> sizes;
    Agreement a{what, static_cast<int>(differences.size()), 0, -1, {}};
    for (const auto& [difference, where] : differences) {
        if (std::isnan(difference)) throw std::invalid_argument("a difference is no number: " + what + ", " + where);
        sizes.push_back(std::abs(difference));
        // of two that are alike but for rounding, as in the halves of a symmetric motion, the first is named
        if (sizes.back() > a.worst * (1 + 1e-6)) a = {what, a.points, 0, sizes.back(), where};
    }
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
    a.median = sizes[sizes.size() / 2];
    return a;
}

} // namespace denhartog::figures
