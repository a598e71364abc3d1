/// @file
/// @brief Pages on what was drawn and measured: figures, accuracy, speed, conformance.
#pragma once

#include "equation_page.hpp"

namespace denhartog::pages {

/// @brief The list of the figures, each with its picture. @param book the run @return the page `figures_page`
[[nodiscard]] Page figures_page(const Book& book);

/// @brief The page of a figure: the picture, what to see in it, how it was made, its data. @param book the run @param figure
/// the figure
/// @return its page
[[nodiscard]] Page figure_page(const Book& book, const FigureRecord& figure);

/// @brief The closed form against its second witness, and the functions against more digits. @param book the run
/// @return the page `accuracy_page`
[[nodiscard]] Page accuracy_page(const Book& book);

/// @brief Speed against accuracy, and batches. @param book the run @return the page `speed_page`
[[nodiscard]] Page speed_page(const Book& book);

/// @brief What the conformance kit was tried on: mistakes, implementations, hostile programs, solvers. @param book the run
/// @return the page `conformance_page`
[[nodiscard]] Page conformance_page(const Book& book);

/// @brief The tables of a Markdown text as HTML: headings, tables and sentences, as the surveys write them.
/// @param markdown  the text
/// @param prefix    with which the labels of its sections begin
/// @return          text for Doxygen
/// @throws          InputError for a row that has not as many cells as its head
[[nodiscard]] std::string tables_as_html(const std::string& markdown, const std::string& prefix);

} // namespace denhartog::pages
