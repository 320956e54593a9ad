import {html, svg, nothing, type SVGTemplateResult, type TemplateResult} from 'lit';
import {ellipseOf, frustumOf, kSigmas95In2D} from '../drawing/geometry.js';
import type {Covariance6, Point} from '../protocol.js';
import {millimetres} from '../format.js';
import {areFinite, finitePoint} from '../numbers.js';
import {store} from '../session.js';
import {StoreElement} from './store_element.js';

interface Plane {
  name: string;
  /** Axes of R that go right and up in the drawing, and their signs. */
  right: 0 | 1;
  up: 1 | 2;
  axes: [string, string];
  /** m, what is shown. */
  window: {left: number; right: number; bottom: number; top: number};
}

const kSide: Plane = {
  name: 'from the right',
  right: 0,
  up: 2,
  axes: ['forward', 'up'],
  window: {left: -0.25, right: 0.75, bottom: 0, top: 0.95},
};
const kTop: Plane = {
  name: 'from above',
  right: 0,
  up: 1,
  axes: ['forward', 'left'],
  window: {left: -0.25, right: 0.75, bottom: -0.45, top: 0.45},
};
const kPixelsPerMetre = 200;
/** m ahead of the robot. */
const kFurthest = 2;
/** m, how far the cameras' fields of view are drawn. */
const kFrustumDepth = 0.45;
const kJoints = ['foot', 'shoulder', 'elbow', 'grip_point'];
const kIndices = {xx: 0, xy: 1, xz: 2, yy: 3, yz: 4, zz: 5};

/** The arm from the side and from above, in R. */
export class ArmSides extends StoreElement {
  protected override render(): TemplateResult {
    return html`<div class="sides">${this.renderPlane(kSide)}${this.renderPlane(kTop)}</div>
      <p class="legend">
        <span class="key is-measured">━ measured</span> <span class="key is-commanded">┅ commanded</span>
        <span class="key">◎ goals</span> <span class="key">▷ cameras' views</span> ${this.renderMarkButtons()}
      </p>`;
  }

  private renderMarkButtons(): TemplateResult[] {
    return (store.hello?.scene.marks ?? []).map(
      (mark) =>
        html`<button
          class="mark-button"
          aria-pressed=${store.selected === mark.name}
          title="Light ${mark.name} up everywhere"
          @click=${() => store.select(mark.name)}
        >
          <svg viewBox="0 0 10 10" aria-hidden="true"><path d="M5 0l5 5-5 5-5-5z" fill=${mark.colour}></path></svg
          >${mark.name}
        </button>`,
    );
  }

  private renderPlane(plane: Plane): TemplateResult {
    const {left, right, bottom, top} = this.windowOf(plane);
    const width = (right - left) * kPixelsPerMetre;
    const height = (top - bottom) * kPixelsPerMetre;
    const at = (point: Point): [number, number] => [
      (point[plane.right] - left) * kPixelsPerMetre,
      (top - point[plane.up]) * kPixelsPerMetre,
    ];
    const arm = store.moment.part('arm');
    const places = store.moment.part('places');
    return html`<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="Arm seen ${plane.name}">
      ${this.renderGrid(plane, width, height)} ${this.renderCameras(at)}
      ${this.renderArm(arm?.commanded ?? null, 'commanded', at)}
      ${this.renderArm(arm?.measured ?? null, 'measured', at)}
      ${(places?.marks ?? []).map((mark) => this.renderMark(mark.name, finitePoint(mark.p_R), mark.covariance_R, plane, at))}
      ${this.renderGoal('grip goal', finitePoint(places?.grip_goal_R), at)}
      <text class="plane-name" x="5" y="13">${plane.name}</text>
    </svg>`;
  }

  /** As far ahead as the furthest mark, within reason. */
  private windowOf(plane: Plane): Plane['window'] {
    const furthest = Math.max(...(store.moment.part('places')?.marks ?? []).map((mark) => finitePoint(mark.p_R)?.[0] ?? 0));
    return {
      ...plane.window,
      right: Math.min(kFurthest, Math.max(plane.window.right, Math.ceil(furthest * 10 + 1) / 10)),
    };
  }

