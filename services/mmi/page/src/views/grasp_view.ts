import {html, nothing, type TemplateResult} from 'lit';
import {StoreElement} from '../elements/store_element.js';
import {operator} from '../session.js';
import {panel} from '../elements/panel.js';
import '../elements/camera_image.js';
import '../elements/servo_panel.js';
import '../elements/procedure.js';
import '../elements/arm_sides.js';
import '../elements/scene_3d.js';
import '../elements/event_list.js';
import '../elements/operate_panel.js';

/** What the robot sees, and what its hand does about it. */
export class GraspView extends StoreElement {
  constructor() {
    super();
    this.shows = ['operate'];
  }

  protected override render(): TemplateResult {
    return html`
      ${panel('left', 'Left image', html`<mmi-image side="left"></mmi-image>`)}
      ${panel('right', 'Right image', html`<mmi-image side="right"></mmi-image>`)}
      ${panel('servo', 'Grip error', html`<mmi-servo></mmi-servo>`)}
      ${panel('procedure', 'Procedure', html`<mmi-procedure></mmi-procedure>`)}
      ${panel('space', 'Arm in space', html`<mmi-scene></mmi-scene>`)}
      ${panel('sides', 'Side and top', html`<mmi-arm-sides></mmi-arm-sides>`)}
      ${panel('events', 'Events', html`<mmi-events></mmi-events>`)}
      ${operator.enabled ? panel('operate', 'Operate', html`<mmi-operate></mmi-operate>`) : nothing}
    `;
  }

  protected override updated(): void {
    this.classList.toggle('has-operate', operator.enabled);
  }
}
customElements.define('mmi-grasp-view', GraspView);
