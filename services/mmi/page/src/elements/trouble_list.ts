import {html, type TemplateResult} from 'lit';
import {microseconds, span} from '../format.js';
import {store} from '../session.js';
import {StoreElement} from './store_element.js';

/** All troubles, the worst first, each with what mends it. */
export class TroubleList extends StoreElement {
  constructor() {
    super();
    this.pace_ms = 250;
    this.shows = ['choice', 'state'];
  }

  protected override render(): TemplateResult {
    const troubles = store.moment.part('troubles') ?? [];
    if (troubles.length === 0)
      return html`<p class="none"><span class="level is-good" aria-hidden="true">✓</span> none</p>`;
    return html`<ol class="troubles scroll" tabindex="0" aria-label="Troubles, the worst first">
      ${troubles.map(
        (trouble) =>
          html`<li>
            <span class="level is-bad" aria-hidden="true">✖</span>
            <span
              ><b>${trouble.text}</b> <span>→ ${trouble.remedy}</span>
              <span class="muted">${trouble.code} ${trouble.subject}${this.since(trouble.since_utime)}</span></span
            >
          </li>`,
      )}
    </ol>`;
  }

  private since(us: number | string): string {
    const seconds = (store.moment.now - microseconds(us)) / 1e6;
    return seconds >= 0 && seconds < 1e6 ? `, for ${span(seconds)}` : '';
  }
}
customElements.define('mmi-troubles', TroubleList);
