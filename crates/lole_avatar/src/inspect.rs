//! What a file holds, as people and programs read it.

use std::collections::BTreeSet;

use lole_body::{Bone, Tape};
use lole_language::Sentence;
use lole_motion::{MapSource, axis_name};
use serde::Serialize;

use crate::AvatarError;
use crate::animation::{AnimationSummary, summaries};
use crate::avatar::Avatar;
use crate::container::{File, visible};
use crate::geometry::Geometry;
use crate::license::License;
use crate::rig::{RestPose, Rig};
use crate::vrm::{Format, expression_count};

/// What an avatar or a dance holds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AvatarInspection {
    /// Kind of file.
    pub format: &'static str,
    /// Program that wrote it.
    pub generator: Option<String>,
    /// The bones, if it is a person.
    pub humanoid: Option<Humanoid>,
    /// Why it is no dancer, in both languages.
    pub refused: Option<[String; 2]>,
    /// Its meshes, if it has any on its bones.
    pub meshes: Option<MeshSummary>,
    /// What a tape reads on its body, if it can be dressed.
    pub body: Option<BodySummary>,
    /// Its animations.
    pub animations: Vec<AnimationSummary>,
    /// Facial expressions.
    pub expression_count: usize,
    /// Conditions of use.
    pub license: License,
}

/// The person of a file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Humanoid {
    /// How the bones were recognized: by the file, by names of a family of programs, by how they
    /// hang together, or by a list.
    pub recognized_by: String,
    /// VRM names of bones with the names of their nodes.
    pub bones: Vec<(&'static str, String)>,
    /// VRM names of bones for which there is no node.
    pub missing: Vec<&'static str>,
    /// Axis of the file that points up.
    pub up: &'static str,
    /// Axis of the file that the avatar faces.
    pub front: &'static str,
    /// How the arms are held at rest.
    pub pose: RestPose,
    /// Unit of the file's numbers.
    pub unit: &'static str,
    /// Thigh and shank [m].
    pub leg_length_m: f32,
}

/// The body of an avatar, as it is dressed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BodySummary {
    /// Key of each measure with what the tape reads [cm].
    pub tape_cm: Vec<(&'static str, f64)>,
    /// Name and number of each measure [cm], in Japanese and in English.
    #[serde(skip)]
    named: Vec<[String; 2]>,
    /// Capsules that stand for the lower body.
    pub capsule_count: usize,
    /// Share of the skin from ankle to waist that lies close to them.
    pub capsule_close_share: f32,
    /// Share that lies outside them.
    pub capsule_outside_share: f32,
    /// Farthest that skin lies outside them [mm].
    pub capsule_farthest_mm: f32,
}

/// The meshes of a file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeshSummary {
    /// Meshes.
    pub mesh_count: usize,
    /// Vertices.
    pub vertex_count: usize,
    /// Triangles.
    pub triangle_count: usize,
    /// Materials that are used.
    pub material_count: usize,
    /// Pictures.
    pub texture_count: usize,
    /// Morph targets.
    pub morph_target_count: usize,
    /// From the lowest point to the highest, hair and shoes included [m].
    pub height_m: f32,
}

impl AvatarInspection {
    /// Looks into the bytes of a file; `list` says which node is which bone, `node = bone` on each
    /// line.
    ///
    /// # Errors
    /// A damaged file. One that is no person's is described, with the reason in
    /// [`Self::refused`].
    pub fn new(bytes: &[u8], list: Option<&str>) -> Result<Self, AvatarError> {
        let file = File::read(bytes)?;
        let format = Format::of(&file);
        let rig = match Rig::new(&file, list) {
            Ok(rig) => Ok(rig),
            Err(
                error @ (AvatarError::NotHumanoid(_)
                | AvatarError::FourLegged { .. }
                | AvatarError::UnknownScale { .. }),
            ) => Err(Sentence::of(&error)),
            Err(error) => return Err(error),
        };
        let meshes = match &rig {
            Ok(rig) => match Geometry::read(&file, rig) {
                Ok(geometry) => Some(MeshSummary::of(&file, &geometry)),
                Err(AvatarError::NoMesh) => None,
                Err(error) => return Err(error),
            },
            Err(_) => None,
        };
        let animations = match &rig {
            Ok(rig) => summaries(&file, rig)?,
            Err(_) => Vec::new(),
        };
        let body = meshes.as_ref().map(|_| BodySummary::of(&file, list));
        let (body, unmeasured) = match body {
            Some(Ok(body)) => (Some(body), None),
            Some(Err(error @ AvatarError::Body(_))) => (None, Some(Sentence::of(&error))),
            Some(Err(error)) => return Err(error),
            None => (None, None),
        };
        let refused = rig
            .as_ref()
            .err()
            .or(unmeasured.as_ref())
            .map(|said| [said.japanese.clone(), said.english.clone()]);
        Ok(Self {
            format: format.name(),
            generator: file.root.asset.generator.as_deref().map(visible),
            humanoid: rig.ok().map(|rig| Humanoid::of(&file, &rig)),
            refused,
            meshes,
            body,
            animations,
            expression_count: expression_count(&file, format),
            license: License::of(&file, format),
        })
    }

