// `denhartog describe`: the manual page in roff and the completion of bash, both written from the subcommands and options that
// the program has. The build calls it; the help does not list it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "denhartog/program/commands/commands.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/version.hpp"

namespace denhartog::program {
namespace {

// Subcommands that are listed in the help.
std::vector<const CLI::App*> listed_commands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); });
}

// A text as roff takes it: no line starts with a dot or an apostrophe, no backslash or hyphen means anything.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    return out;
}

std::string options_in_roff(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) continue;
        const std::string name = option->get_positional() ? option->get_name(true) : option->get_name(false, true);
        const std::string type = option->get_type_size() != 0 && !option->get_positional() ? " " + option->get_type_name() : "";
        text += ".TP\n.B " + roff(name + type) + "\n" + roff(option->get_description()) + "\n";
    }
    return text;
}

std::string manual_page(const CLI::App& app) {
    std::string page = ".TH DENHARTOG 1 \"\" \"denhartog " DENHARTOG_VERSION "\"\n.SH NAME\ndenhartog \\- " +
                       roff(app.get_description()) + "\n.SH SYNOPSIS\n.B denhartog\n.I SUBCOMMAND\n[OPTIONS]\n.SH OPTIONS\n" +
                       options_in_roff(app) + ".SH EXIT STATUS\n.nf\n" + roff(app.get_footer()) + "\n.fi\n";
    for (const CLI::App* command : listed_commands(app)) {
        std::string name = command->get_name();
        std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        page += ".SH " + roff(name) + "\n" + roff(command->get_description()) + "\n" + options_in_roff(*command);
        for (const CLI::App* further : listed_commands(*command))
            page += ".SS " + roff(command->get_name() + " " + further->get_name()) + "\n" + roff(further->get_description()) +
                    "\n" + options_in_roff(*further);
        if (!command->get_footer().empty()) page += ".PP\n.nf\n" + roff(command->get_footer()) + "\n.fi\n";
    }
    return page;
}

// The words that may follow: subcommands, then options.
std::string words_of(const CLI::App& app) {
    std::string words;
    for (const CLI::App* command : listed_commands(app)) words += command->get_name() + " ";
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) words += "--" + name + " ";
    return words;
}

std::string completion_of_bash(const CLI::App& app) {
    std::string cases;
    for (const CLI::App* command : listed_commands(app)) {
        cases += "        " + command->get_name() + ") words='" + words_of(*command) + "' ;;\n";
        for (const CLI::App* further : listed_commands(*command))
            cases += "        '" + command->get_name() + " " + further->get_name() + "') words='" + words_of(*further) + "' ;;\n";
    }
    return "# Completes subcommands and options; files where none of them begins so.\n"
           "_denhartog() {\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} words\n"
           "    [ \"$COMP_CWORD\" -gt 2 ] && [ $command = conform ] && command+=\" ${COMP_WORDS[2]}\"\n"
           "    [ \"$COMP_CWORD\" = 1 ] && command=\n"
           "    case $command in\n"
           "        '') words='" +
           words_of(app) + "' ;;\n" + cases +
           "    esac\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
           "}\n"
           "complete -o default -F _denhartog denhartog\n";
}

} // namespace

void add_describe_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("describe", "Print the manual page (man) or the completion of bash (bash)");
    command->group(""); // for the build, not for users
    const auto kind = std::make_shared<std::string>();
    command->add_option("KIND", *kind)->required()->check(CLI::IsMember({"man", "bash"}));
    command->callback([&app, kind] { write_standard_output(*kind == "man" ? manual_page(app) : completion_of_bash(app)); });
}

} // namespace denhartog::program
