// Elements from code. Strings become text nodes: nothing from a file is ever parsed as markup.

import { visible } from '../data/text';

export type Child = Node | string | number | null | undefined | false;

interface Properties {
  class?: string;
  text?: string;
  title?: string;
  /** Attributes, such as aria-label; null and false leave them out. */
  attributes?: Record<string, string | number | boolean | null | undefined>;
  on?: { [Type in keyof HTMLElementEventMap]?: (event: HTMLElementEventMap[Type]) => void };
}

export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  properties: Properties = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  if (properties.class) made.className = properties.class;
  if (properties.title) made.title = visible(properties.title);
  for (const [name, value] of Object.entries(properties.attributes ?? {})) {
    if (value !== null && value !== undefined && value !== false) {
      made.setAttribute(name, value === true ? '' : visible(String(value)));
    }
  }
  for (const [type, listener] of Object.entries(properties.on ?? {})) {
    made.addEventListener(type, listener as EventListener);
  }
  if (properties.text !== undefined) made.append(visible(properties.text));
  append(made, ...children);
  return made;
}

export function append(parent: Node, ...children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    parent.appendChild(child instanceof Node ? child : document.createTextNode(visible(String(child))));
  }
}

export function replace(parent: Node, ...children: Child[]): void {
  while (parent.firstChild) parent.removeChild(parent.firstChild);
  append(parent, ...children);
}

export function setText(node: Node, text: string): void {
  const shown = visible(text);
  if (node.textContent !== shown) node.textContent = shown;
}

/** A name from a file, whose direction of writing stays inside it. */
export function name(text: string, className = ''): HTMLElement {
  return element('bdi', { class: className, text });
}

/** What a view must undo when it goes. */
export class Scope {
  private readonly ends: (() => void)[] = [];
  private ended = false;

  add(end: () => void): void {
    if (this.ended) end();
    else this.ends.push(end);
  }

  listen<Type extends keyof WindowEventMap>(
    target: Window,
    type: Type,
    listener: (event: WindowEventMap[Type]) => void,
    options?: AddEventListenerOptions,
  ): void;
  listen<Type extends keyof HTMLElementEventMap>(
    target: HTMLElement | Document,
    type: Type,
    listener: (event: HTMLElementEventMap[Type]) => void,
    options?: AddEventListenerOptions,
  ): void;
  listen(target: EventTarget, type: string, listener: (event: never) => void, options?: AddEventListenerOptions): void {
    target.addEventListener(type, listener as EventListener, options);
    this.add(() => target.removeEventListener(type, listener as EventListener, options));
  }

  /** Calls `act` when the element's size changes, and once at the beginning. */
  resized(target: Element, act: () => void): void {
    const observer = new ResizeObserver(act);
    observer.observe(target);
    this.add(() => observer.disconnect());
  }

  get isOver(): boolean {
    return this.ended;
  }

  end(): void {
    this.ended = true;
    for (const end of this.ends.splice(0).reverse()) end();
  }
}
