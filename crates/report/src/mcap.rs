//! A hazard as an MCAP recording, for Foxglove (3-D, plots) and PlotJuggler (plots): everything in it is JSON with its
//! schema.
//!
//! Time begins with the sequence. Topics: `/scene` (`foxglove.SceneUpdate`), `/hazard` (the curves of the report),
//! `/sensors`, and for cells of one FMU `/fmu/inputs` and `/fmu/outputs`.

use std::collections::BTreeMap;
use std::io::{Seek, Write};

use ::mcap::records::{MessageHeader, Metadata};
use ::mcap::{McapResult, WriteOptions, Writer};
use serde_json::{Map, Value, json};

use super::foxglove::{Color, Entity, SceneUpdate};
use super::page::{ArmPose, LinkShape, Replay, Scenery};
use super::trace::Trace;
use crate::geometry::{Rotation, Vec3};
use crate::standards::BodyRegion;
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::model::Subject;

const OBSTACLE: u32 = 0x8a_93_9b;
const ROBOT: u32 = 0xe0_7b_1f;
const TOUCHING: u32 = 0xd6_28_28;
const PERSON: u32 = 0x3b_7d_b8;
const CLEAR: u32 = 0x5b_a3_5b;
const DETECTED: u32 = 0xf2_c0_2e;

/// What a recording is made of.
pub struct Recording<'a> {
    /// The hazard.
    pub hazard: &'a Hazard,
    /// What was scanned.
    pub subject: &'a Subject,
    /// What stands still.
    pub scenery: &'a Scenery,
    /// What moves.
    pub replay: &'a Replay,
    /// What the FMU gets and answers.
    pub trace: Option<&'a Trace>,
}

/// Writes the recording.
///
/// # Errors
/// When `to` cannot be written.
pub fn write(recording: &Recording<'_>, to: impl Write + Seek) -> McapResult<()> {
    let library = concat!("fmi-hazard ", env!("CARGO_PKG_VERSION"));
    let options = WriteOptions::new().compression(None).library(library);
    let mut file = Topics { writer: Writer::with_options(to, options)?, sequence: 0 };
    let Recording { hazard, subject, replay, .. } = recording;
    let about = [
        ("id", hazard.id.clone()),
        ("what", hazard.sentence()),
        ("cell", subject.title()),
        ("cell_sha256", subject.cell_sha256.clone()),
        ("fmu_sha256", subject.fmus.iter().map(|fmu| fmu.sha256.as_str()).collect::<Vec<_>>().join(" ")),
    ];
    let metadata = about.into_iter().map(|(key, value)| (key.to_owned(), value)).collect();
    file.writer.write_metadata(&Metadata { name: "hazard".to_owned(), metadata })?;

    let scene_schema = schemars::generate::SchemaSettings::draft07()
        .with(|settings| settings.inline_subschemas = true)
        .into_generator()
        .into_root_schema_for::<SceneUpdate>()
        .to_value();
    let scene = file.topic("/scene", "foxglove.SceneUpdate", &scene_schema)?;
    let curves = ["time_s", "force_ratio", "distance_m", "speed_m_s"].map(|name| (name, "number"));
    let mut of_hazard = flat(curves.into_iter().chain([("action", "string")]));
    // Nothing is known where the cell has no such link any more, and there is no action yet at the end of time.
    for name in ["force_ratio", "speed_m_s", "action"] {
        let kind = of_hazard["properties"][name]["type"].take();
        of_hazard["properties"][name]["type"] = json!([kind, "null"]);
    }
    let curves = file.topic("/hazard", "Hazard", &of_hazard)?;
    let names = replay.sensors.iter().map(|strip| (strip.name.as_str(), "boolean"));
    let sensors = file.topic("/sensors", "Sensors", &flat(names))?;
    for frame in 0..replay.frames {
        let time_s = replay.time_s.0[frame];
        let time = nanoseconds(time_s);
        let entities = recording.entities(frame, time);
        let update = SceneUpdate { entities, ..SceneUpdate::default() };
        file.message(scene, time, &serde_json::to_value(update).unwrap_or_default())?;
        let action = replay.actions.iter().rev().find(|action| action.frame <= frame);
        let values = json!({
            "time_s": time_s,
            "force_ratio": replay.force_ratio.0[frame],
            "distance_m": replay.distance_m.0[frame],
            "speed_m_s": replay.speed_m_s.0[frame],
            "action": action.map(|action| action.name.as_str()),
        });
        file.message(curves, time, &values)?;
        let detected = |of: &str| of.as_bytes().get(frame) == Some(&b'1');
        let values: Map<String, Value> =
            replay.sensors.iter().map(|strip| (strip.name.clone(), detected(&strip.detected).into())).collect();
        file.message(sensors, time, &Value::Object(values))?;
    }
    if let Some(trace) = recording.trace {
        for (topic, names, rows, first) in
            [("/fmu/inputs", &trace.inputs, &trace.given, 0_u32), ("/fmu/outputs", &trace.outputs, &trace.answered, 1)]
        {
            let channel = file.topic(topic, topic, &flat(names.iter().map(|name| (name.as_str(), "number"))))?;
            for (step, row) in (first..).zip(rows) {
                let values = names.iter().cloned().zip(row.iter().map(|value| json!(value))).collect();
                file.message(channel, nanoseconds(f64::from(step) * trace.step_s), &Value::Object(values))?;
            }
        }
    }
    file.writer.finish()?;
    Ok(())
}

