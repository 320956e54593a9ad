import {html, nothing, svg, type SVGTemplateResult, type TemplateResult} from 'lit';
import {guard} from 'lit/directives/guard.js';
import {ellipseOf, kSigmas95In2D, type Pose} from '../drawing/geometry.js';
import {
  fanPath,
  FloorScale,
  outlinePath,
  scaleToFit,
  tagPlaces,
  tagStates,
  type TagState,
} from '../drawing/floor_map.js';
import {drawDirection} from '../drawing/paper_direction.js';
import {degrees, metres} from '../format.js';
import {drawWished} from '../drawing/wished_pose.js';
import {areFinite, finitePose, kNotANumber} from '../numbers.js';
import {afterPlaceKey, placedAt, placeWords, turnedTo} from '../operate/wished_place.js';
import type {SonarEchoMessage} from '../protocol.js';
import {operator, store} from '../session.js';
import {StoreElement} from './store_element.js';

/** us, how much of the way is drawn. */
const kTrail_us = 60e6;
/** m, around the tags: the robot's outline and some floor. */
const kMargin = 0.35;
const kPanStep_px = 40;
const kZoomStep = 1.3;
/** px; a pointer that moves less has clicked. */
const kDrag_px = 8;
/** m, of a robot whose base is not told. */
const kSomeBase = {front: 0.2, rear: 0.2, half_width: 0.15};

type PoseName = 'fused' | 'raw' | 'compensated' | 'truth' | 'goal';

/** The floor from above: tags, poses, sonars. */
export class FloorMap extends StoreElement {
  private size: [number, number] = [600, 500];
  private zoom = 1;
  private shift: [number, number] = [0, 0];
  private drag: {x: number; y: number; turns: boolean} | null = null;
  /** Pointer and arrows choose a place to drive to, rather than move the map; null: as its token lets this page command. */
  private chooses: boolean | null = null;
  private readonly resizing = new ResizeObserver((entries) => this.onSize(entries));

  constructor() {
    super();
    this.shows = ['choice', 'operate', 'state', 'events'];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resizing.disconnect();
  }

  protected override firstUpdated(): void {
    this.resizing.observe(this.querySelector('.floor')!);
  }

