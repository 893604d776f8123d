import { axisLabels, type Camera, thingLabels } from './camera';
import { Picture, type Scene } from './picture';
import { SvgBrush } from './svg_brush';

/** A scene as a scalable drawing, with the grid's numbers, in the colours of now. */
export function drawingOf(scene: Scene, camera: Camera): string {
  const brush = new SvgBrush(camera);
  new Picture(brush, camera).paint(scene, camera);
  const colour = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const labels = axisLabels(camera).map(({ axis, at, text }) =>
    axis === 'x'
      ? `<text x="${at}" y="${camera.height - 10}" text-anchor="middle">${text}</text>`
      : `<text x="${camera.width - 8}" y="${at + 4}" text-anchor="end">${text}</text>`);
  const things = thingLabels(camera, scene.environment, scene.selected).map(({ at: [x, y], text }) =>
    `<text x="${x}" y="${y + 4}" text-anchor="middle" fill="${colour('--text')}">${text}</text>`);
  const size = `width="${camera.width}" height="${camera.height}" viewBox="0 0 ${camera.width} ${camera.height}"`;
  return `<svg xmlns="http://www.w3.org/2000/svg" ${size} role="img" aria-label="The arm">` +
    `<rect width="100%" height="100%" fill="${colour('--ground')}"/>${brush.text}` +
    `<g font-family="system-ui, sans-serif" font-size="12" fill="${colour('--quiet')}">${[...labels, ...things].join('')}</g></svg>`;
}
