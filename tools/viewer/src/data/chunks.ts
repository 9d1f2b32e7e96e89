// The page's chunks: base64 in script elements, as format.ts says. Nothing is loaded from elsewhere.

export class BadReport extends Error {}

export class Chunks {
  /** An element is forgotten once its bytes were handed out for good. */
  private readonly elements = new Map<string, HTMLScriptElement>();

  constructor(page: ParentNode) {
    for (const element of page.querySelectorAll<HTMLScriptElement>('script[data-chunk]')) {
      this.elements.set(element.dataset.chunk ?? '', element);
    }
  }

  /** Unpacked. Frees the text if it is needed only once. */
  async bytes(name: string | number, once: boolean): Promise<Uint8Array<ArrayBuffer>> {
    const element = this.elementOf(name);
    const packed = fromBase64(element.textContent ?? '', name);
    if (once) {
      this.elements.delete(String(name));
      element.remove();
    }
    try {
      const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
      return new Uint8Array(await new Response(stream).arrayBuffer());
    } catch {
      throw new BadReport(`This report is damaged: its part ${name} can't be unpacked. Write it again.`);
    }
  }

  async text(name: string | number, once = false): Promise<string> {
    return new TextDecoder().decode(await this.bytes(name, once));
  }

  /** A picture as a data: address, for <img>. */
  picture(name: number): string | null {
    const element = this.elements.get(String(name));
    const type = element?.dataset.type ?? '';
    if (!element || !/^image\/(webp|png|jpeg|gif|apng)$/.test(type)) return null;
    return `data:${type};base64,${(element.textContent ?? '').trim()}`;
  }

  private elementOf(name: string | number): HTMLScriptElement {
    const element = this.elements.get(String(name));
    if (!element) {
      throw new BadReport(
        name === 'index'
          ? "This report isn't complete: the run ended, or the copying, before it was written. Write it again."
          : `This report is damaged: its part ${name} is missing. Write it again.`,
      );
    }
    return element;
  }
}

function fromBase64(text: string, name: string | number): Uint8Array<ArrayBuffer> {
  let binary: string;
  try {
    binary = atob(text.trim());
  } catch {
    throw new BadReport(`This report is damaged: its part ${name} isn't base64. Write it again.`);
  }
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}
