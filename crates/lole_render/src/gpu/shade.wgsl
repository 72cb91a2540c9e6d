// The shading formula for graphics adapters; its twins are `shade.rs` and `surroundings.rs`: line by line
// alike. How much of the key light is seen stands apart: `key.wgsl` as stills see it, `live.wgsl` for windows.

struct Frame {
    clip_from_world: mat4x4<f32>,
    eye: vec4<f32>,
    ray_corner: vec4<f32>,
    ray_right: vec4<f32>,
    ray_down: vec4<f32>,
    key_toward: vec4<f32>,
    key_color: vec4<f32>,
    key_texel_u: vec4<f32>,
    key_texel_v: vec4<f32>,
    background_top: vec4<f32>,
    background_bottom: vec4<f32>,
    turned: vec4<f32>,
    panorama: vec4<f32>,
    floor_near: vec4<f32>,
    floor_beyond: vec4<f32>,
    shore: vec4<f32>,
    foam: vec4<f32>,
    haze: vec4<f32>,
    ground: vec4<f32>,
}

struct Surface {
    base_color: vec4<f32>,
    back: vec4<f32>,
    subsurface: vec4<f32>,
    gloss: vec4<f32>,
}

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(2) var ground_light: texture_2d<f32>;
@group(0) @binding(7) var far_paint: texture_2d<f32>;
@group(0) @binding(8) var near_paint: texture_2d<f32>;
@group(0) @binding(9) var beyond_paint: texture_2d<f32>;
@group(0) @binding(10) var paint_sampler: sampler;
@group(0) @binding(11) var mirrored_paint: texture_2d<f32>;
@group(0) @binding(12) var reflection: texture_2d<f32>;
@group(1) @binding(0) var<uniform> surface: Surface;
@group(1) @binding(1) var print: texture_2d<f32>;
@group(1) @binding(2) var print_sampler: sampler;

const LIFT_TEXELS: f32 = 2.0;
const WRAP_DEPTH: f32 = 0.06;
const STEEPEST: f32 = 0.1;
const POLISH: f32 = 0.65;
const WRAP_END: f32 = 0.4;
const TOE: f32 = 0.01;
const PI: f32 = 3.14159265;
const TAU: f32 = 6.28318531;

struct MeshVertex {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) uv: vec2<f32>,
    @location(3) color: vec3<f32>,
    @location(4) face_light: vec3<f32>,
    @location(5) back_light: vec3<f32>,
}

struct MeshFragment {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) position: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) normal: vec3<f32>,
    @location(2) @interpolate(perspective, centroid) uv: vec2<f32>,
    @location(3) @interpolate(perspective, centroid) color: vec3<f32>,
    @location(4) @interpolate(perspective, centroid) face_light: vec3<f32>,
    @location(5) @interpolate(perspective, centroid) back_light: vec3<f32>,
}

@vertex
fn mesh_vertex(vertex: MeshVertex) -> MeshFragment {
    var out: MeshFragment;
    out.clip = frame.clip_from_world * vec4<f32>(vertex.position, 1.0);
    out.position = vertex.position;
    out.normal = vertex.normal;
    out.uv = vertex.uv;
    out.color = vertex.color;
    out.face_light = vertex.face_light;
    out.back_light = vertex.back_light;
    return out;
}

@fragment
fn mesh_fragment(in: MeshFragment, @builtin(front_facing) is_face: bool) -> @location(0) vec4<f32> {
    let texels = vec2<f32>(textureDimensions(print));
    let lod = texture_lod(dpdx(in.uv) * texels, dpdy(in.uv) * texels);
    var paint = in.color;
    if surface.gloss.w > 0.5 {
        paint *= textureSampleLevel(print, print_sampler, in.uv, lod).rgb;
    }
    let face = surface.base_color.rgb * paint;
    var facing = -1.0;
    var ambient = in.back_light;
    var ambient_behind = in.face_light;
    var albedo = mix(face, surface.back.rgb, surface.back.w);
    if is_face {
        facing = 1.0;
        ambient = in.face_light;
        ambient_behind = in.back_light;
        albedo = face;
    }
    let toward_eye = normalize_or(frame.eye.xyz - in.position, vec3<f32>(0.0));
    let normal = normalize_or(in.normal, toward_eye * facing) * facing;
    let light = vec4<f32>(0.0);
    let color = shade(in.position, normal, toward_eye, albedo, max(ambient, light.rgb),
        max(ambient_behind, light.rgb));
    return vec4<f32>(written(color), 1.0);
}

