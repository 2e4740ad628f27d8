#!/usr/bin/env python3
"""Flips one operator of a C++ file at a time, runs the nearest tests with it and prints the flips that survive.

    tests/mutate_source.py [--build build] [--most N] [--seed S] [FILE...]

FILE: a line of tests/data/mutated_sources.txt (all of them by default), which names the test programs and their filters,
and under it the equivalents, which are believed. --most takes N flips of each file, chosen by the seed.

Copies of the file are compiled and linked before the libraries, so that neither the sources nor the build change. One
copy holds most flips (tests/mutant.hpp); a flip that it cannot hold, or that survives there, gets a copy of its own. A
flip that does not compile counts as caught, one that gives the same machine code as an equivalent. Copies have the
assertions of the standard library, which find what reads behind a vector. Exit: 0 no survivor, 1 some survive, 2 bad
input.
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
UNKNOWN = 77  # the exit code kUnknown of tests/mutant.hpp

# clang-format puts spaces around binary operators and none into template arguments. Old, new, and the old one with `#`,
# the number of the flip, for the copy that holds all of them.
BINARY = [(" + ", " - ", "Plus"), (" - ", " + ", "Minus"), (" * ", " / ", "Times"), (" / ", " * ", "Over"),
          (" % ", " * ", "Modulo"), (" < ", " <= ", "Less"), (" <= ", " < ", "AtMost"), (" > ", " >= ", "More"),
          (" >= ", " > ", "AtLeast"), (" == ", " != ", "Same"), (" != ", " == ", "Other"), (" += ", " -= ", "Add"),
          (" -= ", " += ", "Subtract")]
FLIPS = [(old, new, old + "mutant::" + name + "{#}" + old) for old, new, name in BINARY] + [
    (" && ", " || ", None), (" || ", " && ", None), ("++", "--", None),
    ("std::min(", "std::max(", "mutant::min(#, "), ("std::max(", "std::min(", "mutant::max(#, "),
    ("(!", "(", "(mutant::is(#) != !"), ("if (", "if (false && ", "if (!mutant::is(#) && "),
    ("return true;", "return false;", "return !mutant::is(#);"),
    ("return false;", "return true;", "return mutant::is(#);")]
CALL = re.compile(r"(\s*)((?:[\w.:]|->)+\(.*\);)$")  # a statement that is nothing but a call: a flip leaves it out
CALL_SWITCH = "mutant::is(#) ? void() : void(@);"  # @: the call
ALONE = re.compile(r"\b(constexpr|static_assert|template)\b")  # lines whose flips get copies of their own

Entry = collections.namedtuple("Entry", "tests equivalents")  # [(program, filter)...], {flipped lines}
Flip = collections.namedtuple("Flip", "line column old new switch")


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
    result = []
    for number, line in enumerate(lines):
        code = code_part(line)
        if code.lstrip().startswith("#") or "static_assert" in code:
            continue
        for old, new, switch in FLIPS:
            for column in [match.start() for match in re.finditer(re.escape(old), code)]:
                if old == "if (" and re.match(r"if \((const|auto)\b", code[column:]):
                    continue  # a condition that declares
                result.append(Flip(number, column, old, new, None if ALONE.search(code) else switch))
        call = CALL.match(code.rstrip())
        if call and code.count("(") == code.count(")"):
            old = line[call.start(2):call.end(2)]
            result.append(Flip(number, call.start(2), old, "// left out: " + old, CALL_SWITCH))
    return result


def flipped(lines, flip):
    line = lines[flip.line]
    return line[:flip.column] + flip.new + line[flip.column + len(flip.old):]


def with_switches(lines, flips):
    """The file with a switch for every flip that can have one; its number is the place in `flips`."""
    result = lines[:]
    for i in sorted(range(len(flips)), key=lambda i: (flips[i].line, -flips[i].column)):  # from right to left
        flip = flips[i]
        if not flip.switch:
            continue
        now = result[flip.line]
        behind = len(lines[flip.line]) - flip.column - len(flip.old)  # characters, which no switch has changed if it is a call
        old = now[flip.column:len(now) - behind] if flip.switch is CALL_SWITCH else flip.old
        text = flip.switch.replace("#", str(i)).replace("@", old[:-1])
        result[flip.line] = now[:flip.column] + text + now[flip.column + len(old):]
    return [f'#include "{ROOT}/tests/mutant.hpp"', "#line 1"] + result


def limit_memory():
    resource.setrlimit(resource.RLIMIT_DATA, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(command, folder, seconds=None, variables=None):
    """The exit code, -1 after the time, and what went to standard error."""
    try:
        done = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=seconds,
                              preexec_fn=limit_memory, env=dict(os.environ, **(variables or {})), check=False)
        return done.returncode, done.stderr.decode(errors="replace")
    except subprocess.TimeoutExpired:
        return -1, ""


class Workshop:
    """Compiles copies of one file and runs its tests with them, in a folder of its own."""

    def __init__(self, build, path, tests, folder):
        self.build, self.tests, self.folder = build, tests, folder
        self.copy = os.path.join(folder, os.path.basename(path))
        self.object = os.path.join(folder, "copy.o")
        self.seconds = [600.0] * len(tests)  # that the tests may take; a flip may make a loop endless
        self.unit = os.path.join(folder, "unit.cpp")  # what is compiled: the copy, and the files that are compiled as one with it
        words = shlex.split(self.write_unit(os.path.join(ROOT, path)))
        first = next(i for i, word in enumerate(words) if re.search(r"(g|c|clang)\+\+[-\d.]*$", word))  # behind ccache
        words = words[first:]
        self.real_object = words[words.index("-o") + 1]
        words[words.index("-o") + 1] = self.object
        words[words.index("-c") + 1] = self.unit
        self.command = words + ["-w", "-D_GLIBCXX_ASSERTIONS"]
        self.links = [self.link_of(program) for program, _ in tests]

    def write_unit(self, source):
        """Returns the command that compiles the source, alone or (SHFORGE_UNITY) among others."""
        with open(os.path.join(self.build, "compile_commands.json"), encoding="utf-8") as text:
            entries = json.load(text)
        include = f'#include "{source}"'
        for entry in entries:
            texts = [include] if entry["file"] == source else []
            if os.path.basename(entry["file"]).startswith("unity_"):
                with open(entry["file"], encoding="utf-8") as text:
                    texts = text.read().splitlines()
            if include in texts:
                with open(self.unit, "w", encoding="utf-8") as file:
                    file.write("\n".join(texts).replace(include, f'#include "{self.copy}"'))
                return entry["command"]
        return fail(f"{source}: expected a file that {self.build} compiles, but its compile_commands.json lacks it")

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

    def compile(self, lines):
        """The lines of the copy that errors name; None if there is no error."""
        with open(self.copy, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
        code, errors = run(self.command, self.build)
        if code == 0:
            return None
        return {int(n) - 1 for n in re.findall(re.escape(os.path.basename(self.copy)) + r":(\d+):", errors)}

    def machine_code(self):
        with open(self.object, "rb") as file:
            return file.read()

    def link(self):
        return all(run(link, self.build)[0] == 0 for link in self.links)

    def run_tests(self, i, mutant):
        program, test_filter = self.tests[i]
        test = [os.path.join(self.folder, program), "--gtest_filter=" + test_filter, "--gtest_fail_fast"]
        return run(test, self.build, self.seconds[i], {"TMPDIR": self.folder, "MUTANT": str(mutant)})[0]

    def test(self, mutant=-1):
        """The exit code of the first test program that fails, else 0."""
        return next((code for i in range(len(self.tests)) if (code := self.run_tests(i, mutant)) != 0), 0)

    def passes_unchanged(self):
        """Whether all tests pass; from now on they may take five times as long."""
        for i in range(len(self.tests)):
            begin = time.monotonic()
            if self.run_tests(i, -1) != 0:
                return False
            self.seconds[i] = 5.0 + 5.0 * (time.monotonic() - begin)
        return True

    def compile_switches(self, lines, flips):
        """Whether one copy with switches works; takes the switch off those flips that do not compile."""
        for _ in range(5):
            if not any(flip.switch for flip in flips):
                return False
            wrong = self.compile(with_switches(lines, flips))
            if wrong is None:
                return self.link() and self.test() == 0
            for i, flip in enumerate(flips):
                if flip.line in wrong:
                    flips[i] = flip._replace(switch=None)
        return False


def verdicts_of(shop, lines, flips, equivalents):
    """(flip, verdict) of every flip."""
    if shop.compile(lines) is not None or not shop.link():
        fail(f"{shop.copy}: expected that the unchanged file compiles and links")
    if not shop.passes_unchanged():
        fail(f"{shop.copy}: expected that its tests pass before any flip, but they do not")
    original = shop.machine_code()
    alone = []
    works = shop.compile_switches(lines, flips)
    for i, flip in enumerate(flips):
        if flipped(lines, flip).strip() in equivalents:
            yield flip, "equivalent"
        elif works and flip.switch and shop.test(i) not in (0, UNKNOWN):
            yield flip, "caught"
        else:
            alone.append(flip)
    for flip in alone:
        if shop.compile(lines[:flip.line] + [flipped(lines, flip)] + lines[flip.line + 1:]) is not None:
            yield flip, "caught"
        elif shop.machine_code() == original:
            yield flip, "same code"
        elif not shop.link() or shop.test() != 0:
            yield flip, "caught"
        else:
            yield flip, "SURVIVES"


def survivors_of(path, entry, arguments):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        lines = file.read().split("\n")
    flips = flips_of(lines)
    total = len(flips)
    if arguments.most and arguments.most < total:
        flips = sorted(random.Random(arguments.seed).sample(flips, arguments.most), key=lambda flip: flip[:2])
    build = os.path.abspath(arguments.build)
    if run(["ninja", "-C", build] + [program for program, _ in entry.tests], ROOT)[0] != 0:
        fail(f"{path}: expected that its tests build before any flip, but they do not")
    counts = collections.Counter()
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as folder:  # in memory
        for flip, verdict in verdicts_of(Workshop(build, path, entry.tests, folder), lines, flips, entry.equivalents):
            counts[verdict] += 1
            print(f"{verdict:<11}{path}:{flip.line + 1}: {flipped(lines, flip).strip()}", flush=True)
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
