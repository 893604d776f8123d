import { vi } from 'vitest';

/** As much of an element as panels and the header need. */
export class FakeElement {
  private readonly attributes = new Map<string, string>();
  private readonly listeners = new Map<string, ((event: unknown) => void)[]>();
  children: (FakeElement | string)[] = [];
  className = '';
  value = '';
  hidden = false;
  disabled = false;

  get textContent(): string {
    return this.children.map((child) => (typeof child === 'string' ? child : child.textContent)).join('');
  }
  set textContent(text: string) {
    this.children = [text];
  }
  append(...children: (FakeElement | string)[]): void {
    this.children.push(...children);
  }
  replaceChildren(...children: (FakeElement | string)[]): void {
    this.children = children;
  }
  setAttribute(name: string, value: string): void {
    this.attributes.set(name, value);
  }
  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null;
  }
  addEventListener(kind: string, listener: (event: unknown) => void): void {
    this.listeners.set(kind, [...(this.listeners.get(kind) ?? []), listener]);
  }
  fire(kind: string): void {
    for (const listener of this.listeners.get(kind) ?? []) listener({});
  }
  /** Itself and all that it holds. */
  get all(): FakeElement[] {
    return [this, ...this.children.flatMap((child) => (typeof child === 'string' ? [] : child.all))];
  }
  querySelectorAll(): FakeElement[] {
    return [];
  }
}

/** A document whose elements are made as they are asked for. @return one of them by its id */
export function fakePage(): (id: string) => FakeElement {
  const known = new Map<string, FakeElement>();
  const byId = (id: string): FakeElement => {
    if (!known.has(id)) known.set(id, new FakeElement());
    return known.get(id)!;
  };
  vi.stubGlobal('document', {
    createElement: () => new FakeElement(), getElementById: byId, activeElement: null, addEventListener: () => {},
  });
  return byId;
}
