import {Color, LineBasicMaterial, MeshBasicMaterial, MeshStandardMaterial, type Material} from 'three';

/**
 * Materials, each made once: with the last one of a kind that is disposed of goes its program, and to compile it anew for
 * every drawing takes most of a processor's time.
 */
export class Materials {
  private readonly kept = new Map<string, Material>();

  /** What is lit. */
  solid(colour: string, opacity = 1): Material {
    return this.get(
      `solid ${colour} ${opacity}`,
      () => new MeshStandardMaterial({color: new Color(colour), transparent: opacity < 1, opacity, roughness: 0.6}),
    );
  }

  /** What hides nothing that is in it. */
  veil(colour: string): Material {
    return this.get(
      `veil ${colour}`,
      () => new MeshBasicMaterial({color: new Color(colour), transparent: true, opacity: 0.3, depthWrite: false}),
    );
  }

  line(colour: string, opacity = 1): Material {
    return this.get(
      `line ${colour} ${opacity}`,
      () => new LineBasicMaterial({color: new Color(colour), transparent: opacity < 1, opacity}),
    );
  }

  dispose(): void {
    for (const material of this.kept.values()) material.dispose();
    this.kept.clear();
  }

  private get(name: string, make: () => Material): Material {
    const known = this.kept.get(name);
    if (known) return known;
    const made = make();
    this.kept.set(name, made);
    return made;
  }
}
