# What the engines' tests share: a study, its results on one machine, and what must hold after a worker was killed.
# Sourced with the shared library as first argument. Needs no network but the loopback.
set -euo pipefail
export LC_ALL=C.UTF-8
python=/usr/bin/python3
$python -c 'import dask, jsonschema, netCDF4, scipy, xarray, zarr' 2>/dev/null ||
    { echo "skipped: a package is missing (Debian packages python3-xarray, -zarr, -dask, -scipy, -netcdf4, -jsonschema)"; exit 77; }
source=$(readlink -f "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../..")
export PYTHONPATH=$source/src/python PYTHONDONTWRITEBYTECODE=1
DENHARTOG_LIBRARY=$(readlink -f "$1")
export DENHARTOG_LIBRARY
scratch=$(mktemp -d)
children=()

finish() {
    for child in "${children[@]}"; do kill "$child" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$scratch"
}
trap finish EXIT

say() { echo "$(date +%T) $*"; }

free_port() { $python -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }

sweep() { $python -m denhartog.sweep "$@"; }

# Eight chunks of a second or so, each with a part in a reduction.
cat >"$scratch/study.json" <<'STUDY'
{"scene": {"mass_ratios": [1, 2, 1.5], "stiffness_ratios": [1, 0.5, 0.75], "damping_ratios": 0.03, "contact": 2, "load": 1},
 "axes": [{"quantity": "r", "from": 0.3, "to": 1.7, "count": 2400}, {"quantity": "beta", "from": 0.2, "to": 2, "count": 40}],
 "samples": {"method": "sobol", "count": 8, "seed": 1,
             "variables": [{"quantity": "zeta", "uniform": {"from": 0.01, "to": 0.05}},
                           {"quantity": "beta", "as": "factor", "lognormal": {"median": 1, "log_standard_deviation": 0.2}}]},
 "answers": ["regime", "amplitudes"],
 "reduce": [{"name": "share", "statistic": "share", "over": ["sample"]},
            {"name": "peak", "statistic": "maximum", "of": "amplitude_2", "over": ["sample", "r"]}],
 "points_of_a_chunk": 96000}
STUDY
chunks=8
sweep plan "$scratch/study.json" "$scratch/one" >/dev/null
sweep plan "$scratch/study.json" "$scratch/engine" >/dev/null
sweep run "$scratch/one" >/dev/null
sweep combine "$scratch/one" "$scratch/one.nc"
sweep combine "$scratch/one" "$scratch/one.zarr"

# What the engine runs before the command: the first to come (where there are nodes: on node two) is stopped in the middle of its
# chunk, when it has used 0.7 seconds of its processor; Python needs half of that to start.
cat >"$scratch/worker" <<WORKER
#!/bin/bash
"\$@" &
if [ "\${SLURMD_NODENAME:-\${NODE:-two}}" = two ] && mkdir "$scratch/victim" 2>/dev/null; then
    while kill -0 \$! && [ "\$(cut -d ' ' -f 14 /proc/\$!/stat)" -lt 70 ]; do sleep 0.05; done
    kill -STOP \$!
    echo "\$! \$\$ \${!#}" >"$scratch/victim/new" && mv "$scratch/victim/new" "$scratch/victim/who"
fi
wait \$!
WORKER
chmod +x "$scratch/worker"
export DENHARTOG_WORKER=$scratch/worker

# find_worker: the process that is in the middle of a chunk, and the script that started it.
find_worker() {
    for _ in $(seq 1200); do [ -f "$scratch/victim/who" ] && break || sleep 0.1; done
    read -r worker starter worker_chunk <"$scratch/victim/who"
    worker_chunk=${worker_chunk%%-*}
}

# was_in_a_chunk: right after the kill; else the test has tested nothing.
was_in_a_chunk() {
    [ ! -f "$scratch/engine/chunks/$worker_chunk.npz" ] || { say "chunk $worker_chunk was done before its worker was killed"; exit 1; }
    say "chunk $worker_chunk was not done when its worker was killed; done: $(ls "$scratch/engine/chunks" | tr '\n' ' ')"
}

# check_results: every chunk is there exactly once, and the bytes are those of one machine.
check_results() {
    sweep status "$scratch/engine"
    [ "$(find "$scratch/engine/chunks" -type f | wc -l)" = $chunks ] || { ls -A "$scratch/engine/chunks"; exit 1; }
    diff -r "$scratch/one/chunks" "$scratch/engine/chunks"
    sweep combine "$scratch/engine" "$scratch/engine.nc"
    sweep combine "$scratch/engine" "$scratch/engine.zarr"
    diff -r "$scratch/one.zarr" "$scratch/engine.zarr"
    cmp "$scratch/one.nc" "$scratch/engine.nc"
    say "every chunk is there once; the chunks, the Zarr store and the NetCDF file have the bytes of one machine"
}
