#include "denhartog/number/legible.hpp"

#include <new>
#include <system_error>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

TEST_CASE("text from outside is shown as UTF-8 without what a terminal obeys", "[number][input]") {
    CHECK(legible("mass_ratios") == "mass_ratios");
    CHECK(legible("m\xC3\xBC \xE2\x82\xAC \xF0\x9F\x98\x80") == "m\xC3\xBC \xE2\x82\xAC \xF0\x9F\x98\x80");
    CHECK(legible("a\x1b[31mb\n\t\x7F") == "a\\x1B[31mb\\x0A\\x09\\x7F");
    CHECK(legible(std::string("a\0b", 3)) == "a\\x00b");
    CHECK(legible("\xC2\x9B") == "\\xC2\\x9B");          // the second control block
    CHECK(legible("\xE2\x80\xAE") == "\\xE2\\x80\\xAE"); // from right to left
    CHECK(legible("\xFF\xC3\x28") == "\\xFF\\xC3(");     // no UTF-8
    CHECK(legible("\xC0\xAF\xED\xA0\x80\xF4\x90\x80\x80\xC3").find('\xC0') ==
          std::string::npos); // overlong, surrogate, beyond, cut
}

TEST_CASE("a long text loses its middle, and no character is cut", "[number][input]") {
    CHECK(legible("0123456789", 10) == "0123456789");
    CHECK(legible("0123456789a", 10) == "01234...9a");
    const std::string path = "/" + std::string(5000, 'd') + "/scene.json";
    CHECK(legible(path).size() <= most_shown);
    CHECK(legible(path).ends_with("/scene.json"));
    std::string umlauts;
    for (int n = 0; n < 1000; ++n) umlauts += "\xC3\xBC";
    for (std::size_t most = 8; most < 40; ++most) {
        const std::string shown = legible(umlauts, most);
        CHECK(shown.size() <= most);
        CHECK(shown.find('\\') == std::string::npos);
        CHECK(legible(shown, most) == shown);
    }
    CHECK(legible(std::string(10'000'000, '\x1b')).size() <= most_shown);
}

TEST_CASE("every part of an error of input is legible, and its message is short", "[number][input]") {
    const std::string evil = "\x1b[2J\xFF" + std::string(1'000'000, 'k');
    const InputError e(evil, "must be " + evil, evil, "/" + evil);
    for (const std::string& part : {std::string(e.what()), e.quantity, e.rule, e.value, e.place}) {
        CHECK(part.size() < 1300);
        CHECK(part.find('\x1b') == std::string::npos);
        CHECK(part.find('\xFF') == std::string::npos);
        CHECK(part.find("\\x1B[2J") != std::string::npos);
    }
    const InputError again(e.quantity, e.rule, e.value, e.place);
    CHECK(std::string(again.what()) == e.what());
}

TEST_CASE("what others throw is told in words of this library", "[number]") {
    const auto told = [](const auto& e) { return std::string(in_own_words(e)); };
    CHECK(told(InputError("r", "must be positive", "0")) == "r must be positive, but is 0");
    CHECK(told(DomainError("a pole")) == "a pole");
    CHECK(told(PrecisionError("no digits")) == "no digits");
    CHECK(told(std::bad_alloc()).starts_with("memory must hold"));
    CHECK(told(std::length_error("vector::_M_fill_insert")).starts_with("memory must hold"));
    CHECK(told(std::overflow_error("Error in function boost::math::expm1")).starts_with("the numbers of the computation must"));
    CHECK(is_beyond_range(std::overflow_error("")));
    CHECK_FALSE(is_beyond_range(std::bad_alloc()));
    CHECK(told(std::system_error(std::make_error_code(std::errc::io_error), "basic_filebuf")).starts_with("the system must"));
    CHECK(told(std::logic_error("a slip")).find("a slip") == std::string::npos);
}
