#!/usr/bin/env python3
"""The program as an attacker finds it: read from its ELF file by readelf and objdump, not from the options that it was built with.

hardening_test.py PROGRAM COMPILER
"""

import os
import platform
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
COMPILER = ""

# What a small program needs to have everything; each with what takes it away.
OPTIONS = {
    "stack protector": ("-fstack-protector-strong", "-fno-stack-protector"),
    "fortified functions": ("-D_FORTIFY_SOURCE=2", "-U_FORTIFY_SOURCE"),
    "checked containers": ("-D_GLIBCXX_ASSERTIONS", "-U_GLIBCXX_ASSERTIONS"),
    "position-independent": ("-fPIE -pie", "-fno-pie -no-pie"),
    "bound at the start": ("-Wl,-z,now", "-Wl,-z,lazy"),
    "read-only relocations": ("-Wl,-z,relro", "-Wl,-z,norelro"),
    "stack not executable": ("-Wl,-z,noexecstack", "-Wl,-z,execstack"),
    "no segment writable and executable": ("", "-DWRITABLE_CODE"),
}
if platform.machine() == "x86_64":
    OPTIONS["marked jumps"] = ("-fcf-protection", "-fcf-protection=none")

SMALL = """
#include <cstdio>
#include <vector>
#include <cstring>
#ifdef WRITABLE_CODE
__asm__(".section .patched,\\"awx\\",@progbits\\n.byte 0\\n.previous");
#endif
int main(int count, char** words) {
    char text[16];
    std::vector<int> numbers(count);
    std::strcpy(text, words[count - 1]);
    std::printf("%s %d\\n", text, numbers[count]);
}
"""


def output_of(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, env=dict(os.environ, LC_ALL="C")).stdout.decode()


def segments_of(program):
    """(type, flags) of each."""
    return re.findall(r"^  ([A-Z_]+) +(?:0x[0-9a-f]+ +){5}([RWE ]{3})", output_of("readelf", "--segments", "--wide", program), re.M)


def protections_of(program):
    """Those of OPTIONS that the file has."""
    symbols = output_of("readelf", "--dyn-syms", "--wide", program)
    dynamic = output_of("readelf", "--dynamic", "--wide", program)
    segments = segments_of(program)
    found = {
        "stack protector": "__stack_chk_fail" in symbols,
        "fortified functions": re.search(r"__\w+_chk@", symbols),
        "checked containers": "__glibcxx_assert_fail" in symbols,
        "position-independent": re.search(r"FLAGS_1\).*\bPIE\b", dynamic) and "(TEXTREL)" not in dynamic,
        "bound at the start": "BIND_NOW" in dynamic or re.search(r"FLAGS_1\).*\bNOW\b", dynamic),
        "read-only relocations": any(kind == "GNU_RELRO" for kind, _ in segments),
        "stack not executable": [flags for kind, flags in segments if kind == "GNU_STACK"] == ["RW "],
        "no segment writable and executable": not any("W" in flags and "E" in flags for kind, flags in segments if kind == "LOAD"),
    }
    if "marked jumps" in OPTIONS:
        found["marked jumps"] = "endbr64" in output_of("objdump", "--disassemble=main", program)
    return {name for name, has in found.items() if has}


class Hardening(unittest.TestCase):
    def test_the_program_has_all(self):
        self.assertEqual(protections_of(PROGRAM), set(OPTIONS))

    def test_each_is_missed(self):
        with tempfile.TemporaryDirectory() as folder:
            source = os.path.join(folder, "small.cpp")
            with open(source, "w", encoding="ascii") as file:
                file.write(SMALL)
            for name, (_, without) in {"": ("", ""), **OPTIONS}.items():
                options = " ".join(without if each == name else with_it for each, (with_it, _) in OPTIONS.items())
                program = os.path.join(folder, "small")
                subprocess.run([COMPILER, "-O2", "-w", source, "-o", program, *options.split()], check=True)
                with self.subTest(without=name):
                    self.assertEqual(protections_of(program), set(OPTIONS) - {name})


if __name__ == "__main__":
    PROGRAM, COMPILER = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main()
