import 'uplot/dist/uPlot.min.css';
import { App } from './app';
import { byId } from './dom';

(async () => {
  await new App().start();
})().catch((error: unknown) => {
  byId('notice').textContent = error instanceof Error ? error.message : String(error);
});
