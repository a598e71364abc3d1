// The implementations that users start from, in C and Fortran: their answers in the plain dialect are the library's.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/conformance/c_fixtures.hpp"
#include "tests/conformance/shell.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

const std::string library = DENHARTOG_C_LIBRARY;
std::string adapters() { return source_file("tests/conformance/adapters/"); }

struct Built {
    std::string program;
    std::string fault;
};

Built built(const std::string& name, const std::string& command) {
    const std::string program = (scratch() / name).string();
    const Run run = run_shell("cd '" + scratch().string() + "' && " + command + " -o '" + program + "'");
    return {program, run.status == 0 ? "" : run.error};
}

const std::string strict_c = "cc -std=c99 -pedantic -Wall -Wextra -Werror -O2 ";

Built library_adapter() {
    return built("library_adapter", strict_c + "-I '" + source_file("src/denhartog/c") + "' '" + adapters() +
                                        "c/library_adapter.c' '" + library + "'");
}

Built closed_form_in_c(const std::string& source) {
    return built("closed_form_c", strict_c + "-I '" + adapters() + "c' '" + source + "' '" + adapters() + "c/adapter.c' -lm");
}

Built closed_form_in_fortran(const std::string& source) {
    return built("closed_form_f90",
                 "gfortran -std=f2018 -O2 -Wall -Werror '" + source + "' '" + adapters() + "fortran/adapter.f90'");
}

// Files of a folder that are longer than they may be: a closed form, all its files together, an adapter, a line.
std::vector<std::string> too_long(const std::filesystem::path& folder) {
    std::vector<std::string> found;
    std::size_t closed_form = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        const std::string name = file.path().filename().string();
        const std::vector<std::string> lines = lines_of(content_of(file.path()));
        for (const std::string& line : lines)
            if (line.size() > 130) found.push_back(name + ": " + std::to_string(line.size()) + " columns");
        if (name.starts_with("closed_form.")) closed_form += lines.size();
        if (name.find("adapter.") != std::string::npos && lines.size() > 60)
            found.push_back(name + ": " + std::to_string(lines.size()) + " lines");
    }
    if (closed_form == 0 || closed_form > 200) found.push_back("closed_form: " + std::to_string(closed_form) + " lines");
    std::sort(found.begin(), found.end());
    return found;
}

const std::vector<std::string> of_scene{"natural_frequency_ratios",
                                        "modal_frequency_ratios",
                                        "H_j",
                                        "S_j",
                                        "beta_lim_exact",
                                        "beta_lim_paper",
                                        "beta_lim_approximate",
                                        "beta_lim_sticking",
                                        "beta_lim_high_frequency",
                                        "regime",
                                        "rest_interval"};
const std::vector<std::string> of_mass{"mode_shape_products",     "complex_response",
                                       "first_damping_function",  "amplitude",
                                       "second_damping_function", "phase",
                                       "amplitude_monoharmonic",  "displacement",
                                       "phase_monoharmonic",      "initial_velocity",
                                       "initial_displacement",    "motion_under_force"};

std::string question(const std::string& id, const std::string& quantity, const Scene<double>& scene, std::size_t k) {
    const System<double>& s = scene.system;
    std::ostringstream line;
    line.precision(17);
    line << id << ' ' << quantity << ' ' << s.mass_ratios.size() << ' ' << s.contact.index + 1 << ' ' << s.load.index + 1 << ' '
         << k << ' ' << (quantity == "motion_under_force" ? 8 : 0) << ' ' << (quantity == "displacement" ? 4.25 : 0) << ' '
         << scene.mu << ' ' << *scene.r << ' ' << *scene.beta;
    for (const auto* ratios : {&s.mass_ratios, &s.stiffness_ratios, &s.damping_ratios})
        for (const double x : *ratios) line << ' ' << x;
    return line.str();
}

std::vector<Scene<double>> scenes() {
    std::vector<Scene<double>> all = c_scenes();
    const System<double> two = chain_of({1, 2.5}, {1, 0.625}, {1, 0}, 1, 2), one = chain_of({1}, {1}, {0}, 1, 1);
    const System<double> critical = chain_of({1, 1.5, 0.75}, {1, 0.5, 2}, {1, 1, 1}, 2, 1);
    const auto add = [&](const System<double>& s, double mu, double r, double beta) { all.push_back(scene_of(s, r, beta, mu)); };
    add(one, 1, 0.33325, 0.0625);
    add(one, 1, 8, 0.25);
    add(two, 1, 0.75, 0.03125);
    add(critical, 1, 0.5, 0.03125);
    add(critical, 1, 0.03125, 0.0001220703125);
    add(two, 1.25, 4, 0.0078125);
    add(two, 1, 1.5, 4);
    return all;
}