/// A file with topics.
struct Topics<W: Write + Seek> {
    writer: Writer<W>,
    sequence: u32,
}

impl<W: Write + Seek> Topics<W> {
    fn topic(&mut self, topic: &str, schema: &str, data: &Value) -> McapResult<u16> {
        let schema = self.writer.add_schema(schema, "jsonschema", data.to_string().as_bytes())?;
        self.writer.add_channel(schema, topic, "json", &BTreeMap::new())
    }

    fn message(&mut self, channel_id: u16, time: u64, data: &Value) -> McapResult<()> {
        self.sequence += 1;
        let header = MessageHeader { channel_id, sequence: self.sequence, log_time: time, publish_time: time };
        self.writer.write_to_known_channel(&header, data.to_string().as_bytes())
    }
}

impl Recording<'_> {
    /// What is drawn anew in a frame; in the first one also what never moves.
    fn entities(&self, frame: usize, time: u64) -> Vec<Entity> {
        let mut entities = Vec::new();
        if frame == 0 {
            let mut cell = Entity::new("cell".to_owned(), time);
            for obstacle in &self.scenery.obstacles {
                let [centre, size] = [obstacle.centre_m, obstacle.size_m].map(Vec3::from_array);
                let rotation = Rotation::from_array(obstacle.quaternion);
                cell.cuboid(centre, rotation, size, Color::hex(OBSTACLE).faint());
            }
            entities.push(cell);
        }
        for zone in &self.scenery.zones {
            let strip = self.replay.sensors.iter().find(|strip| strip.name == zone.name);
            let detected = strip.is_some_and(|strip| strip.detected.as_bytes().get(frame) == Some(&b'1'));
            let color = Color::hex(if detected { DETECTED } else { CLEAR });
            let mut entity = Entity::new(format!("zone {}", zone.name), time);
            for z in zone.z_m {
                entity.outline(zone.polygon_m.iter().map(|p| Vec3::new(p[0], p[1], z)), color);
            }
            entities.push(entity);
        }
        let point = |values: &[f64]| Vec3::new(values[0], values[1], values[2]);
        let places = self.replay.links.0.chunks_exact(7).skip(frame * self.scenery.links.len());
        for (number, (link, place)) in self.scenery.links.iter().zip(places).enumerate() {
            // Several shapes may share a name.
            let (LinkShape::Capsule { name, robot, .. }
            | LinkShape::Hull { name, robot, .. }
            | LinkShape::Mesh { name, robot, .. }) = link;
            let touches = frame >= self.replay.contact_frame && *name == self.hazard.robot_link;
            let color = Color::hex(if touches { TOUCHING } else { ROBOT });
            let mut entity = Entity::new(format!("{robot} {name} {number}"), time);
            let turned = || Rotation::from_xyzw(place[3], place[4], place[5], place[6]);
            match link {
                LinkShape::Capsule { radius_m, .. } => {
                    entity.capsule(point(&place[..3]), point(&place[3..6]), *radius_m, color);
                }
                LinkShape::Hull { points_m, .. } => {
                    let points: Vec<Vec3> = points_m.iter().copied().map(Vec3::from_array).collect();
                    entity.hull(&points, point(&place[..3]), turned(), color);
                }
                LinkShape::Mesh { points_m, triangles, .. } => {
                    let points: Vec<Vec3> = points_m.iter().copied().map(Vec3::from_array).collect();
                    entity.mesh(&points, triangles, point(&place[..3]), turned(), color);
                }
            }
            entities.push(entity);
        }
        let mut person = Entity::new("person".to_owned(), time);
        let ends = self.replay.body.0.chunks_exact(6).skip(frame * self.scenery.body.len());
        for (part, ends) in self.scenery.body.iter().zip(ends) {
            person.capsule(point(&ends[..3]), point(&ends[3..]), part.radius_m, Color::hex(PERSON));
        }
        let arm = &self.scenery.arm;
        for joints in self.replay.arms.0.chunks_exact(9).skip(2 * frame).take(2) {
            let [shoulder, elbow, wrist] = [0, 3, 6].map(|from| point(&joints[from..]));
            person.capsule(shoulder, elbow, arm.upper_arm_radius_m, Color::hex(PERSON));
            person.capsule(elbow, wrist, arm.forearm_radius_m, Color::hex(PERSON));
        }
        entities.push(person);
        if frame == self.replay.contact_frame {
            let mut contact = Entity::new("contact".to_owned(), time);
            if let Some(ArmPose { points_m: [.., wrist], .. }) = &self.replay.arm
                && self.hazard.body_region == BodyRegion::Hand
            {
                // Where the hand may be.
                contact.ball(Vec3::from_array(*wrist), arm.hand_radius_m, Color::hex(PERSON).faint());
            }
            contact.ball(Vec3::from_array(self.replay.contact_m), 0.04, Color::hex(TOUCHING));
            entities.push(contact);
        }
        entities
    }
}

