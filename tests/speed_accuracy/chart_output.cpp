#include "tests/speed_accuracy/chart_survey.hpp"

#include <algorithm>
#include <fstream>
#include <map>

#include "denhartog/solve/solve.hpp"
#include "tests/speed_accuracy/peers/peers.hpp"

namespace denhartog::tests {
namespace {

const std::vector<int>& digits_of_front() {
    static const std::vector<int> all{2, 4, 8, 12, 15, 30};
    return all;
}

std::string quoted(const std::string& text) {
    std::string copy = "\"";
    for (const char c : text) copy += c == '"' ? "\"\"" : std::string(1, c);
    return copy + "\"";
}

std::string exact(double x) { return digits(x, "%.17g"); }

std::string run_cells(const ChartRun& run) {
    return std::to_string(run.seed) + "," + quoted(run.version) + "," + quoted(run.compiler) + "," + quoted(run.processor);
}

std::vector<std::string> scenes_of(const std::vector<ChartRow>& rows) {
    std::vector<std::string> names;
    for (const ChartRow& row : rows)
        if (std::ranges::find(names, row.scene) == names.end()) names.push_back(row.scene);
    return names;
}

bool is_solve(const ChartRow& row) { return row.method == "solve"; }

// True for a method that `solve` calls; none of them settles regime and error bound of an answer by itself.
bool is_part_of_solve(const ChartRow& row) { return row.method.starts_with("closed form as") || row.method == "exact solver"; }

double cost_of(const ChartRow& row, bool with_setup) { return row.time + (with_setup ? row.setup : 0); }

std::string cell_of(const ChartRow* row, bool with_setup) {
    if (!row) return "nobody";
    return row->method + ", " + row->setting + ": " + digits(cost_of(*row, with_setup), "%.3g") + " us";
}

std::string times(const ChartRow* ours, const ChartRow* other, bool with_setup) {
    if (!ours || !other) return "-";
    const double ratio = cost_of(*other, with_setup) / cost_of(*ours, with_setup);
    return digits(ratio) + (ratio < 1 ? ", faster than `solve`" : "");
}

} // namespace

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
    return "not known";
}

std::string csv(const std::vector<ChartRow>& rows, const ChartRun& run) {
    std::string text = "scene,method,setting,asked,present,points,right";
    for (const std::string& name : failure_names()) text += "," + name;
    text += ",worst error,median error,digits at the worst,digits at the median,setup microseconds,point microseconds,"
            "slowest point microseconds,evaluations,repeats,seed,version,compiler,processor\n";
    for (const ChartRow& row : rows) {
        text += quoted(row.scene) + "," + quoted(row.method) + "," + quoted(row.setting) + "," + digits(row.asked) + "," +
                (row.present ? "yes" : "no") + "," + std::to_string(row.points) + "," + std::to_string(row.right);
        for (const int count : row.failures) text += "," + std::to_string(count);
        text += "," + digits(row.worst, "%.4e") + "," + digits(row.median, "%.4e") + "," +
                digits(digits_left(row.worst), "%.2f") + "," + digits(digits_left(row.median), "%.2f") + "," +
                digits(row.setup, "%.4g") + "," + digits(row.time, "%.4g") + "," + digits(row.longest, "%.4g") + "," +
                std::to_string(row.evaluations) + "," + std::to_string(row.repeats) + "," + run_cells(run) + "\n";
    }
    return text;
}

std::string csv(const std::vector<ChartGround>& grounds, const ChartRun& run) {
    std::string text = "scene,r,beta,regime,X_j,condition,bare microseconds,seed,version,compiler,processor\n";
    for (const ChartGround& ground : grounds)
        for (std::size_t n = 0; n < ground.truth.size(); ++n)
            text += quoted(ground.scene.name) + "," + exact(ground.scene.points[n].r) + "," + exact(ground.scene.points[n].beta) +
                    "," + name(ground.truth[n].regime) + "," + exact(ground.truth[n].answer.amplitude) + "," +
                    digits(ground.truth[n].condition) + "," + digits(ground.bare) + "," + run_cells(run) + "\n";
    return text;
}