    /// What the file holds, as lines of text.
    #[must_use]
    pub fn lines(&self) -> Vec<Sentence> {
        let mut lines = vec![match &self.generator {
            Some(generator) => Sentence::new(
                format!("{}（{generator} で書き出し）", self.format),
                format!("{}, written by {generator}", self.format),
            ),
            None => Sentence::new(self.format, self.format),
        }];
        if let Some(title) = &self.license.title {
            lines.push(Sentence::new(
                format!("名前: {title}"),
                format!("name: {title}"),
            ));
        }
        if let Some(humanoid) = &self.humanoid {
            lines.extend(humanoid.lines());
        }
        if let Some([japanese, english]) = &self.refused {
            lines.push(Sentence::new(
                format!("踊り手にはなれません: {japanese}"),
                format!("cannot be a dancer: {english}"),
            ));
        }
        if let Some(meshes) = &self.meshes {
            lines.push(meshes.line(self.expression_count));
        }
        if let Some(body) = &self.body {
            lines.extend(body.lines());
        }
        lines.extend(self.animations.iter().map(AnimationSummary::line));
        lines.extend(self.license.lines());
        lines
    }
}

impl AnimationSummary {
    fn line(&self) -> Sentence {
        let Self {
            name,
            duration_s,
            key_count,
            bone_count,
        } = self;
        Sentence::new(
            format!("動き「{name}」: {duration_s:.2} 秒、キー {key_count} 個、骨 {bone_count} 本"),
            format!(
                "animation \"{name}\": {duration_s:.2} s, {key_count} keys, {bone_count} bones"
            ),
        )
    }
}

impl BodySummary {
    fn of(file: &File<'_>, list: Option<&str>) -> Result<Self, AvatarError> {
        let dancer = Avatar::of_file(file, list)?.dancer;
        let taped = dancer.taped(&Tape::default());
        let coverage = dancer.capsule_coverage();
        Ok(Self {
            tape_cm: (taped.iter())
                .map(|taped| (taped.measure.key(), taped.on_body.to_cm()))
                .collect(),
            named: (taped.iter())
                .map(|taped| {
                    let (words, cm) = (taped.measure.words(), taped.on_body.to_cm());
                    [words.japanese, words.english].map(|name| format!("{name} {cm:.1}"))
                })
                .collect(),
            capsule_count: dancer.capsules.len(),
            capsule_close_share: coverage.close,
            capsule_outside_share: coverage.outside,
            capsule_farthest_mm: 1e3 * coverage.farthest,
        })
    }

    fn lines(&self) -> [Sentence; 2] {
        let all = |language: usize| {
            let named: Vec<&str> = (self.named.iter())
                .map(|names| names[language].as_str())
                .collect();
            named.join(", ")
        };
        let [close, outside] =
            [self.capsule_close_share, self.capsule_outside_share].map(|share| 100.0 * share);
        let (count, farthest) = (self.capsule_count, self.capsule_farthest_mm);
        [
            Sentence::new(
                format!("採寸 [cm]: {}", all(0)),
                format!("tape [cm]: {}", all(1)),
            ),
            Sentence::new(
                format!(
                    "カプセル {count} 個: 足首からウエストの肌の {close:.0} % が近く、{outside:.0} % が外（最大 {farthest:.0} mm）"
                ),
                format!(
                    "{count} capsules: {close:.0} % of the skin from ankle to waist is close to them, \
                     {outside:.0} % outside, {farthest:.0} mm at most"
                ),
            ),
        ]
    }
}

impl MeshSummary {
    fn of(file: &File<'_>, geometry: &Geometry) -> Self {
        let [lowest, highest] = geometry.heights();
        let materials: BTreeSet<_> = geometry.parts.iter().map(|part| part.material).collect();
        Self {
            mesh_count: geometry.mesh_count,
            vertex_count: geometry.positions.len(),
            triangle_count: geometry.triangle_count(),
            material_count: materials.len(),
            texture_count: file.root.images.len(),
            morph_target_count: geometry.morph_count,
            height_m: highest - lowest,
        }
    }

