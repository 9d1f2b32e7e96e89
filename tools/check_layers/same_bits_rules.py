"""Rules that keep a walk's numbers the same on every machine, compiler and level."""

import re

from .source import Diagnostic, code_only, position
from .table import KERNEL_FOLDERS, needs_same_bits, is_in

# Functions that aren't correctly rounded everywhere. sqrt is; abs, floor, ceil, trunc, round, isfinite,
# nextafter and the like are exact. fma is exact, too, but emulated in software where the processor lacks it.
_INEXACT = ("acos acosh asin asinh atan atan2 atanh beta cbrt cos cosh erf erfc exp exp2 expm1 fma fmod hypot lerp "
            "lgamma llrint log log10 log1p log2 logb lrint nearbyint pow remainder remquo rint sin sincos sinh "
            "tan tanh tgamma").split()
# Members and types of Eigen that call the same functions.
_EIGEN_MEMBERS = "acos asin atan canonicalEulerAngles cos cosh exp log log10 log1p sin sinh tan tanh".split()
_EIGEN_MEMBERS_WITH_ARGUMENTS = "angularDistance computeDirect eulerAngles hypotNorm pow slerp".split()
_EIGEN_TYPES = ("AngleAxis", "AngleAxisd", "AngleAxisf", "Rotation2D", "Rotation2Dd", "Rotation2Df")

_LIBM_CALL = re.compile(
    r"(?P<qualifier>(?:\b\w+\s*)?::\s*|\.\s*|->\s*)?\b(?P<name>(?:__builtin_)?(?:%s)[fl]?)\s*\(" % "|".join(_INEXACT))
_MEMBER_CALL = re.compile(r"(?:\.|->)\s*(?P<name>(?:%s)(?=\s*\(\s*\))|(?:%s)(?=\s*\())" % (
    "|".join(_EIGEN_MEMBERS), "|".join(_EIGEN_MEMBERS_WITH_ARGUMENTS)))
_EIGEN_TYPE = re.compile(r"\b(?P<name>%s)\b" % "|".join(_EIGEN_TYPES))
_FLAG = re.compile(r"(?<![\w-])(?P<flag>-march=[\w.-]+|-mtune=[\w.-]+|-mcpu=[\w.-]+|-m(?:avx|fma|sse)[\w.]*|-Ofast"
                   r"|-ffast-math|-funsafe-math-optimizations|-fassociative-math|-freciprocal-math"
                   r"|-ffinite-math-only|-fno-signed-zeros|-ffp-contract=(?:fast|on))")
_BUILD_COMMENT = re.compile(r"#[^\n]*")


def _is_libm(match):
    """Whether the name before a parenthesis is libm's, going by what precedes it."""
    qualifier = (match["qualifier"] or "").replace(" ", "")
    if qualifier in (".", "->"):
        return False
    return qualifier.rstrip(":") in ("", "std", "numext", "Eigen", "return")


def _calls(code):
    for match in _LIBM_CALL.finditer(code):
        if _is_libm(match):
            yield match.start("name"), match["name"]
    for pattern in (_MEMBER_CALL, _EIGEN_TYPE):
        for match in pattern.finditer(code):
            yield match.start("name"), match["name"]


def check_libm(tree):
    """Checks that the core calls no libm function but sqrt and the exact ones."""
    for file, text in tree.cpp.items():
        if not needs_same_bits(file):
            continue
        code = code_only(text)
        for offset, name in sorted(_calls(code)):
            line, column = position(code, offset)
            yield Diagnostic(file, line, column, "same-bits",
                            "%s differs between machines; see collision/geometry/trigonometry.h for what doesn't" % name)


def check_compiler_flags(tree):
    """Checks that only kernels choose an instruction set, and that all arithmetic is IEEE's."""
    for file, text in tree.build.items():
        plain = text if file.endswith(".json") else _BUILD_COMMENT.sub(lambda m: " " * len(m[0]), text)
        for match in _FLAG.finditer(plain):
            flag = match["flag"]
            if flag.startswith("-m") and is_in(file, KERNEL_FOLDERS):
                continue
            line, column = position(plain, match.start())
            yield Diagnostic(file, line, column, "compiler-flag",
                            "%s changes results%s" % (flag, "; it is for kernel folders" * flag.startswith("-m")))
