import {html, svg, type SVGTemplateResult, type TemplateResult} from 'lit';
import {span} from '../format.js';
import {layOut, kNodeHeight, kNodeWidth, edgePath, sizeOf, type Node} from '../drawing/procedure_layout.js';
import {store} from '../session.js';
import {phasesPassed, sinceOf} from '../task_time.js';
import {phaseOf, phaseWord} from '../words.js';
import {StoreElement} from './store_element.js';

/** The procedure as task-manager declares it, and where in it the robot is. */
export class Procedure extends StoreElement {
  constructor() {
    super();
    this.pace_ms = 100;
  }

  protected override render(): TemplateResult {
    const hello = store.hello;
    const phase = phaseOf(hello, store.moment);
    const events = store.events_shown;
    const since = phase === null ? null : sinceOf(events, phase);
    const task = store.moment.message('TASK_STATE');
    const nodes = layOut(hello?.phases ?? [], hello?.transitions ?? []);
    const passed = new Set(phasesPassed(events));
    const places = new Map(nodes.map((node) => [node.phase, node]));
    const size = sizeOf(nodes);
    // Every phase can end in STOPPED: those are drawn of the present one only.
    const ends = new Set(nodes.filter((node) => node.kind === 'end').map((node) => node.phase));
    const drawn = (hello?.transitions ?? []).filter((edge) => edge.from === phase || !ends.has(edge.to));
    return html`
      <svg
        class="procedure"
        viewBox="0 0 ${size.width} ${size.height}"
        role="img"
        data-state=${phase ?? ''}
        data-since=${since ?? ''}
        aria-label="Procedure: ${phase ?? 'unknown'} ${phaseWord(phase ?? '')}"
      >
        ${drawn.map((edge) => this.renderEdge(places.get(edge.from), places.get(edge.to), edge.when, edge.from === phase))}
        ${nodes.map((node) => this.renderNode(node, node.phase === phase, passed.has(node.phase)))}
      </svg>
      <p class="reason">
        ${phase === null ? '' : html`<b>${phase}</b> for ${since === null ? '–' : span((store.moment.now - since) / 1e6)}`}
        ${task?.reason ? html` · ${task.reason}` : this.nextWords(phase)}
      </p>
    `;
  }

  private nextWords(phase: string | null): string {
    const next = (store.hello?.transitions ?? []).filter(
      (edge) => edge.from === phase && !['STOPPED', 'FAILED'].includes(edge.to),
    );
    return next.length === 0 ? '' : ` · next ${next[0]!.to} when ${next[0]!.when}`;
  }

  private renderEdge(from: Node | undefined, to: Node | undefined, when: string, on: boolean): SVGTemplateResult {
    if (!from || !to) return svg``;
    return svg`<path class="edge ${on ? 'is-on' : ''}" d=${edgePath(from, to)}><title>${from.phase} to ${to.phase}: ${when}</title></path>`;
  }

  private renderNode(node: Node, on: boolean, passed: boolean): SVGTemplateResult {
    const name = `${passed && !on ? '✓ ' : on ? '▶ ' : ''}${node.phase.replace('_', ' ')}`;
    return svg`<g class="node ${on ? 'is-on' : passed ? 'is-passed' : ''} is-${node.kind}" transform="translate(${node.x} ${node.y})">
      <title>${node.phase}: ${phaseWord(node.phase)}</title>
      <rect width=${kNodeWidth} height=${kNodeHeight} rx="4"></rect>
      <text x=${kNodeWidth / 2} y=${kNodeHeight / 2 + 4}>${name}</text></g>`;
  }
}
customElements.define('mmi-procedure', Procedure);
