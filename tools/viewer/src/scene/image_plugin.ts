// Decodes a GLB's pictures from its own bytes. GLTFLoader would make an address for each and fetch it.

import {
  ClampToEdgeWrapping,
  LinearFilter,
  LinearMipmapLinearFilter,
  MirroredRepeatWrapping,
  RepeatWrapping,
  Texture,
  type Wrapping,
} from 'three';
import type { GLTFLoaderPlugin, GLTFParser } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { kept } from '../data/kept';

interface Document {
  textures?: { sampler?: number }[];
  images?: { bufferView?: number; mimeType?: string }[];
  samplers?: { wrapS?: number; wrapT?: number }[];
}

const wrappings: Record<number, Wrapping> = {
  10497: RepeatWrapping,
  33071: ClampToEdgeWrapping,
  33648: MirroredRepeatWrapping,
};

export class ImagePlugin implements GLTFLoaderPlugin {
  readonly name = 'images_from_buffers';
  private readonly bitmaps = new Map<number, Promise<ImageBitmap | null>>();

  constructor(private readonly parser: GLTFParser) {
    // What all ways to a texture end in, those of EXT_texture_webp, too.
    parser.loadTextureImage = (texture: number, source: number) => this.load(texture, source);
  }

  private async load(index: number, source: number): Promise<Texture> {
    const document = this.parser.json as Document;
    const sampler = document.samplers?.[document.textures?.[index]?.sampler ?? -1] ?? {};
    const texture = new Texture((await this.bitmap(document, source)) ?? undefined);
    texture.flipY = false;
    texture.wrapS = wrappings[sampler.wrapS ?? 10497] ?? RepeatWrapping;
    texture.wrapT = wrappings[sampler.wrapT ?? 10497] ?? RepeatWrapping;
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearMipmapLinearFilter;
    texture.anisotropy = 4;
    texture.needsUpdate = texture.image !== null;
    this.parser.associations.set(texture, { textures: index });
    return texture;
  }

  private bitmap(document: Document, source: number): Promise<ImageBitmap | null> {
    return kept(this.bitmaps, source, () => this.decode(document.images?.[source] ?? {}));
  }

  /** Null if the browser can't: the surface is plain then. */
  private async decode(image: { bufferView?: number; mimeType?: string }): Promise<ImageBitmap | null> {
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
