import {html, type TemplateResult} from 'lit';
import {kSigmas95In2D, ellipseOf, type Pose} from '../drawing/geometry.js';
import {degrees, metres, millimetres} from '../format.js';
import {store} from '../session.js';
import {kLevelSymbols, stateName} from '../words.js';
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
    if (!message) return html`<p class="empty">No ROBOT_POSE yet</p>`;
    const state = stateName(store.hello, 'ROBOT_POSE', message.state);
    const level = state === 'LOCALISED' ? 'good' : state === 'LOST' ? 'bad' : 'warning';
    const pose = message.pose as Pose;
    const ellipse = ellipseOf(message.covariance.xx, message.covariance.xy, message.covariance.yy);
    const paper = message.paper;
    const row = (name: string, symbol: string, x: number, y: number, heading: number | null): TemplateResult =>
      html`<tr>
        <th scope="row"><span aria-hidden="true">${symbol}</span> ${name}</th>
        <td class="number">${metres(x)}</td>
        <td class="number">${metres(y)}</td>
        <td class="number">${degrees(heading)}</td>
        <td class="number">${truth ? millimetres(Math.hypot(x - truth.x, y - truth.y), 0) : '–'}</td>
      </tr>`;
    return html` <p class="pose-state">
        <span class="level is-${level}" aria-hidden="true">${kLevelSymbols[level]}</span> <b>${state}</b> ±
        ${millimetres(kSigmas95In2D * ellipse.a, 0)} (95%) · ${message.speed?.toFixed(2) ?? '–'} m/s
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
          ${paper?.measured_known ? row('raw (paper)', '+', paper.measured_x, paper.measured_y, null) : ''}
          ${paper?.measured_known ? row('compensated', '△', paper.compensated_x, paper.compensated_y, paper.direction_known ? paper.direction : null) : ''}
          ${truth ? row('truth (simulator)', '▭', truth.x, truth.y, truth.heading) : ''}
        </tbody>
      </table>
      ${
        base
          ? html`<p class="pose-state">
              Base <b>${stateName(store.hello, 'BASE_STATUS', base.state)}</b> ${metres(base.distance, 2)} and
              ${degrees(base.heading_error)} to go ${base.reason}
            </p>`
          : ''
      }`;
  }
}
customElements.define('mmi-pose', PosePanel);
