import { strToU8, zipSync } from 'three/addons/libs/fflate.module.js';
import { BOX_CORNERS, BOX_FACES } from './box.js';

/** The box whose faces across x, y and z are red, green and blue, in the formats that three's own loaders read. */

const COLOURS = ['1 0 0', '0 1 0', '0 0 1'];
const NAMES = ['red', 'green', 'blue'];
/** The two faces across each axis. */
const PAIRS = [0, 1, 2].map((axis) => [BOX_FACES[2 * axis], BOX_FACES[2 * axis + 1]]);
const POINTS = BOX_CORNERS.map((corner) => corner.join(' '));

export const zip = (files: Readonly<Record<string, string | Uint8Array>>, level: 0 | 9 = 9): Uint8Array =>
  zipSync(
    Object.fromEntries(
      Object.entries(files).map(([path, content]) => [path, typeof content === 'string' ? strToU8(content) : content]),
    ),
    { level },
  );

/** Times in FBX: a second has 46,186,158,000 of its units. The box moves from x = 5 to x = 9. */
const FBX_MOTION = `	AnimationStack: 20, "AnimStack::go", "" {
	}
	AnimationLayer: 21, "AnimLayer::base", "" {
	}
	AnimationCurveNode: 22, "AnimCurveNode::T", "" {
		Properties70:  {
			P: "d|X", "Number", "", "A",5
		}
	}
	AnimationCurve: 23, "AnimCurve::", "" {
		KeyTime: *2 {
			a: 0,46186158000
		}
		KeyValueFloat: *2 {
			a: 5,9
		}
	}
`;
const FBX_MOTION_CONNECTIONS = `	C: "OO",21,20
	C: "OO",22,21
	C: "OP",22,2, "Lcl Translation"
	C: "OP",23,22, "d|X"
`;

/** An FBX file as text, with a camera. */
export const fbx = (version = 7300, moves = false): string => `; FBX ${version / 1000} project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: ${version}
}
GlobalSettings:  {
	Version: 1000
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",1
	}
}
Objects:  {
	NodeAttribute: 4, "NodeAttribute::eye", "Camera" {
		Properties70:  {
			P: "FieldOfView", "FieldOfView", "", "A",40
		}
		TypeFlags: "Camera"
	}
	Geometry: 1, "Geometry::box", "Mesh" {
		Vertices: *24 {
			a: ${BOX_CORNERS.flat().join()}
		}
		PolygonVertexIndex: *24 {
			a: ${BOX_FACES.map(([a, b, c, d]) => [a, b, c, -1 - d].join()).join()}
		}
		GeometryVersion: 124
		LayerElementMaterial: 0 {
			Version: 101
			Name: ""
			MappingInformationType: "ByPolygon"
			ReferenceInformationType: "IndexToDirect"
			Materials: *6 {
				a: 0,0,1,1,2,2
			}
		}
		Layer: 0 {
			Version: 100
			LayerElement:  {
				Type: "LayerElementMaterial"
				TypedIndex: 0
			}
		}
	}
	Model: 2, "Model::box", "Mesh" {
		Version: 232
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",5,0,0
		}
	}
	Model: 3, "Model::eye", "Camera" {
		Version: 232
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",0,0,9
		}
	}
${COLOURS.map(
  (colour, i) => `	Material: ${11 + i}, "Material::${NAMES[i]}", "" {
		Version: 102
		ShadingModel: "lambert"
		Properties70:  {
			P: "DiffuseColor", "Color", "", "A",${colour.replaceAll(' ', ',')}
		}
	}`,
).join('\n')}
${moves ? FBX_MOTION : ''}}
Connections:  {
	C: "OO",2,0
	C: "OO",3,0
	C: "OO",4,3
	C: "OO",1,2
	C: "OO",11,2
	C: "OO",12,2
	C: "OO",13,2
${moves ? FBX_MOTION_CONNECTIONS : ''}}
`;

