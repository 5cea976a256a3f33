// The picture as a window shows it: sRGB, as a PNG file has it.
// needs: nothing
// offers: window_color

uniform sampler2D picture;  // linear RGB, bottom row first
uniform vec2 corner;        // its place in the window, pixels
uniform vec2 size;          // and its size there, pixels

layout(location = 0) out vec4 window_color;

float srgb(float linear)
{
    return linear <= 0.0031308 ? 12.92 * linear
                               : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

void main()
{
    vec3 color = texture(picture, (gl_FragCoord.xy - corner) / size).rgb;
    color = clamp(color, 0.0, 1.0);
    window_color = vec4(srgb(color.r), srgb(color.g), srgb(color.b), 1.0);
}
