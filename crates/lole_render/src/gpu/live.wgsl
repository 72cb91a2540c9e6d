// What a window adds to `shade.wgsl`: the key light's shadow by a map that the adapter draws itself,
// the light on the floor, and lines over the picture.

@group(0) @binding(1) var key_map: texture_depth_2d;
@group(0) @binding(3) var key_sampler: sampler_comparison;
@group(0) @binding(4) var under_map: texture_2d<f32>;
@group(0) @binding(5) var<uniform> floor_light: FloorLight;
// `key_map` once more: WebGL compares with a map of depths or reads it, but not both through one name.
@group(0) @binding(6) var key_depths: texture_2d<f32>;

// Light on the open floor: of the room, and of the key light. `room.w` is how dark shadows are,
// `key.w` the side of the key light's map [texel].
struct FloorLight {
    room: vec4<f32>,
    key: vec4<f32>,
}

// Depths along the key light that its map can hold [m].
const KEY_RANGE: f32 = 16.0;
// What is this close in front does not count as in the way [m].
const SLACK: f32 = 0.0015;
// Height above the floor that the map from below can hold [m].
const UNDER_RANGE: f32 = 2.5;
// Half the width of a shadow's edge on the figure [texel].
const EDGE: f32 = 2.2;
// Higher than this, what hangs above the floor keeps no light of the room away [m].
const ROOF: f32 = 0.55;
// Cells of the floor's light on each side, and texels of the map from below.
const FLOOR_CELLS: f32 = 256.0;
// Taps of the floor's shadow.
const FLOOR_TAPS: i32 = 14;

// Lines that lie on a surface are moved toward the eye by this share of their distance.
override TOWARD_EYE: f32 = 0.0;

// 1 where the picture's format does not encode light as sRGB, so that it is done here.
override ENCODES: f32 = 0.0;

// What a picture is given: light, or light encoded by IEC 61966-2-1.
fn written(light: vec3<f32>) -> vec3<f32> {
    if ENCODES < 0.5 {
        return light;
    }
    let whole = clamp(light, vec3<f32>(0.0), vec3<f32>(1.0));
    let bright = 1.055 * pow(whole, vec3<f32>(1.0 / 2.4)) - 0.055;
    return select(bright, 12.92 * whole, whole <= vec3<f32>(0.0031308));
}

fn key_place(position: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(
        dot(frame.key_texel_u, vec4<f32>(position, 1.0)),
        dot(frame.key_texel_v, vec4<f32>(position, 1.0)),
        0.5 + dot(frame.key_toward.xyz, position) / KEY_RANGE,
    );
}

fn key_seen(position: vec3<f32>, slope: vec2<f32>) -> f32 {
    let size = vec2<f32>(textureDimensions(key_map));
    let place = key_place(position);
    let at = place.xy / size;
    let depth = place.z + SLACK / KEY_RANGE;
    let step = EDGE / size;
    // The taps lie on a lattice like queens that do not threaten each other. Their number comes from
    // outside, so that a loop is left: Mesa's driver for the processor (22.3) was measured to lose
    // 9 MB for each picture whose shader runs straight through.
    let taps = i32(frame.ray_corner.w);
    let spread = 2.0 / f32(taps);
    var seen = 0.0;
    for (var tap = 0; tap < taps; tap++) {
        let place = vec2<f32>(vec2<i32>((tap * 2) % taps, tap)) + 0.5;
        let offset = place * spread - 1.0;
        let plane = max(dot(offset * EDGE, slope), 0.0) / KEY_RANGE;
        seen += textureSampleCompareLevel(key_map, key_sampler, at + offset * step, depth + plane);
    }
    return seen / f32(taps);
}

@vertex
fn caster_vertex(@location(0) position: vec3<f32>) -> @builtin(position) vec4<f32> {
    let place = key_place(position);
    let side = floor_light.key.w;
    return vec4<f32>(place.x / side * 2.0 - 1.0, 1.0 - place.y / side * 2.0, place.z, 1.0);
}

@vertex
fn under_vertex(@location(0) position: vec3<f32>) -> @builtin(position) vec4<f32> {
    let side = FLOOR_CELLS;
    let place = (position.xz - frame.ground.yz) * frame.ground.w / side;
    let height = (position.y - frame.ground.x) / UNDER_RANGE;
    return vec4<f32>(place.x * 2.0 - 1.0, 1.0 - place.y * 2.0, clamp(1.0 - height, 0.0, 1.0), 1.0);
}

// Points of a disk, evenly spread; `turn` differs from cell to cell.
fn disk(tap: i32, turn: f32) -> vec2<f32> {
    let angle = f32(tap) * 2.3999632 + turn;
    let radius = sqrt((f32(tap) + 0.5) / f32(FLOOR_TAPS));
    return vec2<f32>(cos(angle), sin(angle)) * radius;
}

