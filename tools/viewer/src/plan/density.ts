// Very many paths as one image: how many pass each pixel. Ten thousand strokes would keep a canvas busy for seconds.

export class Density {
  private readonly counts: Uint16Array;

  constructor(
    private readonly width: number,
    private readonly height: number,
  ) {
    this.counts = new Uint16Array(width * height);
  }

  /** Points are pixels. */
  add(points: readonly (readonly [number, number])[]): void {
    for (let i = 1; i < points.length; ++i) this.addSegment(points[i - 1]!, points[i]!);
  }

  /** In a colour, the denser the more opaque. */
  image(color: readonly [number, number, number]): ImageData {
    const image = new ImageData(this.width, this.height);
    const most = Math.log1p(this.counts.reduce((most, count) => Math.max(most, count), 1));
    this.counts.forEach((count, i) => {
      if (count === 0) return;
      const share = Math.log1p(count) / most;
      image.data.set([...color, 255 * (0.25 + 0.7 * share)], i * 4);
    });
    return image;
  }

  private addSegment([ax, ay]: readonly [number, number], [bx, by]: readonly [number, number]): void {
    const steps = Math.max(1, Math.ceil(Math.max(Math.abs(bx - ax), Math.abs(by - ay))));
    for (let i = 0; i < steps; ++i) {
      const x = Math.round(ax + ((bx - ax) * i) / steps);
      const y = Math.round(ay + ((by - ay) * i) / steps);
      if (x >= 0 && y >= 0 && x < this.width && y < this.height) ++this.counts[y * this.width + x]!;
    }
  }
}

/** Of "#rrggbb". */
export function channelsOf(color: string): [number, number, number] {
  const value = parseInt(color.replace('#', ''), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}
