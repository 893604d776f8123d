import { type Opened, post, Refusal } from './api';
import type { App } from './app';

/** A plan of a file, opened with all that it was made for. */
export class Opening {
  private follows = () => {};

  constructor(private readonly app: App) {}

  /** @param follows  once it is open */
  ask(plan: string, follows: () => void): void {
    const { app } = this;
    const request = app.planner.expect();
    this.follows = follows;
    void app.attempt(() => post<void>('plan/open', { tab: app.tab, request, arm: app.armName, model: app.model, plan })
      .catch((error: Error) => {
        const isAnswered = error instanceof Refusal && error.status !== 0;
        app.planner.refuse(request, !isAnswered);
        throw error;
      }));
  }

  async onOpened({ request, arm, model, environment, plan }: Opened): Promise<void> {
    const { app, follows } = this;
    const isAwaited = () => app.planner.isAwaited(request);
    if (!isAwaited()) return;
    try {
      if (!(await app.open(arm, environment, null, isAwaited))) return;
    } catch (error) {
      app.planner.refuse(request, true);
      throw error;
    }
    app.choose(model);
    app.planner.take(plan);
    app.isInFile = app.project.environments.includes(environment); // not beside a run's plan
    app.link(app.isInFile ? null : app.environment);
    follows();
  }
}