@fragment
fn floor_fragment(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let cell = 1.0 / frame.ground.w;
    let point = vec3<f32>(
        frame.ground.y + pixel.x * cell,
        frame.ground.x,
        frame.ground.z + pixel.y * cell,
    );
    let size = vec2<f32>(textureDimensions(key_map));
    let place = key_place(point);
    let turn = pixel_noise(pixel.xy) * 6.2831853;
    // How far away what throws the shadow is, on average: the shadow's edge widens with it.
    var found = vec2<f32>(0.0);
    for (var tap = 0; tap < FLOOR_TAPS; tap++) {
        let at = place.xy + disk(tap, turn) * (0.06 / frame.key_color.w);
        let texel = vec2<i32>(clamp(at, vec2<f32>(0.0), size - 1.0));
        let before = (textureLoad(key_depths, texel, 0).x - place.z) * KEY_RANGE;
        if before > 0.0 {
            found += vec2<f32>(1.0, before);
        }
    }
    let distance = min(found.y / max(found.x, 1.0), 0.9);
    let radius = max(distance * frame.key_toward.w / frame.key_color.w, 2.0);
    var seen = 0.0;
    var open = 0.0;
    for (var tap = 0; tap < FLOOR_TAPS; tap++) {
        let offset = disk(tap, turn);
        let at = (place.xy + offset * radius) / size;
        seen += textureSampleCompareLevel(key_map, key_sampler, at, place.z + SLACK / KEY_RANGE);
        let spot = pixel.xy + offset * (0.34 * frame.ground.w);
        let last = vec2<f32>(textureDimensions(under_map)) - 1.0;
        let texel = vec2<i32>(clamp(spot, vec2<f32>(0.0), last));
        let height = (1.0 - textureLoad(under_map, texel, 0).x) * UNDER_RANGE;
        let share = clamp(height / ROOF, 0.0, 1.0);
        open += share * share * (3.0 - 2.0 * share);
    }
    let taps = f32(FLOOR_TAPS);
    let key = floor_light.key.rgb;
    let room = floor_light.room.rgb;
    let light = key * (seen / taps) + room * (open / taps);
    let factor = min(light / max(key + room, vec3<f32>(1.0e-6)), vec3<f32>(1.0));
    let side = FLOOR_CELLS;
    let rim = min(min(pixel.x, pixel.y), min(side - pixel.x, side - pixel.y)) / (side * 0.12);
    let fade = floor_light.room.w * smoothstep(0.0, 1.0, rim);
    return vec4<f32>(mix(vec3<f32>(1.0), factor, fade), 1.0);
}

struct LineFragment {
    @builtin(position) clip: vec4<f32>,
    @location(0) color: vec4<f32>,
    // Place along and across the line, its length and half its width [pixel].
    @location(1) place: vec4<f32>,
}

@vertex
fn line_vertex(
    @builtin(vertex_index) corner: u32,
    @location(0) line_from: vec3<f32>,
    @location(1) line_to: vec3<f32>,
    @location(2) color: vec4<f32>,
    @location(3) width: f32,
) -> LineFragment {
    var out: LineFragment;
    let picture = vec2<f32>(frame.ray_right.w, frame.ray_down.w);
    var a = frame.clip_from_world * vec4<f32>(line_from, 1.0);
    var b = frame.clip_from_world * vec4<f32>(line_to, 1.0);
    // The part behind the eye is cut off.
    let near = 0.03;
    if a.w < near && b.w < near {
        out.clip = vec4<f32>(2.0, 2.0, 2.0, 1.0);
        return out;
    }
    if a.w < near {
        a = mix(a, b, (near - a.w) / (b.w - a.w));
    }
    if b.w < near {
        b = mix(b, a, (near - b.w) / (a.w - b.w));
    }
    let from_pixel = a.xy / a.w * 0.5 * picture;
    let to_pixel = b.xy / b.w * 0.5 * picture;
    let way = to_pixel - from_pixel;
    let length_in_pixels = length(way);
    var along = vec2<f32>(1.0, 0.0);
    if length_in_pixels > 1.0e-4 {
        along = way / length_in_pixels;
    }
    let across = vec2<f32>(-along.y, along.x);
    let reach = 0.5 * width + 1.0;
    // Corners 0 1 2, 2 1 3 of a rectangle around the line.
    let is_end = corner == 1u || corner == 3u || corner == 4u;
    let is_upper = corner == 2u || corner == 3u || corner == 5u;
    let side = select(-1.0, 1.0, is_upper);
    let end = select(-1.0, 1.0, is_end);
    let base = select(a, b, is_end);
    let offset = (along * end + across * side) * reach / (0.5 * picture);
    // Divided here, so that everything is interpolated evenly over the screen: WebGL has no other way to say so.
    out.clip = vec4<f32>(base.xy / base.w + offset, base.z / base.w * (1.0 + TOWARD_EYE), 1.0);
    out.color = vec4<f32>(pow(color.rgb, vec3<f32>(2.2)), color.a);
    out.place = vec4<f32>(
        select(-reach, length_in_pixels + reach, is_end),
        side * reach,
        length_in_pixels,
        0.5 * width,
    );
    return out;
}

@fragment
fn line_fragment(in: LineFragment) -> @location(0) vec4<f32> {
    let beyond = max(max(-in.place.x, in.place.x - in.place.z), 0.0);
    let distance = length(vec2<f32>(beyond, in.place.y));
    let cover = clamp(in.place.w + 0.5 - distance, 0.0, 1.0);
    return vec4<f32>(written(in.color.rgb), in.color.a * cover);
}