std::string picture_data(const std::vector<ChartRow>& rows, const std::vector<ChartGround>& grounds) {
    std::vector<std::string> methods;
    for (const ChartRow& row : rows)
        if (std::ranges::find(methods, row.method) == methods.end()) methods.push_back(row.method);
    std::string text;
    for (std::size_t m = 0; m < methods.size(); ++m) text += "# name " + std::to_string(m + 1) + " " + methods[m] + "\n";
    for (std::size_t s = 0; s < grounds.size(); ++s) {
        const std::string scene = " scene=" + std::to_string(s + 1) + ";";
        text += "# title " + std::to_string(s + 1) + " " + grounds[s].scene.name + "\n# limits" + scene + "\n" +
                digits(digits_left(grounds[s].condition_worst * 0x1p-52)) + " " + digits(grounds[s].bare) + "\n\n\n";
        for (std::size_t m = 0; m < methods.size(); ++m) {
            // A point outside every picture: a method that is not there has no other.
            text += "#" + scene + " method=" + std::to_string(m + 1) + ";\n-99 -99 1e-9 1e-9 1e-99 1 1 1 1 1 1\n\n";
            for (const ChartRow& row : rows) {
                if (row.scene != grounds[s].scene.name || row.method != methods[m] || !row.present) continue;
                const bool moves = row.right > 0 && row.worst > 0;
                text += digits(moves ? digits_left(row.worst) : NAN, "%.3f") + " " +
                        digits(moves ? digits_left(row.median) : NAN, "%.3f") + " " + digits(row.time, "%.5g") + " " +
                        digits(row.setup, "%.5g") + " " + digits(row.asked) + " " +
                        digits(static_cast<double>(row.right) / row.points, "%.3f");
                for (const int count : row.failures) text += " " + std::to_string(count);
                text += "\n";
            }
            text += "\n\n";
        }
    }
    return text;
}

Table front_table(const std::vector<ChartRow>& rows, bool with_setup) {
    Table table{
        with_setup ? "The front: a single question, setup included" : "The front: one more question to a system set up before",
        {"scene", "digits", "`solve` asked for them", "fastest other method", "its time over that of `solve`",
         "fastest part of `solve`", "its time over that of `solve`"},
        {},
        "Right at every point, with the digits at the worst of them: an error of at most 5 in the next digit, as rounding leaves "
        "it. Eigen makes no vectors here, so that the library has the same digits everywhere; harmonic balance would gain by "
        "them. Parts of `solve`, the closed form and the exact solver, "
        "bring no bound of their error, and the closed form not the regime."};
    for (const std::string& scene : scenes_of(rows))
        for (const int wanted : digits_of_front()) {
            const ChartRow* part = fastest(rows, scene, wanted, with_setup, is_part_of_solve);
            const ChartRow* other = fastest(rows, scene, wanted, with_setup,
                                            [](const ChartRow& row) { return !is_solve(row) && !is_part_of_solve(row); });
            const ChartRow* ours = fastest(rows, scene, wanted, with_setup, [&](const ChartRow& row) {
                return is_solve(row) && row.setting == std::to_string(wanted) + " digits";
            });
            table.rows.push_back({scene, std::to_string(wanted),
                                  ours ? digits(cost_of(*ours, with_setup)) + " us" : "not reached", cell_of(other, with_setup),
                                  times(ours, other, with_setup), cell_of(part, with_setup), times(ours, part, with_setup)});
        }
    return table;
}

Table failure_table(const std::vector<ChartRow>& rows) {
    Table table{"Failures by name", {"scene", "method", "setting", "right", "failed"}, {}, ""};
    for (const ChartRow& row : rows) {
        if (row.present && row.right == row.points) continue;
        std::string failed = row.present ? "" : "skipped";
        for (std::size_t k = 0; k < row.failures.size(); ++k)
            if (row.failures[k] > 0)
                failed += (failed.empty() ? "" : ", ") + failure_names()[k] + " " + std::to_string(row.failures[k]);
        table.rows.push_back(
            {row.scene, row.method, row.setting, std::to_string(row.right) + " of " + std::to_string(row.points), failed});
    }
    return table;
}

Table solve_work_table(const std::vector<ChartGround>& grounds) {
    Table table{"Work of `solve`",
                {"scene", "digits", "eigenproblems", "modes", "phases", "models"},
                {},
                "Sums over the points, with the setup of the system."};
    for (const ChartGround& ground : grounds)
        for (const int wanted : digits_of_front()) {
            std::map<std::string, int> models;
            const Question question = question_of_chart(ground.scene.system, wanted);
            const long before = eigen_solves();
            const PreparedSystem prepared =
                prepare(scene_source(Scene<double>{ground.scene.system, 1, {}, {}, {}, {}}), question);
            Work sum{eigen_solves() - before, 0, 0};
            for (const ChartPoint& point : ground.scene.points) {
                try {
                    const Solution s = solve(prepared, point.r, point.beta, question);
                    sum.eigen_solves += s.work.eigen_solves;
                    sum.mode_evaluations += s.work.mode_evaluations;
                    sum.phases_propagated += s.work.phases_propagated;
                    ++models[s.method.model + " in " + s.method.precision];
                } catch (const PrecisionError&) {
                    ++models["not reached"];
                }
            }
            std::string used;
            for (const auto& [model, count] : models) used += (used.empty() ? "" : "; ") + std::to_string(count) + " " + model;
            table.rows.push_back({ground.scene.name, std::to_string(wanted), std::to_string(sum.eigen_solves),
                                  std::to_string(sum.mode_evaluations), std::to_string(sum.phases_propagated), used});
        }
    return table;
}

} // namespace denhartog::tests