    fn line(&self, expressions: usize) -> Sentence {
        let Self {
            mesh_count,
            vertex_count,
            triangle_count,
            material_count,
            texture_count,
            morph_target_count,
            height_m,
        } = self;
        let height = 100.0 * height_m;
        Sentence::new(
            format!(
                "高さ {height:.1} cm、メッシュ {mesh_count}、頂点 {vertex_count}、三角形 {triangle_count}、\
                 材質 {material_count}、画像 {texture_count}、モーフ {morph_target_count}、表情 {expressions}"
            ),
            format!(
                "{height:.1} cm high; {mesh_count} meshes, {vertex_count} vertices, {triangle_count} \
                 triangles, {material_count} materials, {texture_count} pictures, \
                 {morph_target_count} morph targets, {expressions} expressions"
            ),
        )
    }
}

impl Humanoid {
    fn of(file: &File<'_>, rig: &Rig) -> Self {
        let name = |joint: usize| visible(file.node_name(rig.nodes[joint]));
        let chain = |joints: &[usize]| {
            let names: Vec<String> = joints.iter().map(|&joint| name(joint)).collect();
            names.join(" – ")
        };
        // Trunk and neck are chains of any number of joints, shared among the bones there.
        let chained = [Bone::Spine, Bone::Chest, Bone::UpperChest, Bone::Neck];
        let own = Bone::ALL.iter().filter(|bone| !chained.contains(bone));
        let mut bones: Vec<(&'static str, String)> = (own.clone())
            .filter_map(|&bone| Some((bone.name(), name(rig.map.joint(bone)?))))
            .collect();
        bones.insert(1, ("spine", chain(rig.map.spine())));
        bones.insert(2, ("neck", chain(rig.map.neck())));
        let places = rig.rest.rest_places();
        let leg = |[upper, lower, foot, _]: [Bone; 4]| {
            let at = |bone| places[rig.map.joint(bone).unwrap_or_default()].position;
            at(upper).distance(at(lower)) + at(lower).distance(at(foot))
        };
        Self {
            recognized_by: match rig.map.source {
                MapSource::Names(program) => program.to_owned(),
                MapSource::Hierarchy => "hierarchy".to_owned(),
                MapSource::List => "list".to_owned(),
                MapSource::File(kind) => kind.to_owned(),
            },
            bones,
            missing: own
                .filter(|&&bone| rig.map.joint(bone).is_none())
                .map(|bone| bone.name())
                .collect(),
            up: axis_name(rig.axes.up),
            front: axis_name(rig.axes.front),
            pose: rig.rest_pose(),
            unit: rig.unit.0,
            leg_length_m: 0.5 * (leg(Bone::LEGS[0]) + leg(Bone::LEGS[1])) * rig.unit.1,
        }
    }

    fn lines(&self) -> Vec<Sentence> {
        let pose = match self.pose {
            RestPose::T => ("T ポーズ", "T pose"),
            RestPose::A => ("A ポーズ", "A pose"),
            RestPose::ArmsDown => ("腕を下ろした姿勢", "arms down"),
            RestPose::Other => ("T でも A でもない姿勢", "neither T nor A pose"),
        };
        let (unit, leg) = (self.unit, 100.0 * self.leg_length_m);
        let bones: Vec<String> = (self.bones.iter())
            .map(|(bone, node)| format!("{bone} = {node}"))
            .collect();
        let bones = bones.join(", ");
        let by = match self.recognized_by.as_str() {
            "hierarchy" => ("つながり方", "how they hang together"),
            "list" => ("対応表", "the list"),
            other => (other, other),
        };
        let mut lines = vec![
            Sentence::new(
                format!(
                    "上は {}、正面は {}、{}、単位 {unit}、脚 {leg:.1} cm",
                    self.up, self.front, pose.0
                ),
                format!(
                    "up is {}, front is {}, {}, in {unit}, legs of {leg:.1} cm",
                    self.up, self.front, pose.1
                ),
            ),
            Sentence::new(
                format!("骨の見分け方: {}", by.0),
                format!("bones recognized by: {}", by.1),
            ),
            Sentence::new(format!("骨: {bones}"), format!("bones: {bones}")),
        ];
        if !self.missing.is_empty() {
            let names = self.missing.join(", ");
            lines.push(Sentence::new(
                format!("ない骨（親とともに動きます）: {names}"),
                format!("missing bones, which go with the one they hang on: {names}"),
            ));
        }
        lines
    }
}
