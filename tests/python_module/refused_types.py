"""What mypy has to refuse, for test_types.py: each line with the error that it ends in."""

import limber

limber.PlannerLimits(tim_s=1)  # call-arg: a field that is not there
limber.PlannerLimits(time_s="soon")  # arg-type: no number
limber.load_arm("arm.yaml").nme  # attr-defined: a property that is not there
limber.execute(limber.load_arm("a"), limber.load_environment("e"), None, None)  # arg-type: no plan