/// The schema of an object of plain values.
fn flat<'a>(properties: impl Iterator<Item = (&'a str, &'a str)>) -> Value {
    let properties: Map<String, Value> =
        properties.map(|(name, kind)| (name.to_owned(), json!({ "type": kind }))).collect();
    json!({ "type": "object", "properties": properties })
}

/// From seconds, to the nanosecond.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few seconds after the start")]
fn nanoseconds(seconds: f64) -> u64 {
    (seconds * 1e9).round() as u64
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;
    use crate::page::{ArmShape, Floats, StartPlace};
    use fmi_hazard_record::fixtures;

    /// Of a film without frames, so that nothing else is in it.
    #[test]
    fn inputs_are_told_when_a_step_begins_and_outputs_when_it_ends() {
        let scenery = Scenery {
            name: "made up".to_owned(),
            step_s: 0.02,
            obstacles: Vec::new(),
            sensors: Vec::new(),
            zones: Vec::new(),
            links: Vec::new(),
            looks: Vec::new(),
            body: Vec::new(),
            arm: ArmShape { upper_arm_radius_m: 0.05, forearm_radius_m: 0.04, hand_radius_m: 0.1, held_m: 0.0 },
            robots: Vec::new(),
            start: StartPlace { xy_m: [0.0, 0.0], heading_deg: 0.0 },
        };
        let replay = Replay {
            id: "H-000001".to_owned(),
            frames: 0,
            contact_frame: 0,
            links: Floats::default(),
            body: Floats::default(),
            moved: Vec::new(),
            beside: Floats::default(),
            beside_arms: Floats::default(),
            arms: Floats::default(),
            arm: None,
            contact_m: [0.0, 0.0, 1.0],
            time_s: Floats::default(),
            distance_m: Floats::default(),
            speed_m_s: Floats::default(),
            force_ratio: Floats::default(),
            sensors: Vec::new(),
            actions: Vec::new(),
            top_view: String::new(),
        };
        let trace = Trace {
            step_s: 0.02,
            inputs: vec!["given".to_owned()],
            outputs: vec!["answered".to_owned()],
            given: vec![vec![1.5], vec![2.5]],
            answered: vec![vec![10.5], vec![20.5]],
            before: Vec::new(),
        };
        let (hazard, subject) = (fixtures::hazard("H-000001", 1.5), fixtures::subject());
        let recording =
            Recording { hazard: &hazard, subject: &subject, scenery: &scenery, replay: &replay, trace: Some(&trace) };
        let mut file = Cursor::new(Vec::<u8>::new());
        write(&recording, &mut file).unwrap();
        let bytes = file.into_inner();
        let messages = ::mcap::MessageStream::new(&bytes).unwrap().map(|message| {
            let message = message.unwrap();
            let value: Value = serde_json::from_slice(&message.data).unwrap();
            (message.channel.topic.clone(), message.log_time, value)
        });
        let told: Vec<(String, u64, Value)> = messages.collect();
        // Steps of 20 ms, in nanoseconds.
        let expected = [
            ("/fmu/inputs", 0_u64, json!({ "given": 1.5 })),
            ("/fmu/inputs", 20_000_000, json!({ "given": 2.5 })),
            ("/fmu/outputs", 20_000_000, json!({ "answered": 10.5 })),
            ("/fmu/outputs", 40_000_000, json!({ "answered": 20.5 })),
        ];
        assert_eq!(told, expected.map(|(topic, time, value)| (topic.to_owned(), time, value)));
    }
}
