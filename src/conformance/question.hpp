/// @file
/// @brief Questions to an implementation under test, and its answers; docs/protocol.md describes them for readers.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace denhartog {
template <class T>
struct Scene;
} // namespace denhartog

namespace denhartog::conformance {

/// @brief Count of the numbers in an answer to a quantity.
enum class Shape {
    number,    ///< one
    complex,   ///< real and imaginary part
    modes,     ///< one for each mode, by ascending natural frequency
    durations, ///< one for each stop of the contact, ascending; none if it does not stop
    samples,   ///< as many as the question has samples
    word       ///< the name of a regime instead of numbers
};

/// @brief A quantity that may be asked for.
struct Quantity {
    std::string_view name;     ///< its name in the protocol
    std::string_view equation; ///< number of its equation in the paper, e.g. `38`; empty if it has none
    Shape shape;               ///< how many numbers
    bool of_mass;              ///< whether a question names the mass k
    bool angle;                ///< whether it is an angle: compared round the circle, in radians
    std::size_t link = 18;     ///< its place in the chain of quantities, each made of those before it, see `chain_of`
    bool absolute = false;     ///< whether it belongs to the motion as it is seen from the ground, of a base or wall that moves
};

/// @brief All quantities, in the order of the protocol. @return the quantities
[[nodiscard]] std::span<const Quantity> quantities();

/// @brief A quantity by its name. @param name its name @return the quantity @throws InputError if no quantity has the name
[[nodiscard]] const Quantity& quantity(std::string_view name);

struct ProtocolQuestion;

/// @brief Which link of the chain of quantities a question belongs to. @param q the question
/// @return its place from 0 on; the functions of one mass come before the sums over modes
[[nodiscard]] std::size_t place_in_chain(const ProtocolQuestion& q);

/// @brief A question. Its numbers may break any rule of a scene, because an implementation must reject some questions.
struct ProtocolQuestion {
    std::string id;                       ///< letters, digits and hyphens
    std::string quantity;                 ///< what is asked, a name of `quantities`
    std::vector<double> mass_ratios;      ///< gamma, Eq. (9), N values
    std::vector<double> stiffness_ratios; ///< kappa, Eq. (73), N values
    std::vector<double> damping_ratios;   ///< zeta, Eq. (18), N values
    int contact = 1;                      ///< j, counted from 1
    int load = 1;                         ///< l, counted from 1
    double mu = 1;                        ///< static over kinetic friction, Eq. (3)
    double r = 1;                         ///< frequency ratio, Eq. (10)
    double beta = 0;                      ///< friction ratio, Eq. (11)
    int mass = 0;                   ///< k, counted from 1; 0 if the quantity belongs to no mass, or to a contact between two
    double tau = 0;                 ///< non-dimensional time, for `displacement`
    int samples = 0;                ///< instants, for `motion_under_force`
    int contact_with = 0;           ///< the mass that the contact rubs against, counted from 1; 0 for a wall
    std::vector<double> loads = {}; ///< force on each mass in units of P, in place of `load`, N values or none
    std::vector<double> load_phases = {}; ///< by how much each of them leads cos(tau), radians; none if all are in phase
    std::string base_motion = {}; ///< `with_wall`, `alone` or `wall`, in place of `load`; empty where neither base nor wall moves
    std::vector<double> mass_matrix = {};      ///< M in units of m_1, row by row, in place of `mass_ratios`
    std::vector<double> stiffness_matrix = {}; ///< K in units of k_1, row by row, in place of `stiffness_ratios`
    std::vector<double> damping_matrix = {};   ///< C in units of sqrt(k_1 m_1), row by row, in place of `damping_ratios`

