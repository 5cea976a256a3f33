// --deferred, second pass: what this pixel shows, from the G-buffer.
// needs: nothing
// offers: viewer_normal, relative_position, albedo

uniform sampler2D stored_position;
uniform sampler2D stored_normal;
uniform sampler2D stored_albedo;

vec3 relative_position =
    texelFetch(stored_position, ivec2(gl_FragCoord.xy), 0).xyz;
vec3 albedo = texelFetch(stored_albedo, ivec2(gl_FragCoord.xy), 0).rgb;

vec3 viewer_normal()
{
    return texelFetch(stored_normal, ivec2(gl_FragCoord.xy), 0).xyz;
}
