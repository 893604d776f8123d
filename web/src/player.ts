import { button, changeText, h } from './dom';

/** Play, a slider and the time; `show` shows what there is to see of a moment. */
export class Player {
  readonly element: HTMLElement;
  time_s = 0;
  playing = false;
  private turn = 0; // of steps: those of another one end
  readonly slider = h('input', { type: 'range', min: 0, step: 'any', value: 0, 'aria-label': 'Time in seconds' });
  private readonly clock = h('output', { 'aria-live': 'off' }); // the slider says it
  readonly press: HTMLButtonElement;

  /** @param pressed  of whoever plays something else too */
  constructor(
    private readonly duration_s: () => number,
    private readonly show: (time_s: number) => void,
    pressed = () => this.toggle(),
  ) {
    this.press = button('Play', pressed, { class: 'main' });
    this.slider.addEventListener('input', () => this.seek(this.slider.valueAsNumber));
    this.element = h('div', { class: 'play' }, this.press, this.slider, this.clock);
  }

  /** Stops there. */
  seek(time_s: number): void {
    this.playing = false;
    this.move(time_s);
  }
  /** The same where something else shows that moment. */
  halt(time_s: number): void {
    this.playing = false;
    this.stand(time_s);
  }
  toggle(): void {
    this.playing = !this.playing;
    if (this.playing && this.time_s >= this.duration_s()) this.time_s = 0;
    const own = ++this.turn;
    let last_ms = performance.now();
    const step = (now_ms: number): void => {
      if (!this.playing || own !== this.turn) return;
      const next_s = this.time_s + Math.max(0, now_ms - last_ms) / 1000;
      last_ms = now_ms;
      if (next_s >= this.duration_s()) this.playing = false;
      else requestAnimationFrame(step);
      this.move(next_s);
    };
    if (this.playing) requestAnimationFrame(step);
    this.move(this.time_s);
  }

  private move(time_s: number): void {
    this.stand(Math.max(0, Math.min(time_s, this.duration_s())));
    this.show(this.time_s);
  }
  private stand(time_s: number): void {
    this.time_s = time_s;
    this.slider.max = String(this.duration_s());
    this.slider.value = String(this.time_s);
    this.slider.setAttribute('aria-valuetext', `${this.time_s.toFixed(1)} seconds`);
    changeText(this.clock, `${this.time_s.toFixed(1)} s`);
    changeText(this.press, this.playing ? 'Pause' : 'Play');
  }
}
