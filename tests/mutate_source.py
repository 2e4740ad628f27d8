#!/usr/bin/env python3
"""Flips one operator of a C++ file at a time, builds the nearest tests, runs them and prints the flips that survive.

    tests/mutate_source.py [--build build] [--most N] [--seed S] [FILE...]

FILE: a line of tests/data/mutated_sources.txt (all of them by default), which names the test program and its filter, and
under it the equivalents. --most takes N flips of each file, chosen by the seed. A flip that does not compile counts as
caught. Exit: 0 no survivor, 1 some survive, 2 bad input. Each flip
compiles one file and links its tests; the file gets its content back, even after an interrupt.
"""
import argparse
import os
import random
import re
import signal
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIST = os.path.join(ROOT, "tests/data/mutated_sources.txt")
LONGEST_RUN = 300  # seconds; a flip may make a loop endless

# clang-format puts spaces around binary operators and none into template arguments.
FLIPS = [(" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "), (" += ", " -= "), (" -= ", " += "),
         (" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
         (" && ", " || "), (" || ", " && "), ("std::min", "std::max"), ("std::max", "std::min"), ("(!", "("),
         ("++", "--"), ("return true;", "return false;"), ("return false;", "return true;")]


def fail(message):
    print("mutate_source: " + message, file=sys.stderr)
    sys.exit(2)


def read_list():
    """file -> (program, filter, {equivalent flips})."""
    entries = {}
    with open(LIST, encoding="utf-8") as text:
        for number, line in enumerate(text, 1):
            line = line.rstrip("\n")
            if not line.strip() or line.startswith("#"):
                continue
            if line.startswith("= "):
                entries[last][2].add(line[2:].split("   # ")[0].strip())
                continue
            words = line.split()
            if len(words) != 3:
                fail(f"{LIST}:{number}: expected FILE PROGRAM FILTER, got '{line}'")
            last = words[0]
            entries[last] = (words[1], words[2], set())
    return entries


def code_part(line):
    """The line with strings and comments blanked, at the same columns."""
    blank = lambda match: " " * len(match.group(0))
    line = re.sub(r'"(\\.|[^"\\])*"' + r"|'(\\.|[^'\\])'", lambda m: '"' + "x" * (len(m.group(0)) - 2) + '"', line)
    return re.sub(r"//.*", blank, line)


def flips_of(lines):
    """(line number, column, old, new) of every flip."""
    result = []
    for number, line in enumerate(lines):
        code = code_part(line)
        if code.lstrip().startswith("#"):
            continue
        for old, new in FLIPS:
            column = code.find(old)
            while column >= 0:
                result.append((number, column, old, new))
                column = code.find(old, column + 1)
    return result


def run(command, seconds=None):
    try:
        done = subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=seconds,
                              check=False)
        return done.returncode == 0
    except subprocess.TimeoutExpired:
        return False


def survivors_of(path, entry, arguments):
    program, test_filter, equivalents = entry
    full = os.path.join(ROOT, path)
    with open(full, encoding="utf-8") as file:
        original = file.read()
    lines = original.split("\n")
    flips = flips_of(lines)
    if arguments.most and arguments.most < len(flips):
        flips = sorted(random.Random(arguments.seed).sample(flips, arguments.most))
    build = ["ninja", "-C", arguments.build, program]
    test = [os.path.join(arguments.build, "bin", program), "--gtest_filter=" + test_filter, "--gtest_fail_fast"]
    if not run(build) or not run(test, LONGEST_RUN):
        fail(f"{path}: expected that {program} {test_filter} builds and passes before any flip, but it does not")
    survivors = 0
    try:
        for number, column, old, new in flips:
            line = lines[number]
            flipped = line[:column] + new + line[column + len(old):]
            with open(full, "w", encoding="utf-8") as file:
                file.write("\n".join(lines[:number] + [flipped] + lines[number + 1:]))
            caught = not run(build) or not run(test, LONGEST_RUN)
            known = flipped.strip() in equivalents
            verdict = "caught" if caught else "equivalent" if known else "SURVIVES"
            survivors += 0 if caught or known else 1
            print(f"{verdict:<11}{path}:{number + 1}: {flipped.strip()}", flush=True)
    finally:
        with open(full, "w", encoding="utf-8") as file:
            file.write(original)
    return survivors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*")
    parser.add_argument("--build", default="build")
    parser.add_argument("--most", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(2))  # so that the file gets its content back
    entries = read_list()
    survivors = 0
    for path in arguments.files or entries:
        if path not in entries:
            fail(f"{path}: expected a file of {LIST}: {' '.join(entries)}")
        if not run(["git", "diff", "--quiet", "--", path]):
            fail(f"{path}: expected a file without uncommitted changes, got one with some")
        survivors += survivors_of(path, entries[path], arguments)
    print(f"mutate_source: {survivors} survive", file=sys.stderr)
    sys.exit(1 if survivors else 0)


main()