const MATRICES = [0, 5].map((x) => `1 0 0 ${x} 0 1 0 0 0 0 1 0 0 0 0 1`);
const DAE_MOTION = `<library_animations><animation id="motion">
    <source id="times"><float_array id="times-array" count="2">0 1</float_array>
      <technique_common><accessor source="#times-array" count="2" stride="1"/></technique_common></source>
    <source id="matrices"><float_array id="matrices-array" count="32">${MATRICES.join(' ')}</float_array>
      <technique_common><accessor source="#matrices-array" count="2" stride="16"/></technique_common></source>
    <sampler id="sampler"><input semantic="INPUT" source="#times"/><input semantic="OUTPUT" source="#matrices"/></sampler>
    <channel source="#sampler" target="node/transform"/></animation></library_animations>`;

/** A COLLADA file with z up, comments and entities. @param picture of the red faces */
export const dae = (picture?: string, moves = false): string => `<?xml version="1.0" encoding="utf-8"?>
<!-- a box > a point -->
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="inch" meter="0.0254"/><up_axis>Z_UP</up_axis></asset>
  ${picture ? `<library_images><image id="picture"><init_from>${picture}</init_from></image></library_images>` : ''}
  <library_effects>${COLOURS.map(
    (colour, i) => `<effect id="effect-${NAMES[i]}"><profile_COMMON>
      ${
        picture && i === 0
          ? `<newparam sid="surface"><surface type="2D"><init_from>picture</init_from></surface></newparam>
      <newparam sid="sampler"><sampler2D><source>surface</source></sampler2D></newparam>`
          : ''
      }
      <technique sid="common"><lambert><diffuse>${
        picture && i === 0 ? '<texture texture="sampler" texcoord="UV"/>' : `<color>${colour} 1</color>`
      }</diffuse></lambert></technique></profile_COMMON></effect>`,
  ).join('')}</library_effects>
  <library_materials>${NAMES.map(
    (name) => `<material id="${name}" name="${name} &amp; more"><instance_effect url="#effect-${name}"/></material>`,
  ).join('')}</library_materials>
  ${moves ? DAE_MOTION : ''}
  <library_geometries><geometry id="box"><mesh>
    <source id="points"><float_array id="points-array" count="24">${POINTS.join(' ')}</float_array>
      <technique_common><accessor source="#points-array" count="8" stride="3"/></technique_common></source>
    <source id="uvs"><float_array id="uvs-array" count="8">0 0 1 0 1 1 0 1</float_array>
      <technique_common><accessor source="#uvs-array" count="4" stride="2"/></technique_common></source>
    <vertices id="vertices"><input semantic="POSITION" source="#points"/></vertices>
    ${PAIRS.map(
      (faces, i) => `<polylist material="${NAMES[i]}" count="2">
      <input semantic="VERTEX" source="#vertices" offset="0"/>
      <input semantic="TEXCOORD" source="#uvs" offset="1" set="0"/>
      <vcount>4 4</vcount><p>${faces.map((face) => face.map((corner, k) => `${corner} ${k}`).join(' ')).join(' ')}</p></polylist>`,
    ).join('')}
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="scene"><node id="node"><matrix sid="transform">${MATRICES[0]}</matrix><instance_geometry url="#box"><bind_material>
    <technique_common>${NAMES.map((name) => `<instance_material symbol="${name}" target="#${name}"/>`).join('')}</technique_common>
  </bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
`;

/** A VRML file with a sky around the scene. */
export const wrl = (): string => `#VRML V2.0 utf8
Background { skyColor [ 0 0 1, 0.5 0.5 1 ] skyAngle [ 1.5 ] groundColor [ 0 1 0, 0 1 0 ] groundAngle [ 1.5 ] }
${PAIRS.map(
  (faces, i) => `Shape {
  appearance Appearance { material Material { diffuseColor ${COLOURS[i]} } }
  geometry IndexedFaceSet {
    coord Coordinate { point [ ${POINTS.join(', ')} ] }
    coordIndex [ ${faces.map((face) => `${face.join(', ')}, -1`).join(', ')} ]
  }
}`,
).join('\n')}
`;

const usdColour = (i: number): string => `(${COLOURS[i].replaceAll(' ', ', ')})`;

/** A USD file as text. @param picture of the red faces */
export const usda = (picture?: string): string => `#usda 1.0
(
    defaultPrim = "Root"
    upAxis = "Y"
)

def Xform "Root"
{
${PAIRS.map(
  (faces, i) => `    def Mesh "mesh${i}"
    {
        int[] faceVertexCounts = [4, 4]
        int[] faceVertexIndices = [${faces.flat().join(', ')}]
        point3f[] points = [${BOX_CORNERS.map((corner) => `(${corner.join(', ')})`).join(', ')}]
        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (
            interpolation = "faceVarying"
        )
        int[] primvars:st:indices = [0, 1, 2, 3, 0, 1, 2, 3]
        rel material:binding = </Root/Materials/${NAMES[i]}>
    }
