// The key light's soft shadows as stills see them; the twin is `shade.rs`: line by line alike.

@group(0) @binding(1) var key_map: texture_2d<f32>;

const RINGS: f32 = 4.0;
const SHADOW_RINGS: f32 = 3.6;
const NEAR_SEARCH: i32 = 2;
const FINEST_SEARCH: i32 = 2;
const COARSER_LEVELS: i32 = 5;
const LEAST_RADIUS: f32 = 2.0;
const RISE: f32 = 0.8;
const BELL: f32 = 1.22;
const SOFTEST_DISTANCE: f32 = 0.45;
const SLACK: f32 = 0.0015;
const EMPTY: f32 = 1.0e30;

fn key_nearest(texel: vec2<i32>, level: i32) -> f32 {
    let size = vec2<i32>(textureDimensions(key_map, level));
    if any(texel < vec2<i32>(0)) || any(texel >= size) {
        return -EMPTY;
    }
    return textureLoad(key_map, texel, level).r;
}

fn key_seen(position: vec3<f32>, slope: vec2<f32>) -> f32 {
    let at = vec3<f32>(
        dot(frame.key_texel_u, vec4<f32>(position, 1.0)),
        dot(frame.key_texel_v, vec4<f32>(position, 1.0)),
        dot(frame.key_toward.xyz, position) + SLACK,
    );
    let per_depth = frame.key_toward.w / frame.key_color.w;
    let search = SOFTEST_DISTANCE * per_depth * BELL;
    var level = FINEST_SEARCH;
    while level < COARSER_LEVELS && search > RINGS * f32(1 << u32(level)) {
        level++;
    }
    let far = key_blockers(at, slope, level);
    let close = key_blockers(at, slope, max(level - NEAR_SEARCH, FINEST_SEARCH));
    let mean = (far.y + close.y) / (far.x + close.x + 1.0e-4);
    let distance = max(min(mean, SOFTEST_DISTANCE), LEAST_RADIUS / per_depth);
    return key_share(at, slope, distance);
}

fn key_blockers(at: vec3<f32>, texel_slope: vec2<f32>, level: i32) -> vec2<f32> {
    let per_depth = BELL * frame.key_toward.w / frame.key_color.w;
    let step = f32(1 << u32(level));
    let at_step = at.xy / step;
    let first = vec2<i32>(ceil(at_step - 0.5 - RINGS));
    let slope = texel_slope * step;
    let corner = 0.5 * (abs(slope.x) + abs(slope.y));
    var found = vec2<f32>(0.0);
    for (var row = 0; row < 8; row++) {
        for (var column = 0; column < 8; column++) {
            let node = first + vec2<i32>(column, row);
            let offset = vec2<f32>(node) + 0.5 - at_step;
            let plane = dot(offset, slope) + corner;
            let before = key_nearest(node, level) - at.z - max(plane, 0.0);
            if before <= 0.0 {
                continue;
            }
            let reach = before * per_depth / step;
            let held = clamp(reach - 0.5, 0.0, 1.0);
            let wide = min(reach + 0.7, RINGS);
            let bell = max(1.0 - dot(offset, offset) / (wide * wide), 0.0);
            let weight = bell * held / (wide * wide);
            found += vec2<f32>(weight, weight * before);
        }
    }
    return found;
}

fn key_shift(index: i32, stride: i32) -> i32 {
    let place = index & 3;
    let quarter = (place >> 1u) + (place & 1) * 2;
    return quarter * stride / 4 - 3 * stride / 8;
}

fn key_share(at: vec3<f32>, slope: vec2<f32>, distance: f32) -> f32 {
    let radius = BELL * distance * frame.key_toward.w / frame.key_color.w;
    let rise = distance * RISE;
    var stride = 1;
    while radius > SHADOW_RINGS * f32(stride) {
        stride *= 2;
    }
    let first = vec2<i32>(ceil((at.xy - 0.5) / f32(stride) - RINGS));
    var hidden = 0.0;
    var whole = 0.0;
    for (var row = 0; row < 8; row++) {
        for (var column = 0; column < 8; column++) {
            let index = first + vec2<i32>(column, row);
            let node = index * stride
                + vec2<i32>(key_shift(index.y, stride), key_shift(index.x, stride));
            let offset = vec2<f32>(node) + 0.5 - at.xy;
            let bell = 1.0 - dot(offset, offset) / (radius * radius);
            let weight = max(bell, 0.0);
            whole += weight;
            let plane = max(dot(offset, slope), 0.0);
            if key_nearest(node, 0) > (1.0 - bell) * rise + plane + at.z {
                hidden += weight;
            }
        }
    }
    return 1.0 - hidden / whole;
}

// What a picture is given: light, which its format encodes.
fn written(light: vec3<f32>) -> vec3<f32> {
    return light;
}