  protected override render(): TemplateResult {
    const tags = store.hello?.scene.tags ?? [];
    const message = store.moment.message('ROBOT_POSE');
    const robot = finitePose(message?.pose);
    const fit = scaleToFit(
      tags.length > 0 ? tags.map((tag) => tag.place) : robot ? [[robot.x, robot.y]] : [],
      kMargin,
      this.size,
    );
    const scale = new FloorScale(
      fit.pixels_per_metre * this.zoom,
      [fit.centre[0] + this.shift[0], fit.centre[1] + this.shift[1]],
      this.size,
    );
    const states = tagStates(store.moment.part('floor'));
    const words = this.choosing ? 'arrows choose a place, with Shift they turn it' : 'arrows move it';
    return html` <div
        class="floor ${this.choosing ? 'is-choosing' : ''}"
        @wheel=${this.onWheel}
        @pointerdown=${(event: PointerEvent) => this.onDown(event, scale)}
        @pointermove=${(event: PointerEvent) => this.onMove(event, scale)}
        @pointerup=${this.onUp}
        @pointercancel=${this.onUp}
        @keydown=${(event: KeyboardEvent) => this.onKey(event, scale)}
        tabindex="0"
        role="group"
        aria-label="Floor, ${words}, + and - enlarge it"
      >
        <svg
          viewBox="0 0 ${this.size[0]} ${this.size[1]}"
          width=${this.size[0]}
          height=${this.size[1]}
          role="img"
          aria-label="Floor from above"
        >
          ${robot ? this.renderSonars(scale, robot) : nothing}
          ${guard(
            [tags, [...states.keys()].join(), store.selected, scale.pixels_per_metre, ...scale.centre, ...this.size],
            () =>
              svg`${tags.filter((tag) => !states.has(tag.uid)).map((tag) => this.renderTag(scale, tag.uid, tag.place, 'idle'))}`,
          )}
          ${this.renderActive(scale, states)} ${this.renderTrail(scale)} ${this.renderPoses(scale, robot)}
          ${operator.enabled && operator.wished ? drawWished(scale, operator.wished, store.hello?.scene.base ?? kSomeBase) : nothing}
          ${this.renderRuler(scale)}
        </svg>
      </div>
      <div class="image-foot">
        <span class="legend">
          ${
            store.goals.isUnplaced(store.moment.message('BASE_GOAL'))
              ? html`<span>▲ goal given in the robot's frame, its place is not known here</span>`
              : nothing
          }
          ${message?.pose && !robot ? html`<span>▲ pose ${kNotANumber}</span>` : nothing}
          <span>● read</span><span>✕ missed</span><span>○ expected</span><span>◆ not expected</span
          ><span>· other tag</span>
        </span>
        <span class="visually-hidden" role="status">
          ${operator.enabled && operator.wished ? `chosen: ${placeWords(operator.wished)}` : ''}
        </span>
        ${operator.enabled ? this.renderChooser() : nothing}
        <span class="zoom" role="group" aria-label="Zoom of the floor">
          <button @click=${() => this.zoomBy(1 / kZoomStep)} aria-label="Smaller">−</button>
          <button @click=${this.reset} aria-label="All tags" title="All tags">all</button>
          <button @click=${() => this.zoomBy(kZoomStep)} aria-label="Larger">+</button>
        </span>
      </div>`;
  }

  private get choosing(): boolean {
    return operator.enabled && (this.chooses ?? operator.desk?.may ?? false);
  }

  private renderChooser(): TemplateResult {
    return html`<button
      class="chooser"
      aria-pressed=${this.choosing}
      title="Click on the floor and drag to where the robot shall look, or move the map"
      @click=${() => {
        this.chooses = !this.choosing;
        this.requestUpdate();
      }}
    >
      choose a place
    </button>`;
  }

  private renderActive(scale: FloorScale, states: Map<string, TagState>): SVGTemplateResult[] {
    const places = tagPlaces(store.hello?.scene.tags ?? []);
    return [...states].flatMap(([uid, state]) => {
      const place = places.get(uid);
      return place ? [this.renderTag(scale, uid, place, state)] : [];
    });
  }

  private renderTag(scale: FloorScale, uid: string, place: [number, number], state: TagState): SVGTemplateResult {
    const [x, y] = scale.at(...place);
    const shapes: Record<TagState, string> = {
      idle: 'M-1.500 0a1.500 1.500 0 1 0 3 0a1.500 1.500 0 1 0-3 0z',
      read: 'M-6 0a6 6 0 1 0 12 0a6 6 0 1 0-12 0z',
      expected: 'M-6 0a6 6 0 1 0 12 0a6 6 0 1 0-12 0z',
      missed: 'M-5-5L5 5M5-5L-5 5',
      unexpected: 'M0-7L7 0L0 7L-7 0Z',
    };
    return svg`<g class="tag is-${state} ${store.selected === uid ? 'is-selected' : ''}" data-tag=${uid} data-state=${state}
      transform="translate(${x.toFixed(2)} ${y.toFixed(2)})" @click=${() => this.choosing || store.select(uid)}>
      <circle class="target" r="9"></circle><path d=${shapes[state]}></path><title>${uid}, ${state}, at ${metres(place[0], 2)}, ${metres(place[1], 2)}</title></g>`;
  }

  private renderSonars(scale: FloorScale, robot: Pose): SVGTemplateResult {
    const scan = store.moment.message('SONAR_SCAN');
    const echoes = (scan?.echoes ?? []) as SonarEchoMessage[];
    return svg`<g class="sonars">${echoes
      .filter((echo) => echo.heard && finitePose(echo.pose) && Number.isFinite(echo.range))
      .map(
        (echo, index) =>
          svg`<path d=${fanPath(scale, robot, echo, scan.beam_width)}><title>sonar ${index}: ${metres(echo.range, 2)}</title></path>`,
      )}</g>`;
  }

  private renderTrail(scale: FloorScale): SVGTemplateResult {
    const now = store.moment.now;
    const points = store.trail.filter((point) => point.at <= now && point.at > now - kTrail_us);
    return svg`<polyline class="trail" points=${points
      .map((point) =>
        scale
          .at(point.x, point.y)
          .map((value) => value.toFixed(1))
          .join(),
      )
      .join(' ')}></polyline>`;
  }

  private renderPoses(scale: FloorScale, robot: Pose | null): SVGTemplateResult {
    const message = store.moment.message('ROBOT_POSE');
    const truth = finitePose(store.moment.message('SIM_BASE_TRUTH')?.pose);
    const goal = store.goals.goal(store.moment.message('BASE_GOAL'));
    const paper = message?.paper;
    const heading: number = paper?.direction_known ? paper.direction : (robot?.heading ?? 0);
    const raw = finitePose(paper?.measured_known ? {x: paper.measured_x, y: paper.measured_y, heading} : null);
    const compensated = finitePose(
      paper?.measured_known ? {x: paper.compensated_x, y: paper.compensated_y, heading} : null,
    );
    return svg`
      ${truth ? this.renderOutlined(scale, 'truth', truth) : nothing}
      ${goal ? this.renderOutlined(scale, 'goal', goal) : nothing}
      ${robot ? this.renderOutlined(scale, 'fused', robot) : nothing}
      ${robot && message.covariance ? this.renderEllipse(scale, robot, message.covariance) : nothing}
      ${raw ? this.renderPoint(scale, 'raw', raw) : nothing}
      ${compensated ? this.renderPoint(scale, 'compensated', compensated) : nothing}
      ${drawDirection(scale, paper)}`;
  }

  private renderOutlined(scale: FloorScale, name: PoseName, pose: Pose): SVGTemplateResult {
    const {front, rear, half_width} = store.hello?.scene.base ?? kSomeBase;
    const box: [number, number][] = [
      [front, half_width],
      [-rear, half_width],
      [-rear, -half_width],
      [front, -half_width],
    ];
    const [x, y] = scale.at(pose.x, pose.y);
    const nose = scale.at(pose.x + front * Math.cos(pose.heading), pose.y + front * Math.sin(pose.heading));
    const words = {truth: 'truth (simulator)', goal: 'goal', fused: 'robot', raw: '', compensated: ''}[name];
    const label = scale.at(pose.x, pose.y - (name === 'truth' ? 1 : -1) * half_width);
    return svg`<g class="pose is-${name}" data-pose=${name} data-x=${pose.x} data-y=${pose.y} data-heading=${pose.heading}>
      <path d=${outlinePath(scale, pose, box)}></path>
      <line x1=${x} y1=${y} x2=${nose[0]} y2=${nose[1]}></line><circle cx=${x} cy=${y} r="3.500"></circle>
      ${name === 'fused' ? nothing : svg`<text x=${label[0]} y=${label[1] + (name === 'truth' ? 14 : -6)}>${words}</text>`}
      <title>${words}: ${metres(pose.x)}, ${metres(pose.y)}, ${degrees(pose.heading)}</title></g>`;
  }

  private renderPoint(scale: FloorScale, name: PoseName, pose: Pose): SVGTemplateResult {
    const [x, y] = scale.at(pose.x, pose.y);
    return svg`<g class="pose is-${name}" data-pose=${name} data-x=${pose.x} data-y=${pose.y} data-heading=${pose.heading}>
      <path d=${name === 'raw' ? `M${x - 5} ${y}h10M${x} ${y - 5}v10` : `M${x} ${y - 6}l6 10h-12z`}></path>
      <title>${name}: ${metres(pose.x)}, ${metres(pose.y)}</title></g>`;
  }

  private renderEllipse(
    scale: FloorScale,
    pose: Pose,
    covariance: {xx: number; xy: number; yy: number},
  ): SVGTemplateResult | typeof nothing {
    const ellipse = ellipseOf(covariance.xx, covariance.xy, covariance.yy);
    if (!areFinite([ellipse.a, ellipse.b])) return nothing;
    const [x, y] = scale.at(pose.x, pose.y);
    const pixels = kSigmas95In2D * scale.pixels_per_metre;
    return svg`<ellipse class="pose-ellipse" rx=${ellipse.a * pixels} ry=${ellipse.b * pixels}
      transform="translate(${x} ${y}) rotate(${(-ellipse.angle * 180) / Math.PI})"></ellipse>`;
  }

  private renderRuler(scale: FloorScale): SVGTemplateResult {
    const length =
      [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10].find((candidate) => candidate * scale.pixels_per_metre > 50) ?? 10;
    const y = this.size[1] - 12;
    const end = 12 + length * scale.pixels_per_metre;
    return svg`<g class="ruler"><path d=${`M12 ${y - 4}v4H${end}v-4`}></path><text x=${end + 6} y=${y}>${length} m, x →, y ↑</text></g>`;
  }

  private onSize(entries: ResizeObserverEntry[]): void {
    const box = entries[0]!.contentRect;
    this.size = [Math.max(50, Math.round(box.width)), Math.max(50, Math.round(box.height))];
    this.requestUpdate();
  }

  private zoomBy(factor: number): void {
    this.zoom = Math.min(40, Math.max(0.1, this.zoom * factor));
    this.requestUpdate();
  }

  private readonly reset = (): void => {
    this.zoom = 1;
    this.shift = [0, 0];
    this.requestUpdate();
  };

  private readonly onWheel = (event: WheelEvent): void => {
    event.preventDefault();
    this.zoomBy(event.deltaY < 0 ? kZoomStep : 1 / kZoomStep);
  };

  private onKey(event: KeyboardEvent, scale: FloorScale): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (this.choosing && this.chooseByKey(event, scale)) {
      event.preventDefault();
      return;
    }
    const by = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    const step = kPanStep_px / scale.pixels_per_metre;
    if (by) this.shift = [this.shift[0] + step * by[0]!, this.shift[1] + step * by[1]!];
    else if (event.key === '+') this.zoomBy(kZoomStep);
    else if (event.key === '-') this.zoomBy(1 / kZoomStep);
    else return;
    event.preventDefault();
    this.requestUpdate();
  }

  /** The first key shows the place where the robot stands, or, where that is not known, in the middle. */
  private chooseByKey(event: KeyboardEvent, scale: FloorScale): boolean {
    const robot = finitePose(store.moment.message('ROBOT_POSE')?.pose);
    const begin = robot ?? {x: scale.centre[0], y: scale.centre[1], heading: 0};
    const from = operator.wished ?? placedAt(begin.x, begin.y, begin);
    const to = afterPlaceKey(from, event.key, event.shiftKey);
    if (to) operator.wish(operator.wished ? to : from);
    return to !== null;
  }

  /** m in W. */
  private pointed(event: PointerEvent, scale: FloorScale): [number, number] {
    const box = this.querySelector('.floor')!.getBoundingClientRect();
    return scale.placeAt(event.clientX - box.left, event.clientY - box.top);
  }

  private onDown(event: PointerEvent, scale: FloorScale): void {
    if (event.button !== 0) return;
    this.drag = {x: event.clientX, y: event.clientY, turns: false};
    if (!this.choosing) return;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    const robot = finitePose(store.moment.message('ROBOT_POSE')?.pose);
    operator.wish(placedAt(...this.pointed(event, scale), operator.wished ?? robot));
  }

  private readonly onUp = (): void => {
    this.drag = null;
  };

  private onMove(event: PointerEvent, scale: FloorScale): void {
    if (!this.drag || !(event.buttons & 1)) return;
    if (this.choosing) this.turn(event, scale, this.drag);
    else this.pan(event, scale, this.drag);
  }

  private turn(event: PointerEvent, scale: FloorScale, drag: NonNullable<FloorMap['drag']>): void {
    drag.turns ||= Math.hypot(event.clientX - drag.x, event.clientY - drag.y) > kDrag_px;
    if (drag.turns && operator.wished) operator.wish(turnedTo(operator.wished, ...this.pointed(event, scale)));
  }

  private pan(event: PointerEvent, scale: FloorScale, drag: NonNullable<FloorMap['drag']>): void {
    const perPixel = 1 / scale.pixels_per_metre;
    this.shift = [
      this.shift[0] - (event.clientX - drag.x) * perPixel,
      this.shift[1] + (event.clientY - drag.y) * perPixel,
    ];
    this.drag = {x: event.clientX, y: event.clientY, turns: false};
    this.requestUpdate();
  }
}
customElements.define('mmi-floor', FloorMap);
