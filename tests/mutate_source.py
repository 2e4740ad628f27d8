#!/usr/bin/env python3
"""Flips one operator of a C++ file at a time, runs the nearest tests with it and prints the flips that survive.

    tests/mutate_source.py [--build build] [--most N] [--seed S] [FILE...]

FILE: a line of tests/data/mutated_sources.txt (all of them by default), which names the test programs and their filters,
and under it the equivalents. --most takes N flips of each file, chosen by the seed. A flip compiles a copy of the file
and links it before the libraries, so that neither the sources nor the build change. A flip that does not compile counts
as caught, one that gives the same machine code as an equivalent. Exit: 0 no survivor, 1 some survive, 2 bad input.
"""
import argparse
import collections
import json
import os
import random
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIST = os.path.join(ROOT, "tests/data/mutated_sources.txt")
MOST_MEMORY = 4 << 30  # bytes; a flip may ask for too much

# clang-format puts spaces around binary operators and none into template arguments. The last but one drops a guard.
FLIPS = [(" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "), (" % ", " * "), (" += ", " -= "), (" -= ", " += "),
         (" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
         (" && ", " || "), (" || ", " && "), ("std::min(", "std::max("), ("std::max(", "std::min("), ("(!", "("),
         ("++", "--"), ("return true;", "return false;"), ("return false;", "return true;"), ("if (", "if (false && ")]
CALL = re.compile(r"\s*([\w.:]|->)+\(.*\);$")  # a statement that is nothing but a call: a flip leaves it out

Entry = collections.namedtuple("Entry", "tests equivalents")  # [(program, filter)...], {flipped lines}


def fail(message):
    print("mutate_source: " + message, file=sys.stderr)
    sys.exit(2)


def read_list():
    """file -> Entry."""
    entries = {}
    with open(LIST, encoding="utf-8") as text:
        for number, line in enumerate(text, 1):
            line = line.rstrip("\n")
            if not line.strip() or line.startswith("#"):
                continue
            if line.startswith("= "):
                entries[last].equivalents.add(line[2:].split("   # ")[0].strip())
                continue
            last, *words = line.split()
            if not words or len(words) % 2 != 0:
                fail(f"{LIST}:{number}: expected FILE PROGRAM FILTER [PROGRAM FILTER]..., got '{line}'")
            entries[last] = Entry(list(zip(words[::2], words[1::2])), set())
    return entries


def code_part(line):
    """The line with strings and comments blanked, at the same columns."""
    blank = lambda match: " " * len(match.group(0))
    line = re.sub(r'"(\\.|[^"\\])*"' + r"|'(\\.|[^'\\])'", lambda m: '"' + "x" * (len(m.group(0)) - 2) + '"', line)
    return re.sub(r"//.*", blank, line)


def flips_of(lines):
    """(line number, flipped line) of every flip."""
    result = []
    for number, line in enumerate(lines):
        code = code_part(line)
        if code.lstrip().startswith("#"):
            continue
        for old, new in FLIPS:
            column = code.find(old)
            while column >= 0:
                result.append((number, line[:column] + new + line[column + len(old):]))
                column = code.find(old, column + 1)
        if CALL.match(code) and code.count("(") == code.count(")"):
            result.append((number, re.match(r"\s*", line).group(0) + "// left out: " + line.strip()))
    return result


def limit_memory():
    resource.setrlimit(resource.RLIMIT_DATA, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(command, folder, seconds=None, temporary=None):
    environment = dict(os.environ, TMPDIR=temporary) if temporary else None
    try:
        done = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=seconds,
                              preexec_fn=limit_memory, env=environment, check=False)
        return done.returncode == 0
    except subprocess.TimeoutExpired:
        return False


class Workshop:
    """Compiles copies of one file and runs its tests with them, in a folder of its own."""

    def __init__(self, build, path, tests, folder):
        self.build, self.tests, self.folder = build, tests, folder
        self.copy = os.path.join(folder, os.path.basename(path))
        self.object = os.path.join(folder, "copy.o")
        self.seconds = 600.0  # that the tests may take
        with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as text:
            words = [shlex.split(entry["command"]) for entry in json.load(text)
                     if entry["file"] == os.path.join(ROOT, path)]
        if not words:
            fail(f"{path}: expected a file that {build} compiles, but its compile_commands.json lacks it")
        words = words[0]
        first = next(i for i, word in enumerate(words) if re.search(r"(g|c|clang)\+\+[-\d.]*$", word))  # behind ccache
        words = words[first:]
        self.real_object = words[words.index("-o") + 1]
        words[words.index("-o") + 1] = self.object
        words[words.index("-c") + 1] = self.copy
        self.compile = words + ["-w"]
        self.links = [self.link_of(program) for program, _ in tests]

    def link_of(self, program):
        commands = subprocess.run(["ninja", "-C", self.build, "-t", "commands", program], capture_output=True, text=True,
                                  check=False).stdout.splitlines()
        if not commands:
            fail(f"{program}: expected a program that {self.build} builds")
        words = shlex.split(commands[-1].split(" && ")[1])
        words[words.index("-o") + 1] = os.path.join(self.folder, program)
        if self.real_object in words:
            words[words.index(self.real_object)] = self.object
        else:
            words.insert(1, self.object)  # before the libraries, which hold the original
        return words

    def compiles(self, lines):
        with open(self.copy, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
        return run(self.compile, self.build)

    def machine_code(self):
        with open(self.object, "rb") as file:
            return file.read()

    def passes(self):
        for (program, test_filter), link in zip(self.tests, self.links):
            test = [os.path.join(self.folder, program), "--gtest_filter=" + test_filter, "--gtest_fail_fast"]
            if not run(link, self.build) or not run(test, self.build, self.seconds, self.folder):
                return False
        return True


def survivors_of(path, entry, arguments):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        lines = file.read().split("\n")
    flips = flips_of(lines)
    total = len(flips)
    if arguments.most and arguments.most < total:
        flips = sorted(random.Random(arguments.seed).sample(flips, arguments.most))
    counts = collections.Counter()
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as folder:  # in memory
        shop = Workshop(os.path.abspath(arguments.build), path, entry.tests, folder)
        if not run(["ninja", "-C", arguments.build] + [program for program, _ in entry.tests], ROOT):
            fail(f"{path}: expected that its tests build before any flip, but they do not")
        begin = time.monotonic()
        if not shop.compiles(lines) or not shop.passes():
            fail(f"{path}: expected that its tests pass before any flip, but they do not")
        shop.seconds = 10.0 + 5.0 * (time.monotonic() - begin)  # a flip may make a loop endless
        original = shop.machine_code()
        for number, flipped in flips:
            if not shop.compiles(lines[:number] + [flipped] + lines[number + 1:]):
                verdict = "caught"
            elif shop.machine_code() == original:
                verdict = "same code"
            elif not shop.passes():
                verdict = "caught"
            else:
                verdict = "equivalent" if flipped.strip() in entry.equivalents else "SURVIVES"
            counts[verdict] += 1
            print(f"{verdict:<11}{path}:{number + 1}: {flipped.strip()}", flush=True)
    print(f"{path}: {total} flips, {len(flips)} run: " + ", ".join(f"{n} {word}" for word, n in sorted(counts.items())),
          flush=True)
    return counts["SURVIVES"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*")
    parser.add_argument("--build", default=os.path.join(ROOT, "build"))
    parser.add_argument("--most", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(2))  # so that the copies go
    entries = read_list()
    survivors = 0
    for path in arguments.files or entries:
        if path not in entries:
            fail(f"{path}: expected a file of {LIST}: {' '.join(entries)}")
        survivors += survivors_of(path, entries[path], arguments)
    print(f"mutate_source: {survivors} survive", file=sys.stderr)
    sys.exit(1 if survivors else 0)


main()