fn normalize_or(vector: vec3<f32>, otherwise: vec3<f32>) -> vec3<f32> {
    let squared = dot(vector, vector);
    if squared > 1.0e-20 {
        return vector * inverseSqrt(squared);
    }
    return otherwise;
}

fn shade(
    position: vec3<f32>,
    point_normal: vec3<f32>,
    toward_eye: vec3<f32>,
    albedo: vec3<f32>,
    ambient: vec3<f32>,
    ambient_behind: vec3<f32>,
) -> vec3<f32> {
    let toward_key = frame.key_toward.xyz;
    let normal = face_eye(point_normal, toward_eye);
    let key_cosine = dot(normal, toward_key);
    var lit_side = normal;
    if key_cosine < 0.0 && surface.gloss.z > 0.0 {
        lit_side = -normal;
    }
    let wrap = surface.subsurface.w;
    let at_terminator = max(1.0 - abs(key_cosine) / WRAP_END, 0.0);
    let crossed = wrap * WRAP_DEPTH * at_terminator;
    let lift = lit_side * (LIFT_TEXELS * frame.key_color.w) + toward_key * crossed;
    var seen = 0.0;
    if key_cosine > -(wrap + 0.5 * frame.key_toward.w) || surface.gloss.z > 0.0 {
        seen = key_seen(position + lift, key_slope(lit_side));
    }
    let key = frame.key_color.rgb * seen;

    let soft = wrap + 0.5 * frame.key_toward.w;
    let lambert = max(key_cosine, 0.0);
    var wrapped = max((key_cosine + soft) / (1.0 + soft), 0.0);
    wrapped = wrapped * sqrt(wrapped);
    let tint = mix(vec3<f32>(1.0), surface.subsurface.rgb, 0.85);
    let carried = max(wrapped - lambert, 0.0);
    let direct = key * (tint * carried + min(lambert, wrapped));
    let through = surface.gloss.z * (key * max(-key_cosine, 0.0) + ambient_behind);
    let diffuse = albedo * (direct + ambient) + albedo * sqrt(albedo) * through;

    let grazing = 1.0 - clamp(dot(normal, toward_eye), 0.0, 1.0);
    let grazing_2 = grazing * grazing;
    let grazing_5 = grazing_2 * grazing_2 * grazing;
    let sheen_tint = mix(vec3<f32>(0.25), albedo, 0.75);
    let sheen = sheen_tint * (ambient + direct) * (surface.gloss.y * grazing_2 * grazing);

    let roughness = surface.base_color.w;
    let mirror = surface.gloss.x;
    let smooth_share = 1.0 - roughness;
    let mirrors = min(mirror * 50.0, 1.0);
    let room_mirror = mirror + (1.0 - mirror) * smooth_share * smooth_share * grazing_5 * mirrors;
    let highlight = key
        * ggx(normal, toward_eye, toward_key, roughness + 0.5 * frame.key_toward.w)
        * mirror
        * lambert;
    return tone_map((diffuse + sheen + highlight + ambient * room_mirror) * frame.eye.w);
}

fn key_slope(normal: vec3<f32>) -> vec2<f32> {
    let cosine = dot(normal, frame.key_toward.xyz);
    let per_cosine = clamp(cosine, 0.0, STEEPEST) / (STEEPEST * max(cosine, STEEPEST));
    let along = vec2<f32>(dot(normal, frame.key_texel_u.xyz), dot(normal, frame.key_texel_v.xyz));
    return along * (-frame.key_color.w * frame.key_color.w * per_cosine);
}