  private renderGrid(plane: Plane, width: number, height: number): SVGTemplateResult {
    const {left, right, bottom, top} = this.windowOf(plane);
    const lines: SVGTemplateResult[] = [];
    for (let x = Math.ceil(left * 10); x <= right * 10; x++) {
      const px = (x / 10 - left) * kPixelsPerMetre;
      lines.push(svg`<line class="grid ${x === 0 ? 'is-zero' : ''}" x1=${px} x2=${px} y1="0" y2=${height}></line>`);
    }
    for (let y = Math.ceil(bottom * 10); y <= top * 10; y++) {
      const py = (top - y / 10) * kPixelsPerMetre;
      lines.push(svg`<line class="grid ${y === 0 ? 'is-zero' : ''}" x1="0" x2=${width} y1=${py} y2=${py}></line>`);
    }
    return svg`${lines}<text class="scale" x=${width - 5} y=${height - 5}>grid 0.1 m, ${plane.axes[0]} →</text>`;
  }

  private renderCameras(at: (point: Point) => [number, number]): SVGTemplateResult | typeof nothing {
    const cameras = store.hello?.scene.cameras;
    if (!cameras) return nothing;
    return svg`${(['left', 'right'] as const).map((side) => {
      const {lens, corners} = frustumOf(cameras, side, kFrustumDepth);
      if (![lens, ...corners].every(areFinite)) return nothing;
      const [u, v] = at(lens);
      const path = corners.map((corner) => `M${u} ${v}L${at(corner).join(' ')}`).join('');
      const far = corners.map((corner) => at(corner).join(' ')).join('L');
      return svg`<path class="frustum" d="${path}M${far}Z"><title>what the ${side} camera sees</title></path>
        <rect class="lens" x=${u - 5} y=${v - 3} width="7" height="6"></rect>`;
    })}`;
  }

  private renderArm(
    points: Point[] | null,
    which: string,
    at: (point: Point) => [number, number],
  ): SVGTemplateResult | typeof nothing {
    if (!points?.every(areFinite)) return nothing;
    return svg`<g class="arm is-${which}" data-arm=${which}>
      <polyline points=${points.map((point) => at(point).join()).join(' ')}></polyline>
      ${points.map((point, index) => {
        const [u, v] = at(point);
        return svg`<circle data-arm=${which} data-joint=${kJoints[index] ?? index} data-x=${point[0]} data-y=${point[1]} data-z=${point[2]}
          cx=${u} cy=${v} r=${which === 'measured' ? 3.5 : 2.5}></circle>`;
      })}</g>`;
  }

  private renderMark(
    name: string,
    point: Point | null,
    covariance: Covariance6 | null,
    plane: Plane,
    at: (point: Point) => [number, number],
  ): SVGTemplateResult | typeof nothing {
    if (!point) return nothing;
    const [u, v] = at(point);
    const colour = store.hello?.scene.marks.find((mark) => mark.name === name)?.colour ?? '#888888';
    const ellipse = covariance && areFinite(covariance) ? ellipseIn(plane, covariance) : null;
    return svg`<g class="place ${store.selected === name ? 'is-selected' : ''}" data-place=${name} @click=${() => store.select(name)}>
      ${
        ellipse
          ? svg`<ellipse class="ellipse" rx=${Math.max(0.5, ellipse.a)} ry=${Math.max(0.5, ellipse.b)}
        transform="translate(${u} ${v}) rotate(${(-ellipse.angle * 180) / Math.PI})"></ellipse>`
          : nothing
      }
      <rect x=${u - 3.5} y=${v - 3.5} width="7" height="7" fill=${colour} transform="rotate(45 ${u} ${v})"></rect>
      ${store.selected === name ? svg`<text x=${u + 7} y=${v + 4}>${name}</text>` : nothing}
      <title>${name} at ${point.map((value) => millimetres(value)).join(', ')} in R</title></g>`;
  }

  private renderGoal(
    name: string,
    point: Point | null,
    at: (point: Point) => [number, number],
  ): SVGTemplateResult | typeof nothing {
    if (!point) return nothing;
    const [u, v] = at(point);
    return svg`<g class="goal"><circle cx=${u} cy=${v} r="6"></circle><circle cx=${u} cy=${v} r="1.5"></circle>
      <title>${name} at ${point.map((value) => millimetres(value)).join(', ')} in R</title></g>`;
  }
}
customElements.define('mmi-arm-sides', ArmSides);

function ellipseIn(plane: Plane, covariance: Covariance6): {a: number; b: number; angle: number} {
  const name = ['x', 'y', 'z'];
  const entry = (i: number, j: number): number =>
    covariance[kIndices[`${name[Math.min(i, j)]}${name[Math.max(i, j)]}` as keyof typeof kIndices]];
  const ellipse = ellipseOf(entry(plane.right, plane.right), entry(plane.right, plane.up), entry(plane.up, plane.up));
  const scale = kSigmas95In2D * kPixelsPerMetre;
  return {a: ellipse.a * scale, b: ellipse.b * scale, angle: ellipse.angle};
}
