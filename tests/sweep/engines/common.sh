# What the engines' tests share: a study, its results on one machine, and what must hold after a worker was killed.
# Sourced with the program as first argument. Needs no network but the loopback.
set -euo pipefail
export LC_ALL=C.UTF-8
program=$(readlink -f "$1")
scratch=$(mktemp -d)
children=()

finish() {
    for child in "${children[@]}"; do kill "$child" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$scratch"
}
trap finish EXIT

say() { echo "$(date +%T) $*"; }

free_port() { /usr/bin/env python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }

# Eight chunks of half a second or so, each with a part in a reduction.
cat >"$scratch/study.json" <<'STUDY'
{"scene": {"mass_ratios": [1, 2, 1.5], "stiffness_ratios": [1, 0.5, 0.75], "damping_ratios": 0.03, "contact": 2, "load": 1},
 "axes": [{"quantity": "r", "from": 0.3, "to": 1.7, "count": 800}, {"quantity": "beta", "from": 0.2, "to": 2, "count": 40}],
 "samples": {"method": "sobol", "count": 8, "seed": 1,
             "variables": [{"quantity": "zeta", "uniform": {"from": 0.01, "to": 0.05}},
                           {"quantity": "beta", "as": "factor", "lognormal": {"median": 1, "log_standard_deviation": 0.2}}]},
 "answers": ["regime", "amplitudes"],
 "reduce": [{"name": "share", "statistic": "share", "over": ["sample"]},
            {"name": "peak", "statistic": "maximum", "of": "amplitude_2", "over": ["sample", "r"]}],
 "points_of_a_chunk": 32000}
STUDY
chunks=8
"$program" sweep plan "$scratch/study.json" "$scratch/one" --without-estimate >/dev/null
"$program" sweep plan "$scratch/study.json" "$scratch/engine" --without-estimate >/dev/null
"$program" sweep run "$scratch/one" --all >/dev/null
"$program" sweep merge "$scratch/one" --to "$scratch/one.nc" >/dev/null

# What the engine runs in place of the program: the same, but the first to come (where there are nodes: on node two) is stopped in the
# middle of its chunk.
cat >"$scratch/worker" <<WORKER
#!/bin/bash
"$program" "\$@" &
if [ "\${SLURMD_NODENAME:-\${NODE:-two}}" = two ] && mkdir "$scratch/victim" 2>/dev/null; then
    sleep 0.1
    kill -STOP \$!
    echo "\$! \$\$ \${!#}" >"$scratch/victim/new" && mv "$scratch/victim/new" "$scratch/victim/who"
fi
wait \$!
WORKER
chmod +x "$scratch/worker"
export DENHARTOG=$scratch/worker

# find_worker: the process that is in the middle of a chunk, and the script that started it.
find_worker() {
    for _ in $(seq 1200); do [ -f "$scratch/victim/who" ] && break || sleep 0.1; done
    read -r worker starter worker_chunk <"$scratch/victim/who"
    worker_chunk=${worker_chunk%%-*}
}

# was_in_a_chunk: right after the kill; else the test has tested nothing.
was_in_a_chunk() {
    [ ! -f "$scratch/engine/done/$worker_chunk.json" ] || { say "chunk $worker_chunk was done before its worker was killed"; exit 1; }
    say "chunk $worker_chunk was not done when its worker was killed; done: $(ls "$scratch/engine/done" | tr '\n' ' ')"
}

# check_results: every chunk is there exactly once, and the bytes are those of one machine.
check_results() {
    local records
    "$program" sweep status "$scratch/engine"
    records=$(ls "$scratch/engine/done" | sort -n | tr '\n' ' ')
    [ "$records" = "$(seq -f '%.0f.json' 0 $((chunks - 1)) | tr '\n' ' ')" ] || { say "records: $records"; exit 1; }
    "$program" sweep merge "$scratch/engine" --to "$scratch/engine.nc"
    diff -r "$scratch/one/result.zarr" "$scratch/engine/result.zarr"
    cmp "$scratch/one.nc" "$scratch/engine.nc"
    say "every chunk is there once; $(find "$scratch/engine/result.zarr" -type f | wc -l) files and the NetCDF file have the bytes of one machine"
}
