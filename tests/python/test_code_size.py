"""tools/code_size.py: what counts as a line of code, and that an older commit is counted like today's files."""

import importlib.util
import pathlib
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

CPP = '''#pragma once
#include <vector>
// A comment with a "text".
namespace limber {
/* Over
   two lines */ constexpr int kMany = 10'000;  // [1]

struct Pair { char quote = '"'; };  /* behind */
enum class Kind : int { one };
class Declared;
const char* page = R"(
// of the page, "quoted"
)";
inline constexpr std::array<int, 2> kTwo{1, 2};
app.add_option("--out", out_);
app.add_flag_function("--fast", [] {});
}
'''
CPP_LINES = 13  # of them, those without blanks, comments and includes

PYTHON = '''"""Of the module."""

import os


def first():
    """Of the function,
    in two lines."""
    # a comment
    return """not
a docstring"""
'''
PYTHON_LINES = 3


def tool():
    spec = importlib.util.spec_from_file_location("code_size", ROOT / "tools" / "code_size.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class CodeSize(unittest.TestCase):
    def test_comments_blanks_includes_and_docstrings_do_not_count(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("src/arm/include/limber/arm/a.hpp", CPP), ("apps/limber/b.cpp", CPP),
                               ("python/limber/c.py", PYTHON), ("README.md", "Four words of docs.")):
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            self.assertEqual(tool().counts(pathlib.Path(folder)), {
                "src/arm": CPP_LINES, "apps": CPP_LINES, "python": PYTHON_LINES,
                "lines of code": 2 * CPP_LINES + PYTHON_LINES, "public headers": 1, "types": 4, "constants": 4,
                "flags": 2, "words of docs": 4})

    @unittest.skipUnless(tool().has_repository(), "no git, or no repository")
    def test_a_commit_is_counted_like_the_files_that_lie_here(self):
        self.assertEqual(tool().counts_at("HEAD").keys(), tool().counts(ROOT).keys())


if __name__ == "__main__":
    unittest.main()