std::vector<std::string> questions() {
    std::vector<std::string> all;
    for (const Scene<double>& scene : scenes()) {
        for (const std::string& quantity : of_scene)
            all.push_back(question("q" + std::to_string(all.size()), quantity, scene, 0));
        for (const std::string& quantity : of_mass)
            for (std::size_t k = 1; k <= scene.system.mass_ratios.size(); ++k)
                all.push_back(question("q" + std::to_string(all.size()), quantity, scene, k));
    }
    return all;
}

std::vector<std::string> answers(const Built& adapter, const std::vector<std::string>& asked) {
    std::string input = "denhartog-conform 1\n";
    for (const std::string& line : asked) input += line + "\n";
    const Run run = run_shell("LD_LIBRARY_PATH=$(dirname '" + library + "') '" + adapter.program + "'", input);
    INFO(run.error);
    REQUIRE(run.status == 0);
    std::vector<std::string> lines = lines_of(run.output);
    REQUIRE(!lines.empty());
    CHECK(lines.front().rfind("denhartog-conform 1 plain ", 0) == 0);
    lines.erase(lines.begin());
    REQUIRE(lines.size() == asked.size());
    return lines;
}

// Distance of two answers, relative to the largest number of the right one; phases in radians.
double distance(const std::string& question, const std::string& found, const std::string& right) {
    std::istringstream a(found), b(right), q(question);
    std::string id, kind_found, kind_right, quantity, x, y;
    q >> id >> quantity;
    a >> id >> kind_found;
    b >> id >> kind_right;
    if (kind_found != kind_right) return HUGE_VAL;
    if (kind_right != "value") return 0;
    std::vector<double> xs, ys;
    while (a >> x && b >> y) {
        if (quantity == "regime") return x == y ? 0 : HUGE_VAL;
        xs.push_back(std::stod(x));
        ys.push_back(std::stod(y));
    }
    if (xs.empty() || b >> y || a >> x) return HUGE_VAL;
    double apart = 0, size = 0;
    for (std::size_t i = 0; i < xs.size(); ++i) {
        const double d = xs[i] - ys[i];
        apart = std::max(apart, std::abs(quantity.starts_with("phase") ? std::remainder(d, 2 * std::numbers::pi) : d));
        size = std::max(size, std::abs(ys[i]));
    }
    return quantity.starts_with("phase") ? apart : apart / std::max(size, 1e-3);
}

// True for an answer that no closed form gives: it is skipped, and the contact sticks and slips.
bool is_left_out(const std::string& answer, const std::string& regime) {
    return answer.find(" skip ") != std::string::npos && regime.find(" stick_slip") != std::string::npos;
}

double worst_distance(const Built& adapter, std::size_t& skipped, std::string& where) {
    const std::vector<std::string> asked = questions();
    const std::vector<std::string> found = answers(adapter, asked), right = answers(library_adapter(), asked);
    double worst = 0;
    std::string regime;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (asked[i].find(" regime ") != std::string::npos) regime = right[i]; // asked of each scene before its masses
        if (is_left_out(found[i], regime)) {
            ++skipped;
            continue;
        }
        const double apart = distance(asked[i], found[i], right[i]);
        if (apart > worst) {
            worst = apart;
            where = asked[i] + "\n" + found[i] + "\n" + right[i];
        }
    }
    return worst;
}

