/// @file
/// @brief What the rungs of `solve` share: the question to a scene, its boundary, and how each rung writes its answer.
#pragma once

#include "denhartog/solve/bounded_response.hpp"
#include "denhartog/solve/prepared_system.hpp"
#include "denhartog/solve/solution.hpp"
#include "denhartog/stick_slip/periodic_orbit.hpp"

namespace denhartog {

/// @brief The point asked about.
struct SolvePoint {
    double r;                  ///< frequency ratio
    double beta;               ///< friction ratio
    const SceneSource* source; ///< where both are to be had in every number type; null where the doubles are what is meant
};

/// @brief The point in a number type.
template <class T>
struct PointIn {
    T r;    ///< frequency ratio
    T beta; ///< friction ratio
};

/// @brief The point in a number type. @param at the point @return r and beta
template <class T>
[[nodiscard]] PointIn<T> point_in(const SolvePoint& at);

/// @brief The system in a number type. @param p the system prepared @return it
template <class T>
[[nodiscard]] System<T> system_in(const PreparedSystem& p);

/// @brief What is said where a lower bound of (69) tells the regime.
inline constexpr const char* certainly_slides =
    "beta is below a lower bound of beta_lim, Eq. (69): the contact slides throughout";

/// @brief Amplitude or phase of the contact alone, in the sliding regime at mu = 1: the cheapest rung.
/// @param p         the system, prepared for such a question
/// @param at        the point
/// @param question  the question
/// @param s         gets the answer
/// @return          false where something else is asked, this has not the digits, or sliding is not certain
[[nodiscard]] bool answer_by_contact(const PreparedSystem& p, const SolvePoint& at, const Question& question, Solution& s);

/// @brief A question to a scene, prepared.
struct SolveTask {
    SceneSource source;                  ///< the scene in every number type
    Question question;                   ///< what is asked
    Scene<double> scene;                 ///< the scene in double
    ModalBasis<double> basis;            ///< its modal basis
    int wanted;                          ///< digits asked for or aimed at
    std::string aim;                     ///< the same in words
    double tolerance;                    ///< ten to the minus that
    std::optional<BoundedModes> modes{}; ///< modes at r with their errors; none where damping is given by a matrix
    Answer found{};                      ///< boundary, regime and closed form, to the digits wanted
    std::optional<std::string> pole{};   ///< why there is none of these
    std::vector<double> phase_error{};   ///< of the closed form, where its bounds were known beforehand
    bool contact_tried = false;          ///< whether the rung of the contact alone was tried: few modes do no better
    std::shared_ptr<const ContactSystem<double>> moving{}; ///< for the exact solver; none where it is still to be prepared
};

/// @brief Prepares a question.
/// @param p         the system, prepared
/// @param at        the point
/// @param question  what is asked; checked
/// @return          the task, without its boundary
/// @throws          as `modal_basis` where the basis is not there yet
[[nodiscard]] SolveTask solve_task(const PreparedSystem& p, const SolvePoint& at, const Question& question);

/// @brief The scene in a number type. @param task the task @return the scene
template <class T>
[[nodiscard]] Scene<T> scene_in(const SolveTask& task);

/// @brief Name of a precision. @return `double`, `50 digits` or `100 digits`
template <class T>
[[nodiscard]] std::string precision_of();

/// @brief How many digits an error leaves. @param error relative @return from 0 to 95
[[nodiscard]] int digits_of(double error);

/// @brief Numbers of an answer in T with the boundary filled in; notes where (56) has another regime.
/// @param task  the task, its boundary found
/// @param s     the answer
/// @return      the numbers
template <class T>
[[nodiscard]] Solved<T> numbers_with_boundary(const SolveTask& task, Solution& s);

/// @brief Amplitudes or phases from the modes that matter, in the sliding regime at mu = 1.
/// @param task  the task
/// @param s     gets the answer
/// @return      false where this has not the digits, or sliding is not certain
[[nodiscard]] bool answer_by_few_modes(SolveTask& task, Solution& s);

/// @brief Finds the boundary and, where it says that the contact slides, the closed form; or the pole that hides them.
/// @param task  gets them
void find_boundary(SolveTask& task);

/// @brief The closed form as the answer.
/// @param task  the task, its boundary found, in the sliding regime
/// @param s     gets the answer
void answer_by_closed_form(const SolveTask& task, Solution& s);

/// @brief The boundaries alone as the answer.
/// @param task   the task, its boundary found
/// @param model  the model as the method names it
/// @param why    what is said before the reason
/// @param s      gets the answer
void answer_by_boundaries(const SolveTask& task, const std::string& model, const std::string& why, Solution& s);

/// @brief The stuck response as the answer, in the first precision that has the digits.
/// @param task      the task, its boundary found
/// @param rests_at  where the contact rests, where that was followed
/// @param s         gets the answer
void answer_by_stuck_response(const SolveTask& task, std::optional<double> rests_at, Solution& s);

/// @brief A periodic orbit as the answer, in the first precision that has the digits.
/// @param task      the task
/// @param solver    the solver that found the orbit
/// @param orbit     the orbit, with its masses
/// @param followed  what is said before the reason
/// @param s         gets the answer
/// @throws          PrecisionError where the digits asked for are out of reach
void answer_by_orbit(const SolveTask& task, ExactSolver<double>& solver, const PeriodicOrbit<double>& orbit,
                     const std::string& followed, Solution& s);

} // namespace denhartog
