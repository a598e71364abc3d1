"""Studies beyond one machine: a scene over a grid and random samples, in chunks that any scheduler runs.

    python3 -m denhartog.sweep plan STUDY FOLDER           # writes the folder: the grid, the samples, scripts
    python3 -m denhartog.sweep run FOLDER [--chunk K ...] [--jobs N | --scheduler ADDRESS]
    python3 -m denhartog.sweep status FOLDER
    python3 -m denhartog.sweep combine FOLDER RESULT       # RESULT.zarr or RESULT.nc

A study is a JSON file, docs/study.schema.json. In Python `dataset(study)` is the same as a lazy xarray.Dataset.
Exit status: 0 done; 1 chunks are missing or damaged; 2 a value breaks a rule, or a file cannot be written; 128 plus a signal.
"""
from __future__ import annotations

import argparse
import concurrent.futures
import contextlib
import functools
import hashlib
import io
import json
import operator
import os
import pathlib
import shlex
import shutil
import signal
import sys
import threading
import time
import uuid
from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Union

import numpy as np

from . import _library, _study
from ._errors import Cancelled, Error, InputError
from ._results import REGIMES, STATUSES
from ._study import Arrays, Plan, must

Path = Union[str, "os.PathLike[str]"]
MOST_TASKS = 1000  # Slurm takes indices of an array below MaxArraySize, which is 1001 unless a cluster sets it


# ---- a study as a lazy dataset -----------------------------------------------------------------------------------------------

def dataset(study: Mapping[str, Any], grid: Any = None) -> Any:
    """A study as a lazy xarray.Dataset: Dask computes its chunks, and the reductions in them, where and when you ask for numbers.

    Parameters
    ----------
    study : mapping
        As docs/study.schema.json has it.
    grid : xarray.Dataset, optional
        In place of the study's `axes` and `samples`: a coordinate for each axis, and a variable over the dimension `sample` for
        each quantity that is drawn; their names are those in the results, such as `r`, `zeta_2`, `mass_factor`.

    Returns
    -------
    xarray.Dataset
        The answers over all axes, and each reduction over the axes that it leaves.
    """
    plan = _study.plan_of(study, grid)
    return _assembled(plan, _fingerprint(plan), _study.computed, plan)


def _assembled(plan: Plan, name_of_study: str, function: Callable[..., Arrays], source: Any) -> Any:
    """The dataset whose chunk K is function(source, K). The names of all tasks, and so their order, follow from the study."""
    import dask.array
    import xarray
    from dask.highlevelgraph import HighLevelGraph
    chunk, shared = f"chunk-{name_of_study}", f"source-{name_of_study}"
    tasks = {(chunk, K): (function, shared, K) for K in range(plan.chunks)} | {shared: source}
    sizes = dict(zip(plan.axes, dask.array.core.normalize_chunks(plan.chunk, plan.shape)))

    def stored(name: str, dtype: Any, axes: list[str], over: tuple[int, ...] = (), *further: int) -> Any:
        """What all chunks have under a name; of the axes that it is over, a chunk has one place."""
        layer = f"{name}-{name_of_study}"
        blocks = [(1,) * len(sizes[axis]) if n in over else sizes[axis] for n, axis in enumerate(axes)] + [(n,) for n in further]
        pieces = {(layer, *place): (operator.getitem, (chunk, K), name) for K, place in enumerate(np.ndindex(*map(len, blocks)))}
        graph = HighLevelGraph({chunk: tasks, layer: pieces}, {chunk: set(), layer: {chunk}})
        return dask.array.Array(graph, layer, blocks, dtype)

    coordinates = {name: xarray.Variable(name, values) for name, values in plan.axes.items()}
    data = {name: xarray.Variable("sample", values) for name, values in plan.drawn.items()}
    for name in _study.answers_of(plan.study):
        values = stored(name, _study.KINDS.get(name, np.float64), list(plan.axes))
        data[name] = xarray.Variable(list(plan.axes), values, _attributes(plan, name))
    for r in plan.study["reduce"]:
        name, statistic, (axes, over, _) = r["name"], r["statistic"], plan.axes_of(r)
        bins = np.insert(_study.edges_of(r), 0, -np.inf) if "bins" in r else np.arange(4)
        further = {"share": [xarray.Variable("regime_class", bins, _flags([0, 1, 2, 3], [*REGIMES, "none"]))],
                   "histogram": [xarray.Variable(f"{name}_bin", bins, {
                       "long_name": "lower end of the bin; the first is open below, the last above"})],
                   "quantiles": [xarray.Variable(f"{name}_probability", np.array(r.get("probabilities", ()), dtype=float))],
                   }.get(statistic, [])
        if statistic == "share" or "bins" in r:
            kinds, more = {"counts": np.int64}, [bins.size]
        else:
            kinds, more = {"value": np.float64} | ({} if further else {"place": np.int64}), [each.size for each in further]
        parts = {kind: stored(f"{name}:{kind}", dtype, axes, over, *more) for kind, dtype in kinds.items()}
        coordinates |= {each.dims[0]: each for each in further}
        for result, values in _study.finished(plan, r, parts).items():
            about = {"over": " ".join(r["over"])} | ({"of": r["of"]} if "of" in r else {}) if result == name else {}
            data[result] = xarray.Variable([*plan.names_of(name), *(each.dims[0] for each in further)], values, about)
    return xarray.Dataset(data, coordinates, {"program": f"denhartog {_library.library().dh_version().decode()}"})