void check_refusals(const Built& adapter) {
    std::vector<Scene<double>> bad(8, scenes().front());
    bad[0].system.mass_ratios[1] = -1;
    bad[1].system.stiffness_ratios[1] = 0;
    bad[2].system.damping_ratios[0] = -0.5;
    bad[3].mu = 0.5;
    *bad[4].r = 0;
    *bad[5].beta = -1;
    bad[6].system.contact = {2};
    bad[7].system.load = {7};
    std::vector<std::string> asked;
    for (const Scene<double>& scene : bad) asked.push_back(question("bad", "H_j", scene, 0));
    asked.push_back(question("bad", "amplitude", scenes().front(), 3));
    asked.push_back(question("bad", "complex_response", scenes().front(), 3));
    for (const std::string& line : answers(adapter, asked)) CHECK(line.rfind("bad reject ", 0) == 0);
    CHECK(answers(adapter, {question("q", "no_such_quantity", scenes().front(), 1)})[0].rfind("q skip ", 0) == 0);
    const std::string of_paper = question("q", "amplitude", scenes().front(), 1);
    for (const char* more : {"contact_with 2", "loads 1 -0.5", "loads 1 -0.5 load_phases 0.5 0", "base_motion alone",
                             "base_motion wall", "damping_matrix 1 -0.5 -0.5 0.5"})
        CHECK(answers(adapter, {of_paper + " " + more})[0].rfind("q skip ", 0) == 0);
}

void check_closed_form(const Built& adapter) {
    INFO(adapter.fault);
    REQUIRE(adapter.fault.empty());
    std::size_t skipped = 0;
    std::string where;
    const double worst = worst_distance(adapter, skipped, where);
    INFO(where);
    CHECK(worst < 1e-11); // 5 x 10^4 eps: a mode above lies at 1/3 within 2.5 x 10^-4, without damping
    CHECK(skipped > 0);
    check_refusals(adapter);
}

struct Twin {
    std::string right, wrong;
};

// With each one of the texts exchanged for a wrong one, the closed form has to be far from the library.
void check_twins(const std::string& source, const std::string& name, Built (*build)(const std::string&),
                 const std::vector<Twin>& twins) {
    for (const Twin& twin : twins) {
        INFO(twin.right);
        std::string mutated = source;
        REQUIRE(mutated.find(twin.right) != std::string::npos);
        mutated.replace(mutated.find(twin.right), twin.right.size(), twin.wrong);
        std::size_t skipped = 0;
        std::string where;
        const Built adapter = build(file_with(name, mutated).string());
        REQUIRE(adapter.fault.empty());
        CHECK(worst_distance(adapter, skipped, where) > 1e-6);
    }
}

} // namespace

TEST_CASE("the closed form in C answers as the library does", "[conformance][c][eq:38][eq:46][eq:69]") {
    check_refusals(library_adapter());
    check_closed_form(closed_form_in_c(adapters() + "c/closed_form.c"));
}

TEST_CASE("a closed form with a wrong sign does not pass for the library", "[conformance][c]") {
    check_twins(content_of(adapters() + "c/closed_form.c"), "closed_form.c", closed_form_in_c,
                {{"(1 + s->g[i]) * f.q", "(1 - s->g[i]) * f.q"},
                 {"carg(W_j) - carg", "carg(W_j) + carg"},
                 {"+ s->mu / (s->gamma[j]", "+ 1 / (s->gamma[j]"}});
}

TEST_CASE("the closed form in Fortran answers as the library does", "[conformance][fortran][eq:38][eq:46][eq:69]") {
    if (!has_command("gfortran")) {
        SKIPPED("gfortran is not there");
        return;
    }
    check_closed_form(closed_form_in_fortran(adapters() + "fortran/closed_form.f90"));
    check_twins(
        content_of(adapters() + "fortran/closed_form.f90"), "closed_form.f90", closed_form_in_fortran,
        {{"(1 + g) * q / R_i", "(1 - g) * q / R_i"}, {"atan2(-bU", "atan2(bU"}, {"least = H_j + mu /", "least = H_j + 1 /"}});
}

TEST_CASE("a closed form to start from has at most 200 lines and its adapter at most 60", "[conformance][documentation]") {
    for (const char* language : {"c", "fortran", "javascript", "octave", "python"}) {
        INFO(language);
        CHECK(too_long(adapters() + language).empty());
    }
    const std::filesystem::path folder = scratch() / "lengths";
    std::filesystem::create_directories(folder);
    file_with("lengths/adapter.x", std::string(61, '\n'));
    file_with("lengths/closed_form.x", std::string(150, '\n'));
    file_with("lengths/closed_form.y", std::string(50, '\n') + std::string(131, '!'));
    CHECK(too_long(folder) ==
          std::vector<std::string>{"adapter.x: 61 lines", "closed_form.y: 131 columns", "closed_form: 201 lines"});
}
