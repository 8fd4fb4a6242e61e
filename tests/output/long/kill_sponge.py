#!/usr/bin/env python3
"""Kills the sponge at random moments until it has died a hundred times, and compares what the restarted runs leave with
what one uninterrupted run leaves: the same bytes in the table, the last checkpoint and every file for ParaView. In turn
for the sound composition in float, the same in double, and the paper's composition; runs that are killed compute with
two threads, the one that they are compared with with one.

    python3 tests/output/long/kill_sponge.py build/sponge [--kills 100] [--seed 1] [--case "sound, float"]

After each kill every file that carries its final name must be whole; the run goes on from its checkpoint or, three times
out of ten where there are two, from the one before, so that both are read. Before that
the same is asked of a run that Ctrl-C ends, and of one whose last checkpoint is damaged, that goes on from the one
before and is killed at once.
"""
import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

CASES = {"sound, float": ["--composition", "sound", "--precision", "float"],
         "sound, double": ["--composition", "sound", "--precision", "double"],
         "paper, float": ["--composition", "paper", "--precision", "float"]}
RUN = ["--quick", "--end", "0.05", "--snapshots", "5"]
# Without its tools the sponge draws no pictures, which would take longer than most of these runs live.
SURROUNDINGS = {**os.environ, "IMBIBE_TOOLS": "none"}


def command(sponge, folder, *more, threads=2, checkpoints=0.3):
    """`sponge`: the program and its case; `checkpoints`: seconds between two."""
    return [*sponge, *RUN, "--threads", str(threads), "--output", str(folder), "--checkpoints", str(checkpoints), *more]


def fail(words):
    sys.exit(f"kill_sponge: {words}")


def results(folder):
    """What must be the same: name -> bytes. Pictures are drawn from these, and left out."""
    files = sorted(f for f in folder.iterdir() if f.suffix in (".csv", ".vtp", ".pvd") or f.name == "checkpoint")
    return {f.name: f.read_bytes() for f in files}


def check_whole(folder):
    """Files for ParaView end as they should, and what a series lists is there."""
    for file in folder.glob("*.vt?"):
        if not file.read_bytes().rstrip().endswith(b"</VTKFile>"):
            fail(f"{file} is not whole")
    for series in folder.glob("*.pvd"):
        words = series.read_text()
        if not words.rstrip().endswith("</VTKFile>"):
            fail(f"{series} is not whole")
        for part in words.split('file="')[1:]:
            if not (folder / part.split('"')[0]).exists():
                fail(f"{series} lists {part.split(chr(34))[0]}, which is not there")


def run_with_kills(sponge, folder, chance, most, longest):
    """Runs to the end through at most `most` kills; how many there were, and how many starts had no checkpoint."""
    kills = fresh_starts = 0
    has_checkpoint = False
    while True:
        had_one, has_checkpoint = has_checkpoint, (folder / "checkpoint").exists()
        if had_one and not has_checkpoint:
            fail(f"after {kills} kills the checkpoint that was there is gone")
        fresh_starts += not has_checkpoint
        previous = (folder / "checkpoint.previous").exists() and chance.random() < 0.3
        restart = ["--restart", *(["--previous"] if previous else [])] if has_checkpoint else []
        process = subprocess.Popen(command(sponge, folder, *restart), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   env=SURROUNDINGS)
        try:
            words, _ = process.communicate(timeout=chance.uniform(0.05, longest) if kills < most else None)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            kills += 1
            check_whole(folder)
            continue
        if process.returncode != 0:
            fail(f"after {kills} kills the run ended with {process.returncode}:\n{words.decode()[-2000:]}")
        return kills, fresh_starts


def expect_same(folder, expected, after):
    found = results(folder)
    if sorted(found) != sorted(expected):
        fail(f"after {after} there are other files: {sorted(set(found) ^ set(expected))}")
    for name, content in expected.items():
        if found[name] != content:
            shutil.copytree(folder.parent, "kill_sponge_differs", dirs_exist_ok=True)
            fail(f"after {after} {name} differs; both are in kill_sponge_differs")


def wait_until(happened, process):
    """Fails where the process ends, or a minute goes by, before that."""
    until = time.monotonic() + 60
    while not happened():
        if process.poll() is not None or time.monotonic() > until:
            process.kill()
            fail(f"what was waited for did not happen:\n{process.communicate()[0].decode()[-2000:]}")
        time.sleep(0.01)


