#include "link.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "denhartog/program/output/files.hpp"
#include "derivation/ledger/source_text.hpp"

namespace denhartog::pages {

namespace fs = std::filesystem;

namespace {

/// What an element of a piece of XML holds; empty where there is none.
std::string element(const std::string& xml, const std::string& name) {
    const std::string open = "<" + name + ">";
    const std::size_t from = xml.find(open);
    const std::size_t to = from == std::string::npos ? from : xml.find("</" + name + ">", from);
    return to == std::string::npos ? "" : xml.substr(from + open.size(), to - from - open.size());
}

std::string without_suffix(const std::string& name) { return name.ends_with(".html") ? name.substr(0, name.size() - 5) : name; }

/// The address of `source:FILE:LINE`, `source:FILE` or `page:LABEL`; empty where there is none.
std::string address_of(const std::string& target, const Addresses& addresses, std::string& anchor) {
    if (target.starts_with("page:")) {
        const auto found = addresses.pages.find(target.substr(5));
        return found == addresses.pages.end() ? "" : found->second;
    }
    const std::size_t colon = target.rfind(':');
    const bool with_line = colon > 7;
    const auto found = addresses.sources.find(target.substr(7, with_line ? colon - 7 : std::string::npos));
    if (found == addresses.sources.end()) return {};
    if (!with_line) return found->second;
    const std::string line = target.substr(colon + 1);
    if (line.empty() || line.size() > 6 || line.find_first_not_of("0123456789") != std::string::npos) return {};
    char text[16];
    std::snprintf(text, sizeof text, "l%05d", std::stoi(line));
    anchor = text;
    return found->second;
}

} // namespace

Addresses read_tags(const std::string& xml, const fs::path& root) {
    Addresses addresses;
    const std::string prefix = fs::absolute(root).lexically_normal().generic_string();
    for (std::size_t at = xml.find("<compound "); at != std::string::npos; at = xml.find("<compound ", at + 1)) {
        std::string compound = xml.substr(at, xml.find("</compound>", at) - at);
        compound = compound.substr(0, compound.find("<member ")); // members have names of their own
        const std::string kind = compound.substr(0, compound.find('>')), name = element(compound, "name");
        const std::string file = without_suffix(element(compound, "filename"));
        if (kind.find("kind=\"page\"") != std::string::npos) addresses.pages[name] = file + ".html";
        if (kind.find("kind=\"file\"") == std::string::npos) continue;
        std::string path = (fs::path(element(compound, "path")) / name).lexically_normal().generic_string();
        if (path.starts_with(prefix)) path.erase(0, prefix.size() + (prefix.ends_with('/') ? 0 : 1));
        addresses.sources[path] = file + "_source.html";
    }
    return addresses;
}

std::string with_links(const std::string& page, const Addresses& addresses, std::vector<std::string>& missing,
                       std::map<std::string, std::string>& targets) {
    const std::string open = "href=\"";
    std::string out;
    std::size_t done = 0;
    for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at + 1)) {
        const std::size_t from = at + open.size(), to = page.find('"', from);
        const std::string target = page.substr(from, to - from);
        if (!target.starts_with("source:") && !target.starts_with("page:")) continue;
        std::string anchor;
        const std::string address = address_of(target, addresses, anchor);
        if (address.empty()) {
            missing.push_back(target);
            continue;
        }
        const std::string full = address + (anchor.empty() ? "" : "#" + anchor);
        targets[full] = target;
        out += page.substr(done, from - done) + full;
        done = to;
    }
    return out + page.substr(done);
}

std::vector<std::string> link_site(const fs::path& site, const fs::path& tag_file, const fs::path& root, std::size_t& resolved) {
    const Addresses addresses = read_tags(derivation::text_of(tag_file), root);
    std::map<fs::path, std::string> changed;
    std::set<std::string> faults;
    std::map<std::string, std::string> targets;
    for (const fs::path& file : derivation::files_in(site, ".html")) {
        const std::string before = derivation::text_of(file);
        std::vector<std::string> missing;
        std::string after = with_links(before, addresses, missing, targets);
        for (const std::string& target : missing)
            faults.insert(file.filename().string() + " links to " + target + ", which the site does not have");
        if (after != before) changed.emplace(file, std::move(after));
    }
    std::map<std::string, std::string> texts;
    for (const auto& [address, target] : targets) {
        const std::size_t hash = address.find('#');
        const std::string file = address.substr(0, hash);
        if (!fs::exists(site / file)) {
            faults.insert(target + " leads to " + file + ", which is not there");
            continue;
        }
        if (hash == std::string::npos) continue;
        if (!texts.contains(file)) texts[file] = derivation::text_of(site / file);
        const std::string anchor = "\"" + address.substr(hash + 1) + "\"";
        if (texts[file].find("id=" + anchor) == std::string::npos && texts[file].find("name=" + anchor) == std::string::npos)
            faults.insert(target + " leads to a line that " + file + " does not have");
    }
    resolved = targets.size();
    if (faults.empty())
        for (const auto& [file, text] : changed) program::write_file(file.string(), text);
    return {faults.begin(), faults.end()};
}

} // namespace denhartog::pages
