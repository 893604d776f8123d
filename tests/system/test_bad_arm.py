"""Arm files, broken in every way: one message that names file and field, exit 2, nothing written."""

import re
import unittest

from program import ROOT, InFolder

WHOLE = re.sub(r" *#.*", "", (ROOT / "arms" / "two_segment.yaml").read_text(encoding="utf-8"))


class BadArm(InFolder):
    def refused(self, text, *expected):
        """`collect` with this arm: refused before anything is written."""
        arm = self.write("mine.yaml", text)
        result = self.run_limber(
            "collect", "--arm", arm, "--schedule", "random", "--count", 1, "--out", "x.h5", code=2
        )
        self.assertEqual(result.stdout, "")
        for part in ("mine.yaml", *expected):
            self.assertIn(part, result.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["mine.yaml"])

    def test_the_whole_file_is_accepted(self):
        arm = self.write("mine.yaml", WHOLE)
        self.run_limber(
            "collect", "--arm", arm, "--schedule", "random", "--count", 1, "--out", "x.h5"
        )

    def test_empty(self):
        self.refused("")

    def test_no_yaml(self):
        self.refused("segments: [", "mine.yaml:")
        self.refused("\x00\x01\x02")

    def test_another_schema(self):
        self.refused(WHOLE.replace("limber/arm/1", "limber/plan/1"), "limber/arm/1")

    def test_cut_short(self):
        self.refused(WHOLE[: WHOLE.index("segments:")], "segments")

    def test_each_missing_key_is_named(self):
        for key in ("name", "frame_rate_hz", "pressure_rate_limit_kpa_per_s", "length_m", "width_m"):
            with self.subTest(key=key):
                self.refused(WHOLE.replace(f"{key}:", f"{key}_gone:", 1), key)

    def test_numbers_that_are_none(self):
        for found in ("-20", "0", ".nan", ".inf", "fast", "[20]", "", "1e99"):
            with self.subTest(found=found):
                self.refused(
                    WHOLE.replace("frame_rate_hz: 20", f"frame_rate_hz: {found}"), "frame_rate_hz"
                )


if __name__ == "__main__":
    unittest.main()
