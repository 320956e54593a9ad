import {html, nothing, type TemplateResult} from 'lit';
import {ellipseOf, kSigmas95In2D} from '../drawing/geometry.js';
import {millimetres, span} from '../format.js';
import {numberOf, words} from '../numbers.js';
import {store} from '../session.js';
import {kLevelSymbols, noneWords, stateName} from '../words.js';
import type {Level} from '../protocol.js';
import {StoreElement} from './store_element.js';

const kLevels: Record<string, Level> = {
  CONVERGED: 'good',
  SERVO: 'info',
  POSTURE: 'info',
  HOLD: 'info',
  LOST: 'warning',
  STALE: 'bad',
  UNREACHABLE: 'bad',
  STOPPED: 'bad',
};

const kShortNames: Record<string, string> = {
  MARK_DETECTION: 'marks',
  STEREO_MATCHES: 'matches',
  TARGET_POSE: 'places',
  SERVO_STATUS: 'servo',
  JOINT_COMMAND: 'command',
};

/** How far the hand is from where it shall grip. */
export class ServoPanel extends StoreElement {
  override connectedCallback(): void {
    super.connectedCallback();
    this.tabIndex = 0;
  }

  protected override render(): TemplateResult {
    const servo = store.moment.message('SERVO_STATUS');
    if (!servo) return html`<p class="empty">${noneWords(store.moment, 'SERVO_STATUS')}</p>`;
    const state = stateName(store.hello, 'SERVO_STATUS', servo.state);
    const known = ['SERVO', 'CONVERGED'].includes(state);
    const error = servo.error_C ?? {};
    const size = Math.hypot(numberOf(error.x), numberOf(error.y), numberOf(error.z));
    const shown = (metres: unknown, sign = ''): string =>
      known ? words(metres, (value) => `${sign}${millimetres(value)}`) : '–';
    const level = kLevels[state] ?? 'info';
    return html`
      <p class="big">
        <span class="level is-${level}" aria-hidden="true">${kLevelSymbols[level]}</span> ${state}
        <b>${shown(size)}</b>
      </p>
      <dl class="numbers">
        <dt>right</dt>
        <dd>${shown(error.x)}</dd>
        <dt>ahead</dt>
        <dd>${shown(error.y)}</dd>
        <dt>up</dt>
        <dd>${shown(error.z)}</dd>
        <dt>95%</dt>
        <dd>${shown(kSigmas95In2D * largest(servo.covariance), '± ')}</dd>
      </dl>
      <p class="reason">${servo.reason || this.goalWords()}</p>
      ${this.renderLatency()}
    `;
  }

  private goalWords(): string {
    const goal = store.moment.message('SERVO_GOAL');
    return goal?.tolerance > 0 && goal?.target ? `to ${goal.target}, within ${millimetres(goal.tolerance)}` : '';
  }

  private renderLatency(): TemplateResult | typeof nothing {
    const latency = store.moment.part('latency');
    const rows = Object.entries(latency ?? {}).filter(([, seconds]) => seconds !== null);
    if (rows.length === 0) return nothing;
    return html`<h3>After the frame</h3>
      <dl class="numbers">
        ${rows.map(
          ([channel, seconds]) =>
            html`<dt>${kShortNames[channel] ?? channel}</dt>
              <dd>${span(seconds)}</dd>`,
        )}
      </dl>`;
  }
}
customElements.define('mmi-servo', ServoPanel);

function largest(covariance: {xx: number; xy: number; yy: number; zz: number} | undefined): number {
  if (!covariance) return NaN;
  return Math.max(ellipseOf(covariance.xx, covariance.xy, covariance.yy).a, Math.sqrt(Math.max(0, numberOf(covariance.zz))));
}
