import {html, type TemplateResult} from 'lit';
import {kSigmas95In2D, ellipseOf, type Pose} from '../drawing/geometry.js';
import {degrees, metres, millimetres} from '../format.js';
import {finitePose, numberOf, words} from '../numbers.js';
import {store} from '../session.js';
import {kLevelSymbols, noneWords, stateName} from '../words.js';
import {StoreElement} from './store_element.js';

/** Where the robot is, by each method, and where it is going, in numbers. */
export class PosePanel extends StoreElement {
  override connectedCallback(): void {
    super.connectedCallback();
    this.tabIndex = 0;
  }

  protected override render(): TemplateResult {
    const message = store.moment.message('ROBOT_POSE');
    const base = store.moment.message('BASE_STATUS');
    const truth = store.moment.message('SIM_BASE_TRUTH')?.pose as Pose | undefined;
    const seen = finitePose(truth);
    if (!message) return html`<p class="empty">${noneWords(store.moment, 'ROBOT_POSE')}</p>`;
    const state = stateName(store.hello, 'ROBOT_POSE', message.state);
    const level = state === 'LOCALISED' ? 'good' : state === 'LOST' ? 'bad' : 'warning';
    const pose = message.pose as Pose;
    const ellipse = ellipseOf(message.covariance.xx, message.covariance.xy, message.covariance.yy);
    const paper = message.paper;
    const row = (name: string, symbol: string, x: number, y: number, heading?: number | null): TemplateResult =>
      html`<tr>
        <th scope="row"><span aria-hidden="true">${symbol}</span> ${name}</th>
        <td class="number">${words(x, metres)}</td>
        <td class="number">${words(y, metres)}</td>
        <td class="number">${heading === undefined ? '–' : words(heading, degrees)}</td>
        <td class="number">${seen ? millimetres(Math.hypot(numberOf(x) - seen.x, numberOf(y) - seen.y), 0) : '–'}</td>
      </tr>`;
    return html` <p class="pose-state">
        <span class="level is-${level}" aria-hidden="true">${kLevelSymbols[level]}</span> <b>${state}</b> ±
        ${words(kSigmas95In2D * ellipse.a, (metres) => millimetres(metres, 0))} (95%) ·
        ${words(message.speed, (speed) => `${speed.toFixed(2)} m/s`)}
        ${message.reason ?? ''}
      </p>
      <table class="poses">
        <thead>
          <tr>
            <td></td>
            <th class="number">x</th>
            <th class="number">y</th>
            <th class="number">heading</th>
            <th class="number">off truth</th>
          </tr>
        </thead>
        <tbody>
          ${row('fused', '▭', pose.x, pose.y, pose.heading)}
          ${paper?.measured_known ? row('raw (paper)', '+', paper.measured_x, paper.measured_y) : ''}
          ${paper?.measured_known ? row('compensated', '△', paper.compensated_x, paper.compensated_y, paper.direction_known ? paper.direction : undefined) : ''}
          ${truth ? row('truth (simulator)', '▭', truth.x, truth.y, truth.heading) : ''}
        </tbody>
      </table>
      ${
        base
          ? html`<p class="pose-state">
              Base <b>${stateName(store.hello, 'BASE_STATUS', base.state)}</b> ${words(base.distance, (distance) => metres(distance, 2))} and
              ${words(base.heading_error, degrees)} to go ${base.reason}
            </p>`
          : ''
      }`;
  }
}
customElements.define('mmi-pose', PosePanel);
