// A list of which only the rows in view are in the page. Rows have heights that are known beforehand.

import { element, Scope } from './dom';

interface VirtualRows {
  count: number;
  height: (row: number) => number;
  /** Equal keys mean that an element can be used again as it is. */
  key: (row: number) => string | number;
  render: (row: number) => HTMLElement;
}

const beyond = 240; // pixels drawn above and below what is in view

export class VirtualList {
  readonly root: HTMLElement;
  private readonly content: HTMLElement;
  private rows: VirtualRows = { count: 0, height: () => 0, key: () => 0, render: () => element('div') };
  /** Where each row begins, and the end of the last. */
  private tops = new Float64Array(1);
  private drawn = new Map<string | number, HTMLElement>();
  private pending = 0;

  constructor(scope: Scope, className: string) {
    this.content = element('div', { class: 'virtual-content', attributes: { role: 'list' } });
    this.root = element('div', { class: `virtual ${className}`, attributes: { tabindex: 0 } }, this.content);
    scope.listen(this.root, 'scroll', () => this.schedule(), { passive: true });
    scope.resized(this.root, () => this.draw());
    scope.add(() => cancelAnimationFrame(this.pending));
  }

  show(rows: VirtualRows): void {
    this.rows = rows;
    this.tops = new Float64Array(rows.count + 1);
    for (let i = 0; i < rows.count; ++i) this.tops[i + 1] = this.tops[i]! + rows.height(i);
    this.content.style.height = `${this.tops[rows.count]}px`;
    this.drawn.forEach((row) => row.remove());
    this.drawn.clear();
    this.draw();
  }

  /** The elements that are drawn now, by key. */
  get visibleRows(): ReadonlyMap<string | number, HTMLElement> {
    return this.drawn;
  }

  /** Scrolls the row to the middle, unless it is in view. */
  reveal(row: number): void {
    const top = this.tops[row] ?? 0;
    const bottom = this.tops[row + 1] ?? top;
    const { scrollTop, clientHeight } = this.root;
    if (top >= scrollTop && bottom <= scrollTop + clientHeight) return;
    this.root.scrollTop = (top + bottom - clientHeight) / 2;
    this.draw();
  }

  private schedule(): void {
    this.pending ||= requestAnimationFrame(() => {
      this.pending = 0;
      this.draw();
    });
  }

  private draw(): void {
    const from = this.root.scrollTop - beyond;
    const to = this.root.scrollTop + this.root.clientHeight + beyond;
    const wanted = new Map<string | number, HTMLElement>();
    for (let row = this.rowAt(from); row < this.rows.count && this.tops[row]! < to; ++row) {
      const key = this.rows.key(row);
      const made = this.drawn.get(key) ?? this.make(row);
      this.drawn.delete(key);
      wanted.set(key, made);
    }
    this.drawn.forEach((row) => row.remove());
    this.drawn = wanted;
  }

  private make(row: number): HTMLElement {
    const made = this.rows.render(row);
    made.classList.add('virtual-row');
    made.style.transform = `translateY(${this.tops[row]}px)`;
    made.style.height = `${this.rows.height(row)}px`;
    made.setAttribute('role', 'listitem');
    made.setAttribute('aria-setsize', String(this.rows.count));
    made.setAttribute('aria-posinset', String(row + 1));
    this.content.append(made);
    return made;
  }

  private rowAt(height: number): number {
    let low = 0;
    let high = this.rows.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.tops[middle + 1]! <= height) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}
