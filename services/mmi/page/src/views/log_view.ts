import {html, type TemplateResult} from 'lit';
import {panel} from '../elements/panel.js';
import {StoreElement} from '../elements/store_element.js';
import '../elements/camera_image.js';
import '../elements/event_list.js';
import '../elements/plots.js';
import '../elements/procedure.js';

/** What happened when: events and curves over the time that is known. */
export class LogView extends StoreElement {
  constructor() {
    super();
    this.shows = [];
  }

  protected override render(): TemplateResult {
    return html`
      ${panel('log-events', 'Events', html`<mmi-events></mmi-events>`)}
      ${panel('plots', 'Curves', html`<mmi-plots></mmi-plots>`)}
      ${panel('log-image', 'Left image', html`<mmi-image side="left"></mmi-image>`)}
    `;
  }
}
customElements.define('mmi-log-view', LogView);