def _flags(values: list[int], meanings: Iterable[str]) -> dict[str, Any]:
    return {"flag_values": values, "flag_meanings": " ".join(meanings)}


def _attributes(plan: Plan, name: str) -> dict[str, Any]:
    length = "unit of length of the scene" if {"friction"} & {*plan.axes, *plan.drawn} else "P / k_1"
    return {"status": _flags([0, 1, 2, 3, 4, 5], [*STATUSES, "no_scene"]), "regime": _flags([0, 1, 2], REGIMES),
            "amplitude": {"units": length}, "phase": {"units": "radians behind the force"}}.get(name.split("_")[0], {})


# ---- the folder of a study ---------------------------------------------------------------------------------------------------

def plan(study: Mapping[str, Any], folder: Path, grid: Any = None) -> Plan:
    """Divides a study into chunks and writes its folder: study.json, the grid, the samples, and scripts that run the chunks."""
    planned, folder = _study.plan_of(study, grid), pathlib.Path(folder)
    about = {"study": planned.study, "chunk": planned.chunk, "chunks": planned.chunks, "points": int(np.prod(planned.shape)),
             "fingerprint": _fingerprint(planned)}
    same = _about(folder).get("fingerprint") == about["fingerprint"]
    must(not folder.exists() or same or (folder.is_dir() and not any(folder.iterdir())), "FOLDER",
         "must be a new folder, or that of the same study planned by the same program", folder)
    try:
        for name in ("chunks", "log"):
            (folder / name).mkdir(parents=True, exist_ok=True)
    except OSError as reason:
        raise InputError.of("FOLDER", "must be a folder that can be written", f"{folder} ({reason.strerror})") from reason
    _write(folder / "grid.npz", _as_bytes(planned.axes))
    _write(folder / "samples.npz", _as_bytes(planned.drawn))
    for name, text in _scripts(folder.resolve(), planned.chunks).items():
        _write(folder / name, text.encode())
        (folder / name).chmod(0o755)
    _write(folder / "study.json", (json.dumps(about, indent=1) + "\n").encode())  # last: with it the folder is one of a study
    return planned


