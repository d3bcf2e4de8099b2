import draco from 'draco3d';

/** An attribute of vertices, and how many numbers it has for each. */
export interface DracoValues {
  values: Float32Array | Uint8Array;
  size: number;
}

/**
 * Packs triangles with Draco, without loss.
 *
 * @param attributes by their names in glTF, in the order they are packed in
 * @returns the packed bytes, and the ids of the attributes in them
 */
export async function encodeDraco(
  attributes: Readonly<Record<string, DracoValues>>,
  indices: readonly number[],
): Promise<{ bytes: Uint8Array; ids: Record<string, number> }> {
  const encoders = await draco.createEncoderModule({});
  const kinds: Record<string, number> = {
    POSITION: encoders.POSITION,
    NORMAL: encoders.NORMAL,
    COLOR_0: encoders.COLOR,
    TEXCOORD_0: encoders.TEX_COORD,
  };
  const mesh = new encoders.Mesh();
  const builder = new encoders.MeshBuilder();
  const encoder = new encoders.Encoder();
  const packed = new encoders.DracoInt8Array();
  builder.AddFacesToMesh(mesh, indices.length / 3, Uint32Array.from(indices));
  const ids: Record<string, number> = {};
  for (const [name, { values, size }] of Object.entries(attributes)) {
    const kind = kinds[name] ?? encoders.GENERIC;
    const count = values.length / size;
    ids[name] =
      values instanceof Float32Array
        ? builder.AddFloatAttribute(mesh, kind, count, size, values)
        : builder.AddUInt8Attribute(mesh, kind, count, size, values);
  }
  const length = encoder.EncodeMeshToDracoBuffer(mesh, packed);
  const bytes = Uint8Array.from({ length }, (_, i) => packed.GetValue(i));
  for (const made of [packed, encoder, builder, mesh]) encoders.destroy(made);
  return { bytes, ids };
}