fn face_eye(normal: vec3<f32>, toward_eye: vec3<f32>) -> vec3<f32> {
    let cosine = dot(normal, toward_eye);
    if cosine >= 0.0 {
        return normal;
    }
    return normalize_or(normal - toward_eye * cosine, toward_eye);
}

fn ggx(normal: vec3<f32>, toward_eye: vec3<f32>, toward_light: vec3<f32>, roughness: f32) -> f32 {
    let halfway = normalize_or(toward_eye + toward_light, normal);
    let half_cosine = max(dot(normal, halfway), 0.0);
    let eye_cosine = max(dot(normal, toward_eye), 1.0e-3);
    let light_cosine = max(dot(normal, toward_light), 1.0e-3);
    let alpha = max(roughness * roughness, 0.01);
    let alpha_2 = alpha * alpha;
    let spread = half_cosine * half_cosine * (alpha_2 - 1.0) + 1.0;
    let distribution = alpha_2 / (PI * spread * spread);
    let k = alpha * 0.5;
    let eye_part = eye_cosine * (1.0 - k) + k;
    let light_part = light_cosine * (1.0 - k) + k;
    return min(distribution * PI / (4.0 * eye_part * light_part), 12.0);
}

fn pixel_noise(pixel: vec2<f32>) -> f32 {
    let at = floor(pixel);
    return fract(52.982918 * fract(0.06711056 * at.x + 0.00583715 * at.y));
}

fn tone_map(light: vec3<f32>) -> vec3<f32> {
    let start = 0.8 - 0.04;
    let least = min(light.r, min(light.g, light.b));
    var offset = TOE;
    if least < 2.0 * TOE {
        offset = least - least * least / (4.0 * TOE);
    }
    let color = light - offset;
    let peak = max(color.r, max(color.g, color.b));
    if peak < start {
        return color;
    }
    let room = 1.0 - start;
    let new_peak = 1.0 - room * room / (peak + room - start);
    let scaled = color * (new_peak / peak);
    let kept = 1.0 / (0.15 * (peak - new_peak) + 1.0);
    return mix(vec3<f32>(new_peak), scaled, kept);
}

fn texture_lod(change_x: vec2<f32>, change_y: vec2<f32>) -> f32 {
    let a = dot(change_x, change_x);
    let b = dot(change_y, change_y);
    let wide = max(a, b);
    let narrow = min(a, b);
    let squared = max(max(sqrt(wide * narrow), wide * 0.0625), 1.0e-12);
    return 0.5 * log2(squared);
}

struct BackgroundFragment {
    @builtin(position) clip: vec4<f32>,
}

// One triangle that covers the picture.
@vertex
fn background_vertex(@builtin(vertex_index) index: u32) -> BackgroundFragment {
    var out: BackgroundFragment;
    let x = f32(i32(index & 1u) * 4 - 1);
    let y = f32(i32(index >> 1u) * 4 - 1);
    out.clip = vec4<f32>(x, y, 0.0, 1.0);
    return out;
}

@fragment
fn background_fragment(in: BackgroundFragment) -> @location(0) vec4<f32> {
    let pixel = in.clip.xy;
    let ray = frame.ray_corner.xyz + frame.ray_right.xyz * pixel.x + frame.ray_down.xyz * pixel.y;
    let drop = frame.ground.x - frame.eye.y;
    var ground = vec3<f32>(1.0);
    if frame.background_bottom.w > 0.5 && ray.y < -1.0e-5 && drop < 0.0 {
        let hit = frame.eye.xyz + ray * (drop / ray.y);
        ground = ground_factor(hit.xz);
    }
    let noise = pixel_noise(pixel);
    let place = pixel / vec2<f32>(frame.ray_right.w, frame.ray_down.w);
    let down = place.y * place.y * (3.0 - 2.0 * place.y);
    var base = mix(frame.background_top.rgb, frame.background_bottom.rgb, down);
    if frame.turned.w > 0.5 {
        base = landscape(normalize_or(ray, vec3<f32>(0.0, 0.0, -1.0)), place, noise);
    }
    let from_middle = (place - vec2<f32>(0.5, 0.52)) * vec2<f32>(1.5, 1.25);
    let corner = min(dot(from_middle, from_middle), 1.0);
    let glow = 1.0 + frame.background_top.w * (0.45 - corner * (2.0 - corner));
    let color = base * glow * ground;
    let grain = (noise - 0.5) * (2.2 / 255.0);
    let light = max(color + sqrt(max(color, vec3<f32>(0.0))) * grain, vec3<f32>(0.0));
    return vec4<f32>(written(light), 1.0);
}

