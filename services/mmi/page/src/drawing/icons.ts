import {svg, html, type TemplateResult} from 'lit';

/** Shapes on a field of 24 x 24; drawn here because no font can be relied upon to have them. */
const kPaths = {
  play: 'M7 4l13 8-13 8z',
  pause: 'M6 4h4v16H6zM14 4h4v16h-4z',
  back: 'M16 5v14l-9-7z',
  on: 'M8 5v14l9-7z',
  previous: 'M6 5h2v14H6zM19 5v14L9 12z',
  next: 'M16 5h2v14h-2zM5 5v14l10-7z',
  grasp: 'M5 3h4v8a3 3 0 0 0 6 0V3h4v8a7 7 0 0 1-14 0zM11 17h2v4h-2z',
  drive: 'M12 2l8 19-8-5-8 5z',
  health: 'M2 13h5l3-8 4 15 3-7h5v2h-3.6L14 23 9.6 10 8.4 15H2z',
  log: 'M4 5h16v2H4zM4 11h10v2H4zM4 17h13v2H4z',
  theme: 'M12 3a9 9 0 1 0 0 18zM12 5a7 7 0 0 1 0 14z',
  record: 'M12 5a7 7 0 1 0 .01 0z',
  large: 'M4 4h7v2H7.4l4 4L10 11.400 6 7.400V11H4zM20 20h-7v-2h3.600l-4-4 1.400-1.400 4 4V13h2z',
} as const;

export type IconName = keyof typeof kPaths;

export function icon(name: IconName): TemplateResult {
  return html`<svg class="icon" viewBox="0 0 24 24" aria-hidden="true">${svg`<path d=${kPaths[name]}></path>`}</svg>`;
}
