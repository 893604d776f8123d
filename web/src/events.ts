import type { Handlers } from './api';
import type { App } from './app';

/** Who is told of what the server says. */
export function handlersOf(app: App): Handlers {
  const { armLink, modes, planner } = app;
  return {
    tab: ({ id }) => app.onTab(id),
    plan: (plan) => planner.onPlan(plan),
    progress: (progress) => planner.onProgress(progress),
    tree: (tree) => planner.onTree(tree),
    fitting: (fitting) => modes.plan.onFitting(fitting),
    fitted: (fitted) => void app.attempt(() => modes.plan.onFitted(fitted)),
    result: (result) => planner.onResult(result),
    run: (run) => modes.play.onRun(run),
    followed: (run) => modes.follow.onFollowed(run),
    drive: (drive) => modes.drive.onDrive(drive),
    arm: (status) => armLink.onStatus(status),
    arm_frame: (frame) => armLink.onFrame(frame),
    arm_run: (motion) => modes.play.onArmRun(motion),
    opened: (opened) => void app.attempt(() => app.opening.onOpened(opened)),
    measuring: ({ request, share }) => modes.results.onMeasuring(request, share),
    measured: (measured) => modes.results.onMeasured(measured),
    fault: ({ request, message }) =>
      planner.refuse(request) ? app.say(message) : app.entered.onFault(request, message),
  };
}