fn landscape(ray: vec3<f32>, place: vec2<f32>, noise: f32) -> vec3<f32> {
    let drop = frame.ground.x - frame.eye.y;
    let seen = turned(ray);
    if ray.y > -1.0e-5 || drop >= 0.0 {
        return textureSampleLevel(far_paint, paint_sampler, far_uv(seen), frame.panorama.z).rgb;
    }
    var standing = vec4<f32>(0.0);
    if ray.y > frame.panorama.y {
        standing = textureSampleLevel(far_paint, paint_sampler, far_uv(seen), frame.panorama.z);
    }
    let below = floor_color(seen, place, drop / ray.y, noise);
    return mix(below, standing.rgb, standing.a);
}

fn turned(world: vec3<f32>) -> vec3<f32> {
    let cosine = frame.turned.x;
    let sine = frame.turned.y;
    return vec3<f32>(
        world.x * cosine - world.z * sine,
        world.y,
        world.x * sine + world.z * cosine,
    );
}

fn far_uv(seen: vec3<f32>) -> vec2<f32> {
    let around = atan2(seen.x, -seen.z) / TAU + 0.5;
    let margin = 0.5 / f32(textureDimensions(far_paint).y);
    let down = (frame.panorama.x - seen.y) / (frame.panorama.x - frame.panorama.y);
    return vec2<f32>(around, clamp(down, margin, 1.0 - margin));
}

fn wave(turns: f32) -> f32 {
    let part = turns - floor(turns + 0.5);
    return part * (8.0 - 16.0 * abs(part));
}

