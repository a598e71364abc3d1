#include "denhartog/program/sweep/scripts.hpp"

namespace denhartog::program {
namespace {

// Slurm takes array indices below MaxArraySize, which is 1001 unless a cluster sets it.
constexpr std::size_t most_tasks = 1000;

// A text as a shell takes it whole.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

// A text as Python takes it whole.
std::string in_python(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

std::string for_slurm(const std::string& folder, const std::string& program, std::size_t chunks) {
    const std::size_t block = (chunks + most_tasks - 1) / most_tasks, tasks = (chunks + block - 1) / block;
    return "#!/bin/bash\n"
           "# sbatch [OPTION...] slurm.sh: an array job; each task runs a block of chunks. A task whose node is lost is queued "
           "again,\n"
           "# and finds the chunks done that were done before.\n"
           "#SBATCH --job-name=denhartog-sweep\n"
           "#SBATCH --array=0-" +
           std::to_string(tasks - 1) +
           "\n"
           "#SBATCH --ntasks=1\n"
           "#SBATCH --cpus-per-task=1\n"
           "#SBATCH --requeue\n"
           "#SBATCH --open-mode=append\n"
           "#SBATCH --output=\"" +
           folder +
           "/log/slurm-%A_%a.txt\"\n"
           "chunks=" +
           std::to_string(chunks) + " block=" + std::to_string(block) +
           "\n"
           "first=$((SLURM_ARRAY_TASK_ID * block))\n"
           "last=$((first + block - 1 < chunks ? first + block - 1 : chunks - 1))\n"
           "exec \"${DENHARTOG:-" +
           program + "}\" sweep run " + quoted(folder) + " \"$first-$last\"\n";
}

std::string for_parallel(const std::string& folder, const std::string& program, std::size_t chunks) {
    return "#!/bin/bash\n"
           "# parallel.sh [OPTION OF GNU PARALLEL...]: e.g. --jobs 8, or --sshloginfile FILE for machines that share this "
           "folder.\n"
           "# A chunk whose worker is lost is run again, and finds itself done where it was.\n"
           "seq 0 " +
           std::to_string(chunks - 1) + " |\n    exec parallel --retries 5 --joblog " + quoted(folder + "/log/parallel.txt") +
           " \"$@\" \\\n        \"${DENHARTOG:-" + program + "}\" sweep run " + quoted(quoted(folder)) + " {}\n";
}

std::string for_dask(const std::string& folder, const std::string& program, std::size_t chunks) {
    return "#!/usr/bin/env python3\n"
           "\"\"\"with_dask.py SCHEDULER: runs the chunks on the workers of a Dask scheduler, e.g. tcp://127.0.0.1:8786.\n\n"
           "A chunk whose worker is lost is given to another, and finds itself done where it was.\n\"\"\"\n"
           "import os\n"
           "import subprocess\n"
           "import sys\n\n"
           "from dask.distributed import Client, as_completed\n\n"
           "PROGRAM = os.environ.get(\"DENHARTOG\", " +
           in_python(program) +
           ")\n"
           "FOLDER = " +
           in_python(folder) +
           "\n"
           "CHUNKS = " +
           std::to_string(chunks) +
           "\n\n\n"
           "def run_chunk(chunk, program=PROGRAM, folder=FOLDER):\n"
           "    subprocess.run([program, \"sweep\", \"run\", folder, str(chunk)], check=True)\n"
           "    return chunk\n\n\n"
           "if __name__ == \"__main__\":\n"
           "    if len(sys.argv) != 2:\n"
           "        sys.exit(__doc__)\n"
           "    with Client(sys.argv[1]) as client:\n"
           "        futures = client.map(run_chunk, range(CHUNKS), pure=False, retries=5)\n"
           "        for future in as_completed(futures):\n"
           "            future.result()\n";
}

} // namespace

std::vector<Script> scripts_of(const std::string& folder, const std::string& program, std::size_t chunks) {
    return {{"slurm.sh", for_slurm(folder, program, chunks)},
            {"parallel.sh", for_parallel(folder, program, chunks)},
            {"with_dask.py", for_dask(folder, program, chunks)}};
}

} // namespace denhartog::program
