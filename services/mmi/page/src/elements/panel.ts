import {html, type TemplateResult} from 'lit';
import {icon} from '../drawing/icons.js';

/** A named area of a view; its button makes it fill the view, and gives it its place back. */
export function panel(area: string, title: string, content: TemplateResult): TemplateResult {
  return html`<section class="panel area-${area}" aria-label=${title}>
    <h2>
      ${title}<button
        class="expand"
        aria-label="Enlarge ${title}"
        aria-pressed="false"
        title="Enlarge"
        @click=${enlarge}
      >
        ${icon('large')}
      </button>
    </h2>
    <div class="panel-body">${content}</div>
  </section>`;
}

function enlarge(event: Event): void {
  const button = event.currentTarget as HTMLElement;
  const section = button.closest('.panel')!;
  const large = section.classList.toggle('is-large');
  button.setAttribute('aria-pressed', String(large));
  section.parentElement!.classList.toggle('has-large', large);
}
