// Deep links: #walk=ID&t=12.35 shows a walk at a time, #q=s:failed filters the list.

interface Link {
  /** Id of a walk; none: the list. */
  walk?: string;
  /** Seconds. */
  time?: number;
  /** Compared with the walk of the other run. */
  against?: boolean;
  camera?: string;
  query?: string;
}

export function parseLink(hash: string): Link {
  const values = new URLSearchParams(hash.replace(/^#/, ''));
  const time = Number(values.get('t') ?? NaN);
  return {
    ...(values.get('walk') ? { walk: values.get('walk')! } : {}),
    ...(Number.isFinite(time) ? { time: Math.max(0, time) } : {}),
    ...(values.has('against') ? { against: true } : {}),
    ...(values.get('camera') ? { camera: values.get('camera')! } : {}),
    ...(values.get('q') ? { query: values.get('q')! } : {}),
  };
}

export function formatLink(link: Link): string {
  const parts: string[] = [];
  const add = (name: string, value: string): void => void parts.push(`${name}=${encodeURIComponent(value)}`);
  if (link.walk !== undefined) add('walk', link.walk);
  if (link.time !== undefined) add('t', String(Math.round(link.time * 1000) / 1000));
  if (link.against) add('against', '1');
  if (link.camera) add('camera', link.camera);
  if (link.query) add('q', link.query);
  return parts.length > 0 ? `#${parts.join('&').replaceAll('%2F', '/').replaceAll('%3A', ':')}` : '#';
}
