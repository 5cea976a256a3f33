// The scale of a --show picture: a bar of scale_color() from low to high, and a
// line of text below it.
// needs: scale_color
// offers: color

uniform ivec2 corner;    // lower left, pixels
uniform int width;       // of the whole legend, pixels
uniform int glyphs[48];  // 3 x 5 bits each, the top left one highest
uniform int glyph_count;
uniform int zoom;        // pixels per bit

layout(location = 0) out vec4 color;

bool glyph_bit(ivec2 place)
{
    int index = place.x / 4;
    ivec2 cell = ivec2(place.x % 4, 4 - place.y);
    if (index >= glyph_count || cell.x == 3 || cell.y < 0 || cell.y > 4) {
        return false;
    }
    return ((glyphs[index] >> (14 - 3 * cell.y - cell.x)) & 1) == 1;
}

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy) - corner;
    int text_height = 7 * zoom;
    vec3 shown = vec3(0.0);
    if (place.y >= text_height) {
        shown = scale_color((float(place.x) + 0.5) / float(width));
    } else if (place.y >= zoom && glyph_bit((place - zoom) / zoom)) {
        shown = vec3(1.0);
    }
    color = vec4(shown, 1.0);
}
