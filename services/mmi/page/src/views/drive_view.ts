import {html, nothing, type TemplateResult} from 'lit';
import {panel} from '../elements/panel.js';
import {StoreElement} from '../elements/store_element.js';
import {operator} from '../session.js';
import '../elements/floor_map.js';
import '../elements/operate_panel.js';
import '../elements/pose_panel.js';
import '../elements/tag_table.js';

/** Where the robot stands and goes. */
export class DriveView extends StoreElement {
  constructor() {
    super();
    this.shows = ['operate'];
  }

  protected override render(): TemplateResult {
    return html`
      ${panel('floor', 'Floor', html`<mmi-floor></mmi-floor>`)} ${panel('pose', 'Pose', html`<mmi-pose></mmi-pose>`)}
      ${panel('tags', 'Tags', html`<mmi-tags></mmi-tags>`)}
      ${operator.enabled ? panel('operate', 'Operate', html`<mmi-operate .places=${true}></mmi-operate>`) : nothing}
    `;
  }

  protected override updated(): void {
    this.classList.toggle('has-operate', operator.enabled);
  }
}
customElements.define('mmi-drive-view', DriveView);