def _scripts(folder: pathlib.Path, chunks: int) -> dict[str, str]:
    block = -(-chunks // MOST_TASKS)
    call = f"{shlex.quote(sys.executable)} -m denhartog.sweep run {shlex.quote(str(folder))}"
    return {"slurm.sh": f"""#!/bin/bash
# sbatch slurm.sh: an array job; each task runs a block of chunks. Slurm queues a task again if its node is lost.
#SBATCH --job-name=denhartog-sweep
#SBATCH --array=0-{-(-chunks // block) - 1}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output="{folder}/log/slurm-%A_%a.txt"
first=$((SLURM_ARRAY_TASK_ID * {block}))
last=$((first + {block - 1} < {chunks} ? first + {block - 1} : {chunks - 1}))
exec ${{DENHARTOG_WORKER:-}} {call} --chunk "$first-$last"
""", "parallel.sh": f"""#!/bin/bash
# parallel.sh [OPTION OF GNU PARALLEL...]: e.g. --jobs 8, or --sshloginfile FILE for machines that share this folder.
seq 0 {chunks - 1} | exec parallel --retries 5 --joblog {shlex.quote(f"{folder}/log/parallel.txt")} \\
    --env PYTHONPATH --env DENHARTOG_LIBRARY "$@" ${{DENHARTOG_WORKER:-}} {shlex.quote(call)} --chunk {{}}
"""}


def _about(folder: pathlib.Path) -> dict[str, Any]:
    try:
        about = json.loads((folder / "study.json").read_text(encoding="utf-8"))
        return about if isinstance(about, dict) else {}
    except (OSError, ValueError):
        return {}


def opened(folder: Path) -> tuple[Plan, str]:
    """The plan of a folder and its fingerprint; refused if another program made it, or if it was altered since."""
    folder = pathlib.Path(folder)
    about = _about(folder)
    must(about.keys() >= {"study", "chunk", "fingerprint"}, "FOLDER", "must be one that `plan` has written", folder)
    try:
        axes, drawn = (_as_arrays((folder / name).read_bytes()) for name in ("grid.npz", "samples.npz"))
    except (OSError, ValueError, KeyError, EOFError) as reason:
        raise InputError.of("FOLDER", "must have grid.npz and samples.npz as `plan` wrote them", reason) from reason
    planned = Plan(about["study"], axes, drawn, tuple(about["chunk"]))
    must(_fingerprint(planned) == about["fingerprint"], "the plan",
         "must be of the same program and the same study (plan it anew)", f"another: {folder}")
    return planned, about["fingerprint"]


@functools.lru_cache(maxsize=None)
def _program() -> bytes:
    """A checksum of the library and of what computes with it here."""
    _library.library()
    with open("/proc/self/maps", encoding="utf-8") as maps:
        library = next(line.split(maxsplit=5)[-1].rstrip("\n") for line in maps if "libdenhartog.so" in line)
    files = [pathlib.Path(library), *sorted(pathlib.Path(__file__).parent.glob("*.py"))]
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).digest()


def _fingerprint(planned: Plan) -> str:
    text = json.dumps([planned.study, planned.chunk, list(planned.axes), list(planned.drawn)], sort_keys=True)
    found = hashlib.sha256(_program() + text.encode())
    for values in [*planned.axes.values(), *planned.drawn.values()]:
        found.update(np.ascontiguousarray(values).tobytes())
    return found.hexdigest()


def _as_bytes(arrays: Arrays) -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    return buffer.getvalue()


def _as_arrays(content: bytes) -> Arrays:
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        return dict(file)


@contextlib.contextmanager
def _whole(path: pathlib.Path) -> Iterator[pathlib.Path]:
    """Another name for a file or a folder that is written: in its place it is there whole or not at all."""
    part = path.with_name(f".{path.name}.{uuid.uuid4().hex}.part")
    try:
        yield part
        os.replace(part, path)
    except (OSError, RuntimeError) as reason:  # the latter is netCDF4's
        raise Error(f"{path} cannot be written ({getattr(reason, 'strerror', None) or reason})") from reason
    finally:
        shutil.rmtree(part) if part.is_dir() else part.unlink(missing_ok=True)


