/// @file
/// @brief Parts of a study's JSON text, each with its place; used by its reader alone.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "denhartog/sweep/study/study.hpp"

namespace denhartog::sweep {

/// @brief The name of a quantity. @param q a quantity @return its key
[[nodiscard]] std::string_view name_of(VariedQuantity q);

/// @brief A value of a study with its key and its place.
class Item {
public:
    /// @param value  what the study has there
    /// @param key    the key under which it stands
    /// @param place  where that is, for messages
    Item(const nlohmann::json& value, std::string key, std::string place);

    /// @brief Whether it has a key. @param key a key @return whether it has
    [[nodiscard]] bool has(const char* key) const { return value_.contains(key); }
    /// @brief The value of a key that must be there. @param key a key @return its value @throws InputError where there is none
    [[nodiscard]] Item operator[](const char* key) const;
    /// @brief The entries of an array. @return one each, at least one @throws InputError where it is no array or empty
    [[nodiscard]] std::vector<Item> entries() const;
    /// @brief Refuses what is no object, and keys that are none. @param keys the keys that it may have @param of what it is
    void allow(std::span<const std::string_view> keys, const std::string& of) const;
    /// @brief One of some words. @param words the words @return the place of the word among them
    [[nodiscard]] std::size_t one_of(std::span<const std::string_view> words) const;
    /// @brief A finite number. @return the number
    [[nodiscard]] double number() const;
    /// @brief A number above zero. @return the number
    [[nodiscard]] double positive() const;
    /// @brief A whole number. @param least the least @param most the most @return the number
    [[nodiscard]] std::uint64_t whole(std::uint64_t least, std::uint64_t most) const;
    /// @brief A text. @return the text
    [[nodiscard]] std::string text() const;
    /// @brief The value as it was read. @return the value
    [[nodiscard]] const nlohmann::json& json() const { return value_; }
    /// @brief Throws an InputError about it. @param rule the rule that it breaks
    [[noreturn]] void fail(const std::string& rule) const;

private:
    const nlohmann::json& value_;
    std::string key_, place_;
};

/// @brief Reads what varies. @param item an axis or a variable @return its target
[[nodiscard]] Target read_target(const Item& item);

/// @brief Reads an axis. @param item the axis @return the axis
[[nodiscard]] Axis read_axis(const Item& item);

/// @brief Reads samples. @param item the value of `samples` @return the samples
[[nodiscard]] Samples read_samples(const Item& item);

/// @brief Reads a reduction. @param item the reduction @return the reduction
[[nodiscard]] Reduction read_reduction(const Item& item);

/// @brief The most values of an axis, of bins and of probabilities.
inline constexpr std::uint64_t most_values = 10'000'000;

} // namespace denhartog::sweep
