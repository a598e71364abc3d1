#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;

TEST_CASE("a table finds every kind of claim that is wrong", "[program]") {
    const std::string right = R"(
        0 solve --json < two > "regime"
          = {"regime": "stick_slip", "r": 0.5, "rest_interval": null, "method": "keys model precision proved why",
             "masses": "# 2"}
          = {"contact": {"amplitude": "> 0"}, "stops": {"*": {"start": ">= 0"}, "0": {"end": "< 7"}}, "beta": "~ 0.5 1e-9"}
          = {"regime": "longer 9", "r": "number", "method": {"model": "has exact"}}
        0 solve --samples 4 < two
          | # 5
          | tau,x_1,x_2,v_1,v_2
        2 solve --ask {colour|weight} < two ! {}
        2 solve --json < two + two {"r": -1}
          = {"0": {"regime": "text"}, "1": {"error": {"quantity": "r"}}}
    )";
    CHECK(faults_of(right).empty());
    using Pair = std::pair<std::string, std::string>;
    for (const auto& [from, to] : {Pair{"0 solve --json", "3 solve --json"},
                                   {"> \"regime\"", "> \"regimes\""},
                                   {"\"stick_slip\"", "\"continuous\""},
                                   {"\"r\": 0.5", "\"r\": 0.75"},
                                   {"\"rest_interval\"", "\"stops\""},
                                   {"keys model precision", "keys precision model"},
                                   {"\"# 2\"", "\"# 3\""},
                                   {"\"> 0\"", "\"> 9\""},
                                   {"\">= 0\"", "\">= 9\""},
                                   {"\"< 7\"", "\"< 0\""},
                                   {"~ 0.5", "~ 0.6"},
                                   {"longer 9", "longer 99"},
                                   {"\"number\"", "\"text\""},
                                   {"has exact", "has closed"},
                                   {"| # 5", "| # 6"},
                                   {"| tau", "| t"},
                                   {"2 solve --ask", "0 solve --ask"},
                                   {"! {}", "! sound"},
                                   {"\"quantity\": \"r\"", "\"quantity\": \"mu\""},
                                   {"\"*\"", "\"9\""},
                                   {"solve --ask {colour|weight}", "solve --ask {colour|regime}"}}) {
        std::string wrong = right;
        REQUIRE(wrong.find(from) != std::string::npos);
        wrong.replace(wrong.find(from), from.size(), to);
        INFO(to);
        CHECK_FALSE(faults_of(wrong).empty());
    }
    CHECK_FALSE(faults_of("0 solve --samples 4 < restless").empty()); // it has an error that is not told of
}

TEST_CASE("a bad scene gives one line that names quantity and rule, status 2 and no output", "[program][input]") {
    expect(R"(
        2 < unequal {"mass_ratios": []}                       ! mass_ratios
        2 < unequal {"mass_ratios": [1, -2]}                  ! mass_ratios      ! -2
        2 < unequal {"mass_ratios": [1, 0]}                   ! mass_ratios      ! positive
        2 < unequal {"stiffness_ratios": [1, -3]}             ! stiffness_ratios ! -3
        2 < unequal {"stiffness_ratios": [1, 0]}              ! stiffness_ratios ! positive
        2 < unequal {"stiffness_ratios": [1]}                 ! stiffness_ratios ! 2
        2 < unequal {"r": 0}                                  ! r must           ! positive
        2 < unequal {"r": -0.5}                               ! r must           ! -0.5
        2 < unequal {"r": "inf"}                              ! r must           ! inf
        2 < unequal {"r": "half"}                             ! r must           ! half
        2 < unequal {"r": [0.5]}                              ! r must
        2 < unequal {"r": null}                               ! r must be given
        2 < unequal {"damping_ratios": [0.25, -0.125]}        ! damping_ratios   ! -0.125
        2 < unequal {"damping_ratios": [0.25, 1e301]}         ! damping_ratios   ! at most 1e300
        2 < unequal {"damping_ratios": [0.25, "inf"]}         ! damping_ratios   ! inf
        2 < unequal {"damping_ratios": [0.25, 0.125, 0.5]}    ! damping_ratios   ! 2
        2 < unequal {"mu": 0.5}                               ! mu               ! 0.5
        2 < unequal {"mu": null, "mue": 1.5}                  ! mue
        2 < unequal {"contact": 0}                            ! contact          ! 0
        2 < unequal {"contact": 3}                            ! contact          ! 3
        2 < unequal {"contact": 1.5}                          ! contact          ! 1.5
        2 < unequal {"load": 3}                               ! load             ! 3
        2 < unequal {"beta": -0.0625}                         ! beta             ! -0.0625
        2 < unequal {"beta": "nan"}                           ! beta             ! nan
        2 < matrices {"mass_matrix": [[1, 2], [2, 1]]}        ! mass_matrix      ! positive definite
        2 < matrices {"stiffness_matrix": [[1, -1], [-1, 1]]} ! stiffness_matrix
        2 << {"mu": 1.5, "mu": 1.5}                           ! mu               ! once
        2 << {"mass_ratios": [1], "r": 1e999}                 ! r must           ! 1e999
        2 << {"mass_ratios": [1], "beta": NaN}                ! scene            ! JSON
        2 << {"mass_ratios": [1, 2], "stiffness_ra            ! scene            ! JSON
        2 << [1, 2]                                           ! scene
        2                                                     ! scene
    )",
           "{response --json|response|motion|boundary --json|functions --json}");
    expect("0 response < unequal");
}

TEST_CASE("a file that cannot be read is named", "[program][input]") {
    expect("2 response " + (scratch() / "missing.json").string() + " ! missing.json cannot be read\n" + //
           "2 response " + scratch().string() + " ! cannot be read\n" +                                 //
           "0 response < unequal");
    const std::string output =
        run_program("response --json '" + file_with("good.json", scene_text("unequal")).string() + "'").output;
    CHECK(output.size() > 100);
    for (const char* standard_input : {"response --json -", "response --json"})
        CHECK(run_program(standard_input, scene_text("unequal")).output == output);
}

TEST_CASE("an output that cannot be written is an error", "[program][input]") {
    expect("2 {response|response --json|boundary|functions|motion|motion --output /dev/full|--help} >/dev/full < unequal ! "
           "cannot be written\n"
           "2 motion --output " +
           (scratch() / "no" / "such" / "file").string() + " < unequal ! cannot be written");
}

TEST_CASE("a file is written whole or not at all", "[program][input]") {
    const auto file = scratch() / "motion.csv";
    expect("0 motion --output '" + file.string() + "' < unequal");
    const std::string before = content_of(file);
    CHECK(lines_of(before).size() == 401);
    expect("2 motion --output '" + file.string() + "' < unequal {\"beta\": 100}");
    CHECK(content_of(file) == before);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch()))
        files += entry.path().string().find("motion.csv") != std::string::npos;
    CHECK(files == 1);
}

TEST_CASE("wrong usage has status 2 and one line", "[program][input]") {
    expect("2 {|respond|response --no-such-option|response --digits many|response --digits 0|response --digits 100001|"
           "motion --samples many|response one two} < unequal");
}

TEST_CASE("help and version are everywhere", "[program]") {
    expect(R"(
        0 {response|motion|boundary|functions|equations|derive} --help > Usage: denhartog {}
        0 --help    > Usage: denhartog
        0 --version > denhartog  > built by
    )");
}

TEST_CASE("at a pole of a mode without damping the fault is the scene's r", "[program][domain]") {
    expect(
        "2 {response --json|boundary|functions|motion} < undamped {\"r\": 1, \"beta\": 0.125} ! mode 1 has no damping and R = 1");
}
