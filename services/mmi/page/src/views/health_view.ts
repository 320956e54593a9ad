import {html, type TemplateResult} from 'lit';
import {panel} from '../elements/panel.js';
import {StoreElement} from '../elements/store_element.js';
import {lookAt} from '../look.js';
import '../elements/channel_table.js';
import '../elements/message_fields.js';
import '../elements/service_table.js';
import '../elements/trouble_list.js';

/** Whether all that belongs to the robot runs, speaks and is heard. */
export class HealthView extends StoreElement {
  private channel = '';

  constructor() {
    super();
    this.shows = [];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    lookAt('fields', []);
  }

  protected override render(): TemplateResult {
    return html`
      ${panel('troubles', 'Troubles', html`<mmi-troubles></mmi-troubles>`)}
      ${panel('services', 'Services and processes', html`<mmi-services></mmi-services>`)}
      ${panel('channels', 'Channels', html`<mmi-channels .chosen=${this.channel} .choose=${this.choose}></mmi-channels>`)}
      ${panel('fields', 'Fields', html`<mmi-fields .channel=${this.channel}></mmi-fields>`)}
    `;
  }

  private readonly choose = (channel: string): void => {
    this.channel = channel;
    lookAt('fields', [channel]);
    this.requestUpdate();
  };
}
customElements.define('mmi-health-view', HealthView);
