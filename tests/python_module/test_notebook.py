"""examples/python/whole_chain.ipynb: its cells run in their order, in plain Python, and what they
end with draws itself. Jupyter's kernel is not asked: with what it needs it is 36 Debian packages."""

import ast
import json
import unittest

from chain import EXAMPLES

NOTEBOOK = EXAMPLES / "whole_chain.ipynb"


def run_cell(source, names):
    """As a notebook does: the value of a last expression is the cell's; None where there is none."""
    tree = ast.parse(source, NOTEBOOK.name)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, NOTEBOOK.name, "exec"), names)
    return last and eval(compile(ast.Expression(last.value), NOTEBOOK.name, "eval"), names)


class Notebook(unittest.TestCase):
    def test_the_whole_chain(self):
        notebook = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
        self.assertEqual(notebook["nbformat"], 4)
        names, shown = {}, []
        for cell in notebook["cells"]:
            if cell["cell_type"] == "code":
                self.assertEqual(cell["outputs"], [], "a notebook is committed without outputs")
                shown.append(run_cell("".join(cell["source"]), names))
        drawn = [value for value in shown if hasattr(value, "_repr_svg_")]
        self.assertEqual([type(value).__name__ for value in drawn],
                         ["ArmDescription", "TrainingResult", "Evaluation", "PlanResult",
                          "ExecutionResult"])
        for value in drawn:
            self.assertTrue(value._repr_svg_().startswith("<svg"), type(value).__name__)
        self.assertTrue(names["certificate"].certified)
        self.assertEqual(names["executed"].status.name, "done")
        errors = names["evaluation"]
        self.assertLess(errors.network.open_loop.position_cm.mean,
                        errors.no_load_open_loop.position_cm.mean)


if __name__ == "__main__":
    unittest.main()
