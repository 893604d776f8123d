"""A notebook that executes a plan on an arm, for test_deadman.py: long after the plan's end it holds.

    executing_notebook.py ARM ENVIRONMENT PLAN "exec:COMMAND" HOLD_S
"""

import sys

import limber

arm = limber.load_arm(sys.argv[1])
environment = limber.load_environment(sys.argv[2], arm)
plan = limber.read_plan(sys.argv[3])
driver = limber.ProcessDriver(arm, sys.argv[4])
print("executing", flush=True)
limber.execute(arm, environment, plan, driver, limber.ExecutionSettings(hold_s=float(sys.argv[5])))
print("executed", flush=True)
