import {html, type TemplateResult} from 'lit';
import {store} from '../session.js';
import {StoreElement} from './store_element.js';
import {goalsOf} from '../drawing/goals_3d.js';
import {Scene3d} from '../drawing/scene_3d.js';

/** The robot's space, to be turned with the mouse; without WebGL the views from the side and above remain. */
export class SceneElement extends StoreElement {
  private scene: Scene3d | null = null;
  private failed = '';
  private resizing: ResizeObserver | null = null;

  constructor() {
    super();
    this.pace_ms = 80;
    this.shows = ['choice', 'state'];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resizing?.disconnect();
    this.scene?.dispose();
    this.scene = null;
  }

  protected override render(): TemplateResult {
    return html`<div class="scene-3d">
      ${
        this.failed
          ? html`<p class="empty">No WebGL here (${this.failed}). “Side and top” shows the same.</p>`
          : html`<canvas tabindex="0" role="img" aria-label="Arm, cameras, marks, the grip point's goal (cross) and the hand's (outline) in space"></canvas>`
      }
    </div>`;
  }

  protected override updated(): void {
    if (this.failed || !this.isConnected) return;
    const canvas = this.querySelector('canvas')!;
    if (!this.scene) {
      try {
        this.scene = new Scene3d(canvas, (name) => store.select(name));
      } catch (error) {
        this.failed = error instanceof Error ? error.message : 'refused';
        this.requestUpdate();
        return;
      }
      this.resizing = new ResizeObserver(() => this.scene?.resize());
      this.resizing.observe(this.querySelector('.scene-3d')!);
    }
    const style = getComputedStyle(document.documentElement);
    const moment = store.moment;
    const places = moment.part('places');
    this.scene.show({
      scene: store.hello?.scene ?? null,
      arm: moment.part('arm'),
      places,
      goals: goalsOf(places, moment.message('SERVO_GOAL'), moment.message('SERVO_STATUS')),
      selected: store.selected,
      colours: {
        ground: style.getPropertyValue('--panel').trim(),
        line: style.getPropertyValue('--line').trim(),
        arm: style.getPropertyValue('--ink').trim(),
        commanded: style.getPropertyValue('--accent').trim(),
        muted: style.getPropertyValue('--muted').trim(),
      },
    });
  }
}
customElements.define('mmi-scene', SceneElement);
