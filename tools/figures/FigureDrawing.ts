import { DirectionalLight, Group, HemisphereLight, MathUtils, Mesh, PointLight, Scene, Vector3 } from 'three';
import {
  HatchingMaterial,
  HatchingOutlines,
  type HatchingPreset,
  type HatchingTechnique,
  presets,
  type StrokeStyleName,
  scalePreset,
  TonalArtMap,
} from 'three-hatching';
import { needsMap } from 'three-hatching/facts';
import { fitCamera } from '../../src/viewer/sceneSetup/framing.js';
import { createCamera } from '../../src/viewer/sceneSetup/LensCamera.js';
import { figureModel } from './figureModels.js';
import { PIXEL_RATIO } from './figurePixels.js';
import type { Figure, Look, Panel } from './figures.js';
import { memoize } from './memoize.js';

/** `asInPaper` draws each panel with its own technique, `hatching` replaces `adjacency` by anchored strokes. */
export type TechniqueChoice = 'asInPaper' | 'hatching';

const DEFAULT_REFLECTION = 0.35;
/** Factor on the stroke scale, because anchored strokes look coarser at the same scale. */
const ANCHORED_SCALE = 1.7;
/** Direction from the model to the eye unless a figure sets another: a little from the side and from above, as in the paper. */
const FIGURE_VIEW = [0.22, 0.18, 1] as const;
const AXES = { y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) } as const;

const mapOf = memoize((style: StrokeStyleName) => TonalArtMap.generate({ style }));

/** One panel of a figure, ready to be rendered. */
export class FigureDrawing {
  readonly scene = new Scene();
  /** The colour behind the model. */
  readonly paper: string;
  readonly camera = createCamera();
  private readonly materials: {
    material: HatchingMaterial;
    technique: HatchingTechnique;
    tilesPerObjectUnit: number;
  }[] = [];
  private readonly light;
  private readonly reflected = new HemisphereLight('white', 'black');
  private readonly lightPosition = new Vector3();

  private constructor(
    private readonly figure: Figure,
    panel: Panel,
    paper: string,
  ) {
    this.paper = paper;
    const { kind = 'sun', position, reflected = DEFAULT_REFLECTION } = panel.light ?? figure.light;
    // The light does not decay: turning it turns the strokes and does not change the exposure.
    this.light = kind === 'lamp' ? new PointLight('white', Math.PI, 0, 0) : new DirectionalLight('white', Math.PI);
    this.lightPosition.fromArray(position);
    this.reflected.intensity = Math.PI * reflected;
    this.reflected.visible = reflected > 0;
    this.scene.add(this.light, this.reflected);
  }

  /** Loads the model and the maps of a panel. @throws ModelError if the model cannot be loaded */
  static async make(figure: Figure, panel: Panel, ink: string, paper: string): Promise<FigureDrawing> {
    const paperOf = ({ preset }: Look): string => (preset && String(presets[preset].material.paper)) ?? paper;
    const drawing = new FigureDrawing(figure, panel, paperOf({ ...figure.look, ...panel.look }));
    const [model] = await Promise.all([figureModel(panel.model ?? figure.model), HatchingMaterial.preload()]);
    const group = new Group();
    group.rotation.y = MathUtils.degToRad(panel.turned ?? 0);
    for (const [part, geometry] of Object.entries(model.parts)) {
      const look: Look = { ...figure.look, ...panel.look, ...panel.parts?.[part] };
      const { style, preset: name, outlines, ...options } = look;
      const preset: HatchingPreset | undefined = name && scalePreset(presets[name], PIXEL_RATIO);
      const technique = options.technique ?? preset?.material.technique ?? 'adjacency';
      const parameters = { ink, paper, ...preset?.material, ...options, technique, side: model.side };
      const material = new HatchingMaterial(parameters);
      if (needsMap(material)) material.tonalArtMap = await mapOf(style ?? preset?.tonalArtMap?.style ?? 'hatching');
      drawing.materials.push({ material, technique, tilesPerObjectUnit: material.tilesPerObjectUnit });
      const mesh = new Mesh(geometry, material);
      if (outlines !== false && (outlines || preset))
        mesh.add(new HatchingOutlines(mesh, { ink, ...preset?.outlines, ...outlines }));
      group.add(mesh);
    }
    drawing.scene.add(group);
    const { camera } = drawing;
    camera.aspect = figure.aspect;
    camera.updateProjectionMatrix();
    const view = new Vector3(...(panel.view ?? figure.view ?? FIGURE_VIEW));
    fitCamera(camera, model.framedPoints, view, { zoom: panel.zoom ?? figure.zoom });
    return drawing;
  }

  /** Turns the light by an angle in degrees from its position in the figure. */
  turnLight(degrees: number): void {
    const axis = AXES[this.figure.turnAxis ?? 'y'];
    this.light.position.copy(this.lightPosition).applyAxisAngle(axis, MathUtils.degToRad(degrees));
    this.reflected.position.copy(this.light.position).negate();
  }

  /** Sets the technique of the materials. */
  setTechnique(choice: TechniqueChoice): void {
    for (const { material, technique, tilesPerObjectUnit } of this.materials) {
      const isReplaced = choice === 'hatching' && technique === 'adjacency' && !this.figure.fixedTechnique;
      material.technique = isReplaced ? 'hatching' : technique;
      material.tilesPerObjectUnit = isReplaced ? ANCHORED_SCALE * tilesPerObjectUnit : tilesPerObjectUnit;
    }
  }
}