def interrupt(sponge, folder, seconds):
    """Ctrl-C two rows of the table after the second checkpoint: the run ends by itself and says so; then its last one is
    damaged, which is refused, and the run goes on from the one before."""
    process = subprocess.Popen(command(sponge, folder, checkpoints=seconds / 3), stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, env=SURROUNDINGS)
    lines_at = {}  # by when the last checkpoint was written: how long the table was then

    def is_ahead_of_its_checkpoint():
        if not (folder / "checkpoint.previous").exists():
            return False
        written = (folder / "checkpoint").stat().st_mtime_ns
        lines = (folder / "sponge.csv").read_bytes().count(b"\n")
        return lines >= lines_at.setdefault(written, lines) + 2

    wait_until(is_ahead_of_its_checkpoint, process)
    process.send_signal(signal.SIGINT)
    words = process.communicate(timeout=60)[0].decode()
    if process.returncode == 0 or "--restart goes on from here" not in words:
        fail(f"after Ctrl-C the run ended with {process.returncode}:\n{words[-2000:]}")
    whole = shutil.copytree(folder, folder.with_name("interrupted"))
    subprocess.run(command(sponge, whole, "--restart"), check=True, stdout=subprocess.DEVNULL, env=SURROUNDINGS)
    checkpoint = folder / "checkpoint"
    content = bytearray(checkpoint.read_bytes())
    content[len(content) // 2] ^= 1
    checkpoint.write_bytes(content)
    refused = subprocess.run(command(sponge, folder, "--restart"), capture_output=True, text=True, env=SURROUNDINGS)
    if refused.returncode == 0 or "checksum is wrong" not in refused.stderr:
        fail(f"a damaged checkpoint was taken, or without a reason:\n{refused.stderr}")
    kill_behind_its_checkpoint(sponge, folder)
    subprocess.run(command(sponge, folder, "--restart"), check=True, stdout=subprocess.DEVNULL, env=SURROUNDINGS)
    return whole


def kill_behind_its_checkpoint(sponge, folder):
    """From the checkpoint before the last, until the table has lost what came after it and before a new one is written:
    the last one, which is of a longer table, must not be what the next start takes."""
    table = folder / "sponge.csv"
    size = table.stat().st_size
    process = subprocess.Popen(command(sponge, folder, "--restart", "--previous", checkpoints=1000),
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=SURROUNDINGS)
    wait_until(lambda: table.stat().st_size < size, process)
    if (folder / "checkpoint").read_bytes() != (folder / "checkpoint.previous").read_bytes():
        fail("the table was cut before its checkpoint had become the last one")
    process.kill()
    process.communicate()


def try_case(sponge, kills_asked, chance, scratch):
    """Kills, runs and starts without a checkpoint of one case."""
    whole = scratch / "whole"
    began = time.monotonic()
    subprocess.run(command(sponge, whole, threads=1), check=True, stdout=subprocess.DEVNULL, env=SURROUNDINGS)
    seconds = time.monotonic() - began
    expected = results(whole)
    if len(expected) < 10:
        fail(f"the uninterrupted run left only {sorted(expected)}")

    stopped = interrupt(sponge, scratch / "stopped", seconds)
    expect_same(stopped, expected, "Ctrl-C")
    expect_same(scratch / "stopped", expected, "damage to the last checkpoint")
    print("after Ctrl-C, and from the checkpoint before the last: the same bytes", flush=True)

    killed = runs = fresh_starts = 0
    while killed < kills_asked:
        folder = scratch / f"killed_{runs}"
        folder.mkdir()
        kills, fresh = run_with_kills(sponge, folder, chance, kills_asked - killed, seconds / 6)
        expect_same(folder, expected, f"{kills} kills")
        shutil.rmtree(folder)
        killed, runs, fresh_starts = killed + kills, runs + 1, fresh_starts + fresh
        print(f"run {runs}: {kills} kills, {fresh} starts without a checkpoint, the same bytes in "
              f"{len(expected)} files", flush=True)
    return killed, runs, fresh_starts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sponge")
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--case", choices=CASES, help="this one only")
    options = parser.parse_args()
    chance = random.Random(options.seed)

    cases = {options.case: CASES[options.case]} if options.case else CASES
    killed = runs = fresh_starts = 0
    for number, (name, case) in enumerate(cases.items()):
        print(name, flush=True)
        left = -(-(options.kills - killed) // (len(cases) - number))
        with tempfile.TemporaryDirectory() as scratch:
            counts = try_case([options.sponge, *case], left, chance, Path(scratch))
        killed, runs, fresh_starts = killed + counts[0], runs + counts[1], fresh_starts + counts[2]
    print(f"{killed} kills in {runs} runs, {fresh_starts} starts without a checkpoint: every run left the same bytes as "
          "the uninterrupted one of its case")


if __name__ == "__main__":
    main()
