# From ctest's JUnit file: a line for every program of tests, then "N passed, N failed, N skipped". A check that prints no count
# is one test.
/<testcase / {
    name = $0; sub(/.*<testcase name="/, "", name); sub(/" .*/, "", name)
    status = $0; sub(/.* status="/, "", status); sub(/".*/, "", status)
    counted = 0; p = 0; f = 0; s = 0
}
match($0, /[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$/) {
    split(substr($0, RSTART), word, " "); p = word[1]; f = word[3]; s = word[5]; counted = 1
}
/<skipped message="SKIP_RETURN_CODE/ { s = 1 }
/<\/testcase>/ {
    if (status == "run" && !counted) p = 1
    if (status != "run" && f == 0 && (counted || s == 0)) f = 1
    if (counted) print name ": " p " passed, " f " failed, " s " skipped"
    if (!counted) { checks += p; other_failed += f; other_skipped += s }
    passed += p; failed += f; skipped += s
}
END {
    print "other checks: " checks + 0 " passed, " other_failed + 0 " failed, " other_skipped + 0 " skipped"
    print passed + 0 " passed, " failed + 0 " failed, " skipped + 0 " skipped"
    exit failed > 0 || passed == 0
}
