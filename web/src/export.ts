import animationScript from './animation.ts?worker&url';
import { animationOf, animationPage } from './animation_data';
import type { Motion } from './api';
import type { App } from './app';
import { button, h } from './dom';
import { drawingOf } from './drawing';

const kPngScale = 2;

/** Downloads it. */
export function save(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  h('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

const drawing = (app: App): string => drawingOf(app.scene(), app.stage.camera);

async function pngOf(text: string): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = h('canvas', { width: kPngScale * image.width, height: kPngScale * image.height });
  canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve) => canvas.toBlob((blob) => resolve(blob!), 'image/png'));
}

async function animate(app: App, motion: Motion): Promise<Blob> {
  const style = document.querySelector<HTMLLinkElement>('link[rel=stylesheet]')!.href;
  const [template, css, script] = await Promise.all(['/animation.html', style, animationScript].map(async (address) => (await fetch(address)).text()));
  const data = animationOf(app.environment.name, app.arm, app.environment, motion);
  return new Blob([animationPage(data, template, css, script, drawing(app))], { type: 'text/html' });
}

/** Buttons that save what is shown. @param motion  for modes that show one */
export function exportRow(app: App, motion?: () => Motion | null): HTMLElement {
  const name = () => app.environment.name || 'limber';
  return h('div', { class: 'row' },
    button('PNG', () => void app.attempt(async () => save(`${name()}.png`, await pngOf(drawing(app)))), { title: 'Save the picture as PNG' }),
    button('SVG', () => save(`${name()}.svg`, new Blob([drawing(app)], { type: 'image/svg+xml' })), { title: 'Save the picture as SVG' }),
    motion !== undefined && button('One HTML file', () => void app.attempt(async () => {
      const now = motion();
      if (!now) return;
      save(`${name()}.html`, await animate(app, now));
      app.say('Saved to your downloads: one file that anybody’s browser plays, with slider and plots');
    }), { title: 'Save the motion as one HTML file for anybody, with slider and plots' }));
}
