// What reasons say in words.
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/why.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

TEST_CASE("every reason has a sentence, with all its numbers in it", "[messages]") {
    for (auto n = 0; n <= static_cast<int>(Why::newton); ++n) {
        for (const double number : {0.0, 1.0}) {
            const std::string words = in_words(Reasons(static_cast<Why>(n), number, number, number, number));
            INFO(n << ": " << words);
            CHECK(words.empty() == (n == 0)); // which says what somebody else said
            CHECK(words.find_first_of("{}|") == std::string::npos);
        }
    }
}

TEST_CASE("numbers stand in a sentence as it asks for them", "[messages]") {
    CHECK(in_words({Why::mode_out_of_range, 100000}) == "mode 100000 is beyond the range of the number type");
    CHECK(in_words({Why::not_sliding, 0.1, 1e-7}) ==
          "the contact does not slide throughout: beta = 0.1 is not below beta_lim = " + number_to_text(1e-7) + ", Eq. (69)");
    CHECK(in_words({Why::can_rest, 0.123456789, 1e-4}) == "it can also rest for ever, because beta is not below 0.123");
    CHECK(in_words({Why::fast_mode, 123456.0}).find(" has 1.2e+05 times ") != std::string::npos);
    CHECK(in_words({Why::bound, true, 6, false, true}) == "the error bound guarantees the 6 digits asked for");
    CHECK(in_words({Why::bound, false, 1, true, false}) == "the error bound does not guarantee the 1 digit aimed at");
    CHECK(in_words({Why::may_depend, 3}) == "not known: a mode has no damping, and the motion may depend on the start");
    CHECK(in_words({Why::pole_by_rounding, 2, 1, true}).find("R = 1: its complex") != std::string::npos);
    CHECK(in_words({Why::pole_by_rounding, 2, 1 - 0x1p-53, false}).find(", which is 1 to the last digits") != std::string::npos);
}

TEST_CASE("reasons follow each other as sentences do", "[messages]") {
    const Reasons why = Why::in_double + Reasons(Why::bound, true, 6, false, false) + Why::but + Why::on_boundary;
    CHECK(
        in_words(why + Reasons(Why::proved, 128)) ==
        "in double: the error bound guarantees the 6 digits aimed at, but beta lies on a boundary; every number is proved, with "
        "balls of 128 bits");
    CHECK(in_words(Reasons(Why::so_many_certain, 3) + Why::no_bound + Why::end_of_brackets) ==
          "only 3 are certain (a number has no bound)");
    CHECK(in_words(Why::not_proved + Reasons("as somebody says")) == "the reference does not prove it: as somebody says");
    CHECK(in_words(Reasons()).empty());
    CHECK(PrecisionError(Why::no_bound).what() == in_words(Why::no_bound));
    CHECK(PrecisionError(why).why == why);
}