    /// @brief Whether all members are equal. @return true if so
    bool operator==(const ProtocolQuestion&) const = default;
};

/// @brief Whether a question is about a scene of the paper: a chain with modal damping ratios, a wall, one loaded mass.
/// @param q the question @return false where it has one of the last seven members
[[nodiscard]] bool is_of_the_paper(const ProtocolQuestion& q);

/// @brief Number of masses of a question's scene. @param q the question @return N
[[nodiscard]] std::size_t masses_of(const ProtocolQuestion& q);

/// @brief Features of a question's scene that the paper does not treat, by the names of flags, e.g. `contact-between-masses`.
/// @param q the question @return the names; none for a scene of the paper
[[nodiscard]] std::vector<std::string> beyond_the_paper(const ProtocolQuestion& q);

/// @brief Whether a mode of a question's scene does not vibrate. @param q the question @return whether a zeta_i is 1 or more
[[nodiscard]] bool is_overdamped(const ProtocolQuestion& q);

/// @brief Whether a question asks for one of several quantities. @param q the question @param names the quantities
/// @return whether it does
[[nodiscard]] bool asks_for(const ProtocolQuestion& q, std::initializer_list<std::string_view> names);

/// @brief The scene of a question, as the library has it, its numbers taken as exact. @param q the question
/// @return the scene, checked; a moving base as the load that it is
/// @throws InputError if a number breaks a rule of the scene, or the scene does not have the mass asked about
[[nodiscard]] Scene<double> scene_of(const ProtocolQuestion& q);

/// @brief A question as the object of the protocol's `json` dialect. @param q the question @return the object
[[nodiscard]] nlohmann::ordered_json question_json(const ProtocolQuestion& q);

/// @brief A question as the line of the protocol's `plain` dialect. @param q the question @return the line, without its end
[[nodiscard]] std::string question_plain(const ProtocolQuestion& q);

/// @brief Reads a question from the object of the `json` dialect. Unknown members are ignored. @param object the object
/// @return the question @throws InputError if a member is missing or has another type
[[nodiscard]] ProtocolQuestion question_from_json(const nlohmann::json& object);

/// @brief Numbers, or the name of a regime.
struct Value {
    std::vector<double> numbers; ///< finite
    std::string word;            ///< the regime; empty if there are numbers

    /// @brief Whether all members are equal. @return true if so
    bool operator==(const Value&) const = default;
};

/// @brief The implementation found that the question breaks a rule.
struct Rejected {
    std::string reason; ///< in the implementation's words
};

/// @brief The implementation does not compute this.
struct Skipped {
    std::string reason; ///< in the implementation's words
};

/// @brief The answer cannot be used: it is not finite, not a number, or not in the protocol.
struct Unusable {
    std::string reason; ///< what is wrong with it
};

/// @brief An answer.
using Answer = std::variant<Value, Rejected, Skipped, Unusable>;

/// @brief Whether a word is the name of a regime. @param word the word @return whether it is
[[nodiscard]] bool is_regime(std::string_view word);

/// @brief A number as an answer writes it: decimal or hexadecimal, nothing before or after it. @param text the text
/// @return the number; none if it is no finite one
[[nodiscard]] std::optional<double> finite_number(std::string_view text);

/// @brief Words in a line. @param words the words @param between what stands between two of them @return the line
[[nodiscard]] std::string joined(std::span<const std::string> words, std::string_view between = " ");

/// @brief Numbers in a line, each as the shortest text from which it can be read again. @param numbers the numbers
/// @param between what stands between two of them @return the line
[[nodiscard]] std::string joined(std::span<const double> numbers, std::string_view between = " ");

/// @brief An answer from a line of the `json` dialect, whose id has to be the question's. @param line the line
/// @param id the question's id @return the answer; `Unusable` with the reason if the line is not an answer
[[nodiscard]] Answer answer_from_json(std::string_view line, std::string_view id);

/// @brief An answer from a line of the `plain` dialect. @param line the line @param id the question's id
/// @return the answer; `Unusable` with the reason if the line is not an answer
[[nodiscard]] Answer answer_from_plain(std::string_view line, std::string_view id);

/// @brief An answer from the cell of an answers file: numbers separated by spaces, a regime, `reject`, or `skip`.
/// @param text the cell @return the answer
[[nodiscard]] Answer answer_from_cell(std::string_view text);

/// @brief Reads answers in a file: CSV with the heading `id,value`, or JSON Lines as the protocol has them.
///
/// A file whose first character is `{` is JSON Lines; any other is CSV, cells in quotes where they need it, lines ended by LF or
/// CRLF.
/// @param text   the file
/// @param known  the ids of all vectors
/// @return       the answers by id
/// @throws       InputError if the heading is missing, a line is not an answer, or an id is unknown or given twice
[[nodiscard]] std::map<std::string, Answer> answers_in(std::string_view text, const std::set<std::string>& known);

} // namespace denhartog::conformance
