// The program as a function: it reads the arguments, runs the subcommand that they name, turns faults into messages and exit
// statuses, and lets a signal end the work. Read `run`.
#include "denhartog/program/program.hpp"

#include <CLI/CLI.hpp>

#include "denhartog/number/errors.hpp"
#include "denhartog/program/commands/commands.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/version.hpp"

namespace denhartog::program {
namespace {

std::string version_text(const Build& build) {
    return "denhartog " DENHARTOG_VERSION "\n" + (build.commit.empty() ? "" : "commit " + build.commit + ", ") + "built by " +
           build.compiler +
           "\nThe digits are the same on every machine with numbers of IEEE 754, from every compiler that rounds by it";
}

int run(int argc, char** argv, const Build& build, ExitStatus& status) {
    CLI::App app{"Steady forced vibration of damped mass-spring systems with a Coulomb contact", "denhartog"};
    app.set_version_flag("--version", version_text(build), "Print the version, the commit and the compiler, and exit");
    app.require_subcommand(1);
    app.footer("Exit status: 0 answered; 1 an implementation under test does not conform; 2 bad input or usage;\n"
               "3 could not compute to the digits asked for, or a program under test broke.\n"
               "`denhartog SUBCOMMAND --help` explains a subcommand.");
    add_solve_command(app, status);
    add_response_command(app, status);
    add_motion_command(app, status);
    add_boundary_command(app, status);
    add_map_command(app, status);
    add_find_command(app, status);
    add_integrate_command(app, status);
    add_functions_command(app, status);
    add_equations_command(app);
    add_derive_command(app);
    add_conform_command(app, status, {argv, argv + argc});
    add_describe_command(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help_or_version) {
        app.exit(help_or_version);
    } catch (const CLI::ParseError& e) {
        status.bad_input = true;
        const bool unknown = app.get_subcommands().empty() && !app.remaining().empty();
        report(unknown ? "there is no subcommand '" + app.remaining().front() + "'" : std::string(e.what()));
    }
    write_standard_output("");
    return status.value();
}

std::atomic<std::atomic<bool>*> flag{nullptr};
std::atomic<int> signal_caught{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
              std::atomic<std::atomic<bool>*>::is_always_lock_free);

void catch_signal(int signal) {
    signal_caught = signal;
    *flag.load() = true;
}

} // namespace

Interruptible::Interruptible(std::atomic<bool>& stop) {
    flag = &stop;
    for (std::size_t n = 0; n < signals.size(); ++n) before[n] = std::signal(signals[n], catch_signal);
    if (before.back() == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

int Interruptible::caught() const { return signal_caught; }

int Interruptible::end() {
    for (std::size_t n = 0; n < signals.size(); ++n) std::signal(signals[n], before[n]);
    return caught();
}

int run_program(int argc, char** argv, const Build& build) {
    ExitStatus status;
    try {
        return run(argc, argv, build, status);
    } catch (const InputError& e) {
        status.bad_input = true;
        report(e.what());
    } catch (const std::exception& e) {
        status.digits_missing = true;
        report(in_own_words(e));
    }
    return status.value();
}

} // namespace denhartog::program