def _write(path: pathlib.Path, content: bytes) -> None:
    with _whole(path) as part, open(part, "xb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())


# ---- chunks ------------------------------------------------------------------------------------------------------------------

def _path(folder: Path, K: int) -> pathlib.Path:
    return pathlib.Path(folder) / "chunks" / f"{K}.npz"


def _fault(folder: Path, K: int, fingerprint: str, whole: bool = True) -> Optional[str]:
    """What is wrong with a chunk; None where nothing is, and "missing" where it is not there. `whole` reads all of it."""
    try:
        with open(_path(folder, K), "rb") as file:
            head = json.loads(file.readline(512))
            content = file.read() if whole else b""
    except FileNotFoundError:
        return "missing"
    except ValueError:
        return "its file cannot be read"
    if not isinstance(head, dict) or head.get("fingerprint") != fingerprint or head.get("chunk") != K:
        return "it was left by another program or another study"
    if whole and head.get("sha256") != hashlib.sha256(content).hexdigest():
        return "its file was truncated or altered"
    return None


def _loaded(folder: Path, K: int) -> Arrays:
    return _as_arrays(_path(folder, K).read_bytes().split(b"\n", 1)[1])


def run_chunk(folder: Path, K: int, stop: Optional[threading.Event] = None) -> bool:
    """Computes chunk K unless it is there already, and says whether it did.

    Its file has a line in JSON that says which chunk this is of which study, with a checksum; then the arrays.
    """
    planned, fingerprint = opened(folder)
    fault = _fault(folder, K, fingerprint)
    if fault is None:
        return False
    if fault != "missing":
        print(f"chunk {K} is computed again: {fault}", file=sys.stderr, flush=True)
    content = _as_bytes(_study.computed(planned, K, None if stop is None else lambda done, of: stop.is_set()))
    head = {"chunk": K, "fingerprint": fingerprint, "sha256": hashlib.sha256(content).hexdigest()}
    _write(_path(folder, K), json.dumps(head).encode() + b"\n" + content)
    return True


def run(folder: Path, chunks: Optional[Iterable[int]] = None, jobs: int = 1, scheduler: Optional[str] = None,
        told: Callable[[int, int, float], Any] = lambda done, of, seconds: None) -> tuple[int, int]:
    """Computes the chunks that are not there, all of them or those named.

    Parameters
    ----------
    jobs : int
        How many at once, in threads of this process; or
    scheduler : str
        the address of a scheduler of dask.distributed, whose workers share the folder and compute them.
    told : callable
        Called as ``told(done, of, seconds)`` after each chunk, with the seconds that those left will take at this pace.

    Returns
    -------
    tuple of int
        How many were computed, and how many were there before.
    """
    planned, _ = opened(folder)
    wanted = list(range(planned.chunks)) if chunks is None else list(dict.fromkeys(chunks))
    computed, start = [], time.monotonic()
    with contextlib.closing(_results(os.path.abspath(folder), wanted, jobs, scheduler)) as results:
        for done, was_computed in enumerate(results, 1):
            computed.append(was_computed)
            pace = (time.monotonic() - start) / max(sum(computed), 1)
            told(done, len(wanted), pace * (len(wanted) - done))
    return sum(computed), len(wanted) - sum(computed)


def _results(folder: str, wanted: list[int], jobs: int, scheduler: Optional[str]) -> Iterator[bool]:
    """What `run_chunk` returns for each chunk, in the order in which they end."""
    if scheduler is not None:
        import distributed
        with distributed.Client(scheduler) as client:
            for future in distributed.as_completed([client.submit(run_chunk, folder, K, pure=False, retries=5) for K in wanted]):
                yield future.result()
        return
    stop = threading.Event()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = [pool.submit(run_chunk, folder, K, stop) for K in wanted]
        try:
            for future in concurrent.futures.as_completed(futures):
                yield future.result()
        except BaseException:  # Ctrl-C too: chunks that are under way end at their next column, and leave nothing
            stop.set()
            pool.shutdown(wait=True, cancel_futures=True)
            raise


def faults(folder: Path, whole: bool = True) -> dict[str, list[int]]:
    """The chunks of a folder that are not there as they must be, by what is wrong with them."""
    planned, fingerprint = opened(folder)
    found: dict[str, list[int]] = {}
    for K in range(planned.chunks):
        fault = _fault(folder, K, fingerprint, whole)
        if fault is not None:
            found.setdefault(fault, []).append(K)
    return found


def combine(folder: Path, to: Path) -> None:
    """Checks that every chunk is there once, and writes all results by xarray into a Zarr store or a NetCDF file.

    Raises
    ------
    InputError
        The name does not end in .zarr or .nc, or is taken.
    Incomplete
        A chunk is missing, damaged, or of another study; a file is no chunk's.
    """
    import dask
    import xarray
    folder, to = pathlib.Path(folder), pathlib.Path(to)
    must(to.suffix in (".zarr", ".nc"), "RESULT", "must end in .zarr or .nc", to)
    must(not to.exists(), "RESULT", "must not be there yet", to)
    must(to.parent.is_dir() or to.suffix == ".zarr", "RESULT", "must be in a folder that is there", to)
    planned, fingerprint = opened(folder)
    wrong = [f"{_ranges(chunks)}: {fault}" for fault, chunks in faults(folder).items()]
    known = {f"{K}.npz" for K in range(planned.chunks)}
    wrong += [f"chunks/{file.name} is a file that no chunk of this plan wrote" for file in sorted((folder / "chunks").iterdir())
              if file.name not in known and not file.name.endswith(".part")]
    if wrong:
        raise Incomplete("nothing is combined; chunks that are not as they must be: " + "; ".join(wrong))
    for file in (folder / "chunks").glob(".*.part"):  # of a run that was killed while it wrote
        file.unlink(missing_ok=True)
    results = _assembled(planned, fingerprint, _loaded, str(folder))
    with _whole(to) as part, dask.config.set(scheduler="synchronous"):
        if to.suffix == ".zarr":
            plain = {name: {"compressor": None} for name in results.variables}  # Blosc's bytes depend on its threads
            results.to_zarr(part, consolidated=True, encoding=plain)
        else:  # one array after the other: the bytes of the file depend on the order in which they are written
            results.drop_vars(results.data_vars).to_netcdf(part, engine="netcdf4")
            for name in results.data_vars:
                xarray.Dataset({name: results[name].variable}).to_netcdf(part, mode="a", engine="netcdf4")


class Incomplete(Error):
    """Chunks are missing, damaged, or of another study."""


# ---- the command -------------------------------------------------------------------------------------------------------------

def _ranges(numbers: list[int]) -> str:
    """Ascending numbers as a text: 0-3, 7."""
    pieces = np.split(numbers, np.flatnonzero(np.diff(numbers) != 1) + 1)
    listed = [str(each[0]) if each.size == 1 else f"{each[0]}-{each[-1]}" for each in pieces]
    return ", ".join(listed[:12] + ["..."] * (len(listed) > 12))


def _bar(done: int, of: int) -> str:
    return f"[{'#' * (40 * done // of):.<40}] {100 * done // of:3d} %  {done} of {of} chunks"


def _duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"


def _numbers(texts: list[str], chunks: int) -> Iterator[int]:
    for text in texts:
        ends = text.split("-") if text.isascii() else []
        must(len(ends) in (1, 2) and all(end.isdigit() and int(end) < chunks for end in ends) and int(ends[0]) <= int(ends[-1]),
             "--chunk", f"must be a number from 0 to {chunks - 1}, or two with a hyphen, the lower first", text[:64])
        yield from range(int(ends[0]), int(ends[-1]) + 1)


def _run_command(options: argparse.Namespace) -> None:
    must(options.jobs >= 1, "--jobs", "must be at least 1", options.jobs)

    def told(done: int, of: int, seconds: float) -> None:
        print(f"\r{_bar(done, of)}, {_duration(seconds)} left   ", end="\n" if done == of else "", file=sys.stderr, flush=True)

    chunks = None if options.chunk is None else list(_numbers(options.chunk, opened(options.folder)[0].chunks))
    done = run(options.folder, chunks, options.jobs, options.scheduler, *([told] if sys.stderr.isatty() else []))
    print(f"chunks: {done[0]} computed, {done[1]} done before")


def _status_command(options: argparse.Namespace) -> None:
    planned, _ = opened(options.folder)
    wrong = faults(options.folder, whole=False)
    done = planned.chunks - sum(map(len, wrong.values()))
    ends = sorted(file.stat().st_mtime for file in (pathlib.Path(options.folder) / "chunks").glob("*.npz"))
    pace = (ends[-1] - ends[0]) / (len(ends) - 1) if len(ends) > 1 else 0
    left = f", {_duration(pace * (planned.chunks - done))} left" if pace and wrong else ""
    print(_bar(done, planned.chunks) + left, *(f"{fault}: {_ranges(chunks)}" for fault, chunks in wrong.items()), sep="\n")


def _plan_command(options: argparse.Namespace) -> None:
    try:
        text = sys.stdin.read() if options.study == "-" else pathlib.Path(options.study).read_text(encoding="utf-8")
    except (OSError, ValueError) as reason:
        raise InputError.of("STUDY", "must be a file that can be read", f"{options.study} ({reason})") from reason
    planned = plan(_study.read(text), options.folder)
    print(f"{int(np.prod(planned.shape))} points in {planned.chunks} chunks of at most {int(np.prod(planned.chunk))} points\n"
          f"next: python3 -m denhartog.sweep run {options.folder}, or a script in it: slurm.sh, parallel.sh")


def main(arguments: Optional[list[str]] = None) -> int:
    """The command line; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python3 -m denhartog.sweep", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    told = {"plan": ("divide a study into chunks and write its folder", _plan_command),
            "run": ("compute the chunks that are not there", _run_command), "status": ("how much is done", _status_command),
            "combine": ("check that every chunk is there once, and write all results",
                        lambda options: combine(options.folder, options.result))}
    added = {name: commands.add_parser(name, help=text, description=text) for name, (text, _) in told.items()}
    added["plan"].add_argument("study", metavar="STUDY", help="the study as JSON; - for standard input")
    for name, command in added.items():
        command.add_argument("folder", metavar="FOLDER", help="the folder of the study")
        command.set_defaults(action=told[name][1])
    added["run"].add_argument("--chunk", action="append", metavar="K", help="this chunk, or a range such as 20-29; default all")
    added["run"].add_argument("--jobs", type=int, default=1, metavar="N", help="chunks at once (default 1)")
    added["run"].add_argument("--scheduler", metavar="ADDRESS", help="a scheduler of dask.distributed, e.g. tcp://127.0.0.1:8786")
    added["combine"].add_argument("result", metavar="RESULT", help="a Zarr store (.zarr) or a NetCDF file (.nc)")
    options = parser.parse_args(arguments)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, lambda number, _: sys.exit(128 + number))
    try:
        options.action(options)
        sys.stdout.flush()
        return 0
    except (Error, OSError, ImportError) as reason:
        print(f"denhartog.sweep: {reason}", file=sys.stderr)
        return 1 if isinstance(reason, (Incomplete, Cancelled)) else 2


if __name__ == "__main__":
    from denhartog import sweep  # under its name, by which workers elsewhere find its functions
    os._exit(sweep.main())  # at once: at the regular end netCDF4 touches a file again that could not be written, and crashes
