// Decodes a GLB's pictures from its own bytes. GLTFLoader would make an address for each and fetch it.

import { LinearFilter, LinearMipmapLinearFilter, RepeatWrapping, ClampToEdgeWrapping, MirroredRepeatWrapping, Texture, type Wrapping } from 'three';
import type { GLTFParser, GLTFLoaderPlugin } from 'three/examples/jsm/loaders/GLTFLoader.js';

interface TextureEntry {
  source?: number;
  sampler?: number;
  extensions?: { EXT_texture_webp?: { source?: number } };
}
interface ImageEntry {
  bufferView?: number;
  mimeType?: string;
}
interface SamplerEntry {
  wrapS?: number;
  wrapT?: number;
}
interface Document {
  textures?: TextureEntry[];
  images?: ImageEntry[];
  samplers?: SamplerEntry[];
}

const wrappings: Record<number, Wrapping> = { 33071: ClampToEdgeWrapping, 33648: MirroredRepeatWrapping, 10497: RepeatWrapping };

export class ImagePlugin implements GLTFLoaderPlugin {
  readonly name = 'images_from_buffers';
  private readonly bitmaps = new Map<number, Promise<ImageBitmap | null>>();

  constructor(private readonly parser: GLTFParser) {}

  async loadTexture(index: number): Promise<Texture> {
    const document = this.parser.json as Document;
    const entry = document.textures?.[index] ?? {};
    const source = entry.extensions?.EXT_texture_webp?.source ?? entry.source;
    const sampler = document.samplers?.[entry.sampler ?? -1] ?? {};
    const texture = new Texture(source === undefined ? undefined : await this.bitmap(document, source));
    texture.flipY = false;
    texture.wrapS = wrappings[sampler.wrapS ?? 10497] ?? RepeatWrapping;
    texture.wrapT = wrappings[sampler.wrapT ?? 10497] ?? RepeatWrapping;
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearMipmapLinearFilter;
    texture.anisotropy = 4;
    texture.needsUpdate = true;
    this.parser.associations.set(texture, { textures: index });
    return texture;
  }

  /** Null if the browser can't decode it: the surface is plain then. */
  private bitmap(document: Document, source: number): Promise<ImageBitmap | null> {
    let bitmap = this.bitmaps.get(source);
    if (!bitmap) {
      bitmap = this.decode(document.images?.[source] ?? {});
      this.bitmaps.set(source, bitmap);
    }
    return bitmap;
  }

  private async decode(image: ImageEntry): Promise<ImageBitmap | null> {
    if (image.bufferView === undefined) return null;
    try {
      const bytes = (await this.parser.getDependency('bufferView', image.bufferView)) as ArrayBuffer;
      const blob = new Blob([bytes], { type: image.mimeType ?? '' });
      return await createImageBitmap(blob, { premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
    } catch {
      return null;
    }
  }
}