fn floor_color(seen: vec3<f32>, place: vec2<f32>, way: f32, noise: f32) -> vec3<f32> {
    let hit = turned(frame.eye.xyz) + seen * way;
    let at = hit.xz;
    let from_middle = length(at);
    let across = way * frame.turned.z;
    let along = across / max(-seen.y, 1.0e-3);
    let toward = frame.shore.xy;
    var out = dot(at, toward) - frame.shore.z;
    let foam = frame.foam.w;
    if foam > 0.0 {
        let side = at.x * toward.y - at.y * toward.x;
        out += foam
            * (0.55 * wave(side * 0.06 + 0.1)
                + 0.30 * wave(side * 0.18)
                + 0.12 * wave(side * 0.5 + 0.3));
    }
    let edge = max(0.6 * along, 0.02);
    let beyond = smooth_between(-edge, edge, out);
    var wet = 0.0;
    if foam > 0.0 {
        wet = smooth_between(-5.0 * foam, -0.6 * foam, out);
    }
    var base = vec3<f32>(0.0);
    var mirrors = 0.0;
    var waves = 0.0;
    if beyond < 1.0 {
        let repeats = frame.floor_near.x;
        let texels = repeats * f32(textureDimensions(near_paint).x);
        let lod = painted_lod(vec2<f32>(across, along), texels, noise);
        let paint = textureSampleLevel(near_paint, paint_sampler, at * repeats, lod).rgb;
        let dim = min(from_middle / frame.panorama.w, 100.0);
        let slow = wave(at.x * 0.13 + 0.27 * wave(at.y * 0.1));
        let tone = 1.0 + 0.05 * slow * wave(at.y * 0.11 + 0.2);
        let lit = tone / (1.0 + dim * dim * dim * dim);
        base = paint * (lit * (1.0 - 0.45 * wet));
        mirrors = frame.floor_near.y + 0.55 * wet;
        waves = frame.floor_near.z * paint.y;
    }
    if beyond > 0.0 {
        let repeats = frame.floor_beyond.x;
        let texels = repeats * f32(textureDimensions(beyond_paint).x);
        let lod = painted_lod(vec2<f32>(across, along), texels, noise);
        let paint = textureSampleLevel(beyond_paint, paint_sampler, at * repeats, lod).rgb;
        base = mix(base, paint, beyond);
        mirrors += (frame.floor_beyond.y - mirrors) * beyond;
        waves += (frame.floor_beyond.z * paint.y - waves) * beyond;
    }
    let grazing = 1.0 + seen.y;
    let share = mirrors * grazing * grazing * grazing;
    if share > 0.002 {
        let upward = far_uv(vec3<f32>(seen.x, waves - seen.y, seen.z));
        let mirrored = textureSampleLevel(mirrored_paint, paint_sampler, upward, 0.0).rgb;
        base = mix(base, mirrored, min(share, 1.0));
    }
    if mirrors > 0.0 {
        let polish = mirrors * (POLISH + (1.0 - POLISH) * grazing * grazing * grazing);
        let reflected = reflected_at(place);
        base = base * (1.0 - polish * reflected.a) + reflected.rgb * polish;
    }
    if foam > 0.0 {
        let swash = smooth_between(-0.5 * foam, -0.1 * foam, out);
        let spent = smooth_between(0.1 * foam, 1.6 * foam, out);
        base = mix(base, frame.foam.rgb, swash * (1.0 - spent));
    }
    let far = way / (way + frame.floor_near.w);
    return mix(base, frame.haze.rgb, far * far);
}

fn painted_lod(sides: vec2<f32>, texels: f32, noise: f32) -> f32 {
    let lod = texture_lod(vec2<f32>(sides.x * texels, 0.0), vec2<f32>(0.0, sides.y * texels));
    return max(floor(lod + noise), 0.0);
}

fn smooth_between(low: f32, high: f32, value: f32) -> f32 {
    let share = clamp((value - low) / (high - low), 0.0, 1.0);
    return share * share * (3.0 - 2.0 * share);
}

fn reflected_at(place: vec2<f32>) -> vec4<f32> {
    let size = vec2<f32>(textureDimensions(reflection));
    let at = clamp(place * size - 0.5, vec2<f32>(0.0), size - 1.0);
    let first = vec2<i32>(at);
    let next = min(first + 1, vec2<i32>(size) - 1);
    let part = at - floor(at);
    let top = mix(textureLoad(reflection, first, 0),
        textureLoad(reflection, vec2<i32>(next.x, first.y), 0), part.x);
    let bottom = mix(textureLoad(reflection, vec2<i32>(first.x, next.y), 0),
        textureLoad(reflection, next, 0), part.x);
    return mix(top, bottom, part.y);
}

fn ground_factor(point: vec2<f32>) -> vec3<f32> {
    let size = vec2<i32>(textureDimensions(ground_light));
    let at = (point - frame.ground.yz) * frame.ground.w - 0.5;
    let base = floor(at);
    if any(base < vec2<f32>(0.0)) || any(base > vec2<f32>(size - 2)) {
        return vec3<f32>(1.0);
    }
    let part = at - base;
    let first = vec2<i32>(base);
    let top = mix(textureLoad(ground_light, first, 0).rgb,
        textureLoad(ground_light, first + vec2<i32>(1, 0), 0).rgb, part.x);
    let bottom = mix(textureLoad(ground_light, first + vec2<i32>(0, 1), 0).rgb,
        textureLoad(ground_light, first + vec2<i32>(1, 1), 0).rgb, part.x);
    return mix(top, bottom, part.y);
}