`,
).join('\n')}
    def Scope "Materials"
    {
${NAMES.map(
  (name, i) => `        def Material "${name}"
        {
            token outputs:surface.connect = </Root/Materials/${name}/Surface.outputs:surface>
            def Shader "Surface"
            {
                uniform token info:id = "UsdPreviewSurface"
                ${
                  picture && i === 0
                    ? `color3f inputs:diffuseColor.connect = </Root/Materials/${name}/Picture.outputs:rgb>`
                    : `color3f inputs:diffuseColor = ${usdColour(i)}`
                }
                token outputs:surface
            }
${
  picture && i === 0
    ? `            def Shader "Picture"
            {
                uniform token info:id = "UsdUVTexture"
                asset inputs:file = @${picture}@
                float3 outputs:rgb
            }`
    : ''
}
        }
`,
).join('\n')}
    }
}
`;

/** A 3MF file, with colours of triangles and a prefix for their namespace. `changed` may change its model. */
export const threeMf = (level?: 0 | 9, changed = (model: string) => model): Uint8Array => {
  const triangles = BOX_FACES.flatMap(([a, b, c, d], face) =>
    [
      [a, b, c],
      [a, c, d],
    ].map(
      (corners) =>
        `<triangle v1="${corners[0]}" v2="${corners[1]}" v3="${corners[2]}" pid="2" p1="${face >> 1}" p2="${face >> 1}" p3="${face >> 1}"/>`,
    ),
  );
  return zip(
    {
      '[Content_Types].xml': '<Types/>',
      '_rels/.rels': '<Relationships><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="model"/></Relationships>',
      '3D/3dmodel.model':
        changed(`<?xml version="1.0"?><model unit="millimeter" xmlns="core" xmlns:m="materials"><resources>
      <m:colorgroup id="2"><m:color color="#FF0000"/><m:color color="#00FF00"/><m:color color="#0000FF"/></m:colorgroup>
      <object id="1" type="model" pid="2" pindex="0"><mesh>
        <vertices>${BOX_CORNERS.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`).join('')}</vertices>
        <triangles>${triangles.join('')}</triangles></mesh></object>
      </resources><build><item objectid="1"/></build></model>`),
    },
    level,
  );
};

/** A part of a 3DS file, of other parts and numbers. */
export function chunk(id: number, ...parts: (Uint8Array | number[])[]): Uint8Array {
  const bytes = new Uint8Array(6 + parts.reduce((sum, part) => sum + part.length, 0));
  const view = new DataView(bytes.buffer);
  view.setUint16(0, id, true);
  view.setUint32(2, bytes.length, true);
  let at = 6;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

export const shorts = (...values: number[]): Uint8Array => new Uint8Array(Uint16Array.from(values).buffer);
/** A text of a 3DS file. */
export const text = (value: string): Uint8Array => strToU8(`${value}\0`);

/** A 3DS file. */
export const tds = (): Uint8Array => {
  const corners = BOX_FACES.flatMap(([a, b, c, d]) => [a, b, c, 0, a, c, d, 0]);
  const materials = NAMES.map((name, i) =>
    chunk(
      0xafff,
      chunk(0xa000, text(name)),
      chunk(
        0xa020,
        chunk(
          0x0011,
          COLOURS[i].split(' ').map((v) => 255 * Number(v)),
        ),
      ),
    ),
  );
  const groups = NAMES.map((name, i) =>
    chunk(0x4130, text(name), shorts(4, ...[0, 1, 2, 3].map((triangle) => 4 * i + triangle))),
  );
  const mesh = chunk(
    0x4100,
    chunk(0x4110, shorts(8), new Uint8Array(Float32Array.from(BOX_CORNERS.flat()).buffer)),
    chunk(0x4120, shorts(12, ...corners), ...groups),
  );
  return chunk(0x4d4d, chunk(0x0002, [3, 0, 0, 0]), chunk(0x3d3d, ...materials, chunk(0x4000, text('box'), mesh)));
};
